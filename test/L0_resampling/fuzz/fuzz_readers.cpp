// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers under libFuzzer. "--format=ply" chooses one of ply, off, xyz, pcd, npy, csv, obj,
// las; the other arguments are libFuzzer's.

#include "attack_reader.h"

#include <cstring>

namespace {

l0_tool::File_format format;

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
  const char option[] = "--format=";
  for (int i = 1; i < *argc; ++i)
    if (std::strncmp((*argv)[i], option, sizeof(option) - 1) == 0)
      if (const auto named = l0_tool::format_of(std::string("points.")
                                                + ((*argv)[i] + sizeof(option) - 1)))
      {
        format = *named;
        return 0;
      }
  std::cerr << "--format=NAME expected" << std::endl;
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  tool_test::attack_reader(format, bytes, size);
  return 0;
}
