// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The writer of l0_resample: a file is there as a whole or not at all.

#include "test_support.h"
#include "test_tool_support.h"

#include "Output_file.h"

#include <string>

#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace l0_tool;
using namespace tool_test;

const std::string old_content = "old", new_content(1000000, 'n'); // longer than any buffer

void write_all(const std::string& path)
{
  Output_file file(path);
  file.write(new_content);
  file.commit();
}

mode_t mode_of(const std::string& path)
{
  struct stat status;
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777 : 0;
}

void test_commit()
{
  const Scratch_folder folder;
  const std::string path = folder.file("a b\xc3\xa4.ply");
  umask(027);
  write_all(path);
  CHECK(read_bytes(path) == new_content);
  CHECK(mode_of(path) == 0640);
  CHECK(folder.number_of_files() == 1);

  write_bytes(path, old_content);
  chmod(path.c_str(), 0604);
  write_all(path);
  CHECK(read_bytes(path) == new_content);
  CHECK(mode_of(path) == 0604);
  CHECK(folder.number_of_files() == 1);

  // a name without a folder
  CHECK(chdir(std::filesystem::path(path).parent_path().c_str()) == 0);
  write_all("here.ply");
  CHECK(read_bytes(folder.file("here.ply")) == new_content);
  CHECK(chdir("/") == 0);
}

void test_no_commit()
{
  const Scratch_folder folder;
  const std::string path = folder.file("out.ply");
  {
    Output_file file(path);
    file.write(new_content);
    CHECK(folder.number_of_files() == 1); // the temporary is in the target's own folder, where it can be renamed
  }
  CHECK(folder.number_of_files() == 0);

  write_bytes(path, old_content);
  {
    Output_file file(path);
    file.write(new_content);
    CHECK(read_bytes(path) == old_content);
  }
  CHECK(read_bytes(path) == old_content);
  CHECK(folder.number_of_files() == 1);
}

void test_links_and_devices()
{
  const Scratch_folder folder, other;
  write_bytes(other.file("real.ply"), old_content);
  const std::string link = folder.file("link.ply");
  CHECK(symlink(other.file("real.ply").c_str(), link.c_str()) == 0);
  write_all(link);
  CHECK(std::filesystem::is_symlink(link));
  CHECK(read_bytes(other.file("real.ply")) == new_content);

  // /dev/full takes no byte; it must be neither replaced nor believed
  const std::string full = folder.file("full.ply");
  CHECK(symlink("/dev/full", full.c_str()) == 0);
  check_writable(full, 1000000000000000000);
  const Failure_seen seen = failure_of([&]() { write_all(full); });
  CHECK(seen.status == OUTPUT_NOT_WRITTEN && seen.says("No space left on device") && seen.says(full));
  CHECK(std::filesystem::is_character_file(full));
}

void test_failures()
{
  const Scratch_folder folder;
  const std::string no_folder = folder.file("missing/out.ply");
  CHECK(failure_of([&]() { write_all(no_folder); }).status == OUTPUT_NOT_WRITTEN);
  CHECK(failure_of([&]() { check_writable(no_folder, 0); }).says("No such file or directory"));
  CHECK(failure_of([&]() { check_writable(folder.file(""), 0); }).says("directory"));

  const std::string path = folder.file("out.ply");
  CHECK(failure_of([&]() { check_writable(path, 1000); }).status == 0);
  const Failure_seen seen = failure_of([&]() { check_writable(path, 1000000000000000000); });
  CHECK(seen.status == OUTPUT_NOT_WRITTEN && seen.says("the disk has room for"));
  CHECK(folder.number_of_files() == 0);

  // A folder that appears where the file should go: nothing is left behind.
  {
    Output_file file(path);
    file.write(new_content);
    std::filesystem::create_directories(path + "/inside");
    CHECK(failure_of([&]() { file.commit(); }).status == OUTPUT_NOT_WRITTEN);
  }
  CHECK(folder.number_of_files() == 1);
}

} // namespace

int main()
{
  test_commit();
  test_no_commit();
  test_links_and_devices();
  test_failures();
  return test::result();
}
