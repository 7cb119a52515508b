// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests of wrong and of damaged files share.

#ifndef L0_RESAMPLE_TEST_TOOL_HOSTILE_H
#define L0_RESAMPLE_TEST_TOOL_HOSTILE_H

#include "test_support.h"
#include "tool/test_tool_allocations.h"
#include "tool/test_tool_reading.h"

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

namespace tool_test {

/// The file is refused with this reason, whether much is asked for or little, and with no more
/// memory than the reader's fixed buffer, and what a message takes.
/// \param expected a part of the message
/// \param everything what can be asked for
inline void check_refusal(const std::string& extension, const std::string& bytes,
                          const std::string& expected, const l0_tool::Read_options& everything)
{
  const std::string path = scratch.file("hostile" + extension);
  write_bytes(path, bytes);
  for (const l0_tool::Read_options& options : {l0_tool::Read_options(), everything})
  {
    forget_allocations();
    const Failure_seen seen = failure_of(
      [&]() { l0_tool::read_points(path, *l0_tool::format_of(path), options); });
    if (!CHECK(seen.status == l0_tool::INPUT_REFUSED && seen.says(expected)
               && seen.says(path + ": ")))
      std::cerr << "  expected \"" << expected << "\", found status " << seen.status << ", \""
                << seen.message << "\"\n";
    CHECK(seen.message.find('\n') == std::string::npos);
    if (!CHECK(maximum_allocation() <= maximum_memory_of_a_refusal))
      std::cerr << "  " << maximum_allocation() << " bytes allocated for \"" << expected << "\"\n";
  }
}

/// Reads files of which some bytes were changed: each gives finite points or is refused.
class Damaged_files
{
  std::size_t m_wrong = 0, m_read_well = 0, m_number = 0;

public:
  Damaged_files() { forget_allocations(); }

  /// \param read gives the points of one
  template <typename Read>
  void add(const Read& read)
  {
    ++m_number;
    const Failure_seen seen = failure_of([&]() {
      const l0_tool::Point_cloud cloud = read();
      ++m_read_well;
      for (const l0_tool::Point& p : cloud.points)
        m_wrong += !std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z());
      m_wrong += !cloud.normals.empty() && cloud.normals.size() != cloud.points.size();
    });
    m_wrong += seen.status != 0 && seen.status != l0_tool::INPUT_REFUSED;
  }

  void check() const
  {
    CHECK(m_wrong == 0);
    // the changes did reach both
    CHECK(m_read_well > m_number / 16 && m_number - m_read_well > m_number / 16);
    CHECK(maximum_allocation() <= maximum_memory_of_a_refusal);
  }
};

} // namespace tool_test

#endif // L0_RESAMPLE_TEST_TOOL_HOSTILE_H
