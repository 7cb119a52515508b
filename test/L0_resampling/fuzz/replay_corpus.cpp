// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Attacks the readers with every file of a folder, as libFuzzer once made them: replay_corpus
// FORMAT FOLDER

#include "attack_reader.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv)
{
  const auto format = argc == 3 ? l0_tool::format_of(std::string("points.") + argv[1])
                                : std::nullopt;
  if (!format)
  {
    std::cerr << "usage: replay_corpus FORMAT FOLDER" << std::endl;
    return 2;
  }
  std::size_t number_of_files = 0;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(argv[2]))
  {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file),
                                  std::istreambuf_iterator<char>()};
    std::cout << entry.path().filename().string()
              << std::endl; // the last one, should it be the last
    tool_test::attack_reader(*format, reinterpret_cast<const std::uint8_t*>(bytes.data()),
                             bytes.size());
    ++number_of_files;
  }
  std::cout << number_of_files << " files" << std::endl;
  return number_of_files > 0 ? 0 : 1;
}
