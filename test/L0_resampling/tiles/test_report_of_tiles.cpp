// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is reported of a cloud that is resampled tile by tile.

#include "tiles/report_of_tiles.h"

#include <CGAL/tags.h>

int main()
{
  using Tag = CGAL::Parallel_if_available_tag;
  test::check_report_of_tiles<Tag>(280, true); // memory holds all facts
  test::check_report_of_tiles<Tag>(170, true);
  return test::result();
}
