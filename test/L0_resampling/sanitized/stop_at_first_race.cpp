// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// Read by ThreadSanitizer as the program starts: else the child processes of the attack would go
/// on after a race, and end as if there was none.
extern "C" const char* __tsan_default_options() { return "halt_on_error=1"; }
