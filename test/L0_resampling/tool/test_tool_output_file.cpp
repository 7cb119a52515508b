// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The writer of l0_resample: a file is there as a whole or not at all.

#include "test_support.h"
#include "tool/test_tool_support.h"

#include "files/Output_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <thread>

#include <fcntl.h>
#include <poll.h>
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
    CHECK(folder.number_of_files()
          == 1); // the temporary is in the target's own folder, where it can be renamed
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
  CHECK(seen.status == OUTPUT_NOT_WRITTEN && seen.says("No space left on device")
        && seen.says(full));
  CHECK(std::filesystem::is_character_file(full));
}

// Without leave to replace, a file that came since stays.
void test_kept_file()
{
  const Scratch_folder folder;
  const std::string path = folder.file("out.ply");
  Output_file file(path, Existing_file::KEEP);
  file.write(new_content);
  write_bytes(path, old_content);
  const Failure_seen seen = failure_of([&]() { file.commit(); });
  CHECK(seen.status == OUTPUT_NOT_WRITTEN && seen.says("--force"));
  CHECK(read_bytes(path) == old_content);

  const std::string free_path = folder.file("free.ply");
  Output_file free_file(free_path, Existing_file::KEEP);
  free_file.write(new_content);
  free_file.commit();
  CHECK(read_bytes(free_path) == new_content);
}

void test_ways_to_a_file()
{
  const Scratch_folder folder;
  const std::string path = folder.file("out.ply"), link = folder.file("link.ply");
  std::filesystem::create_symlink("out.ply", link);
  CHECK(!would_replace_file(link) && !would_replace_file(path));
  write_all(link);
  CHECK(std::filesystem::is_symlink(link) && read_bytes(path) == new_content);
  CHECK(would_replace_file(link) && would_replace_file(path)
        && !would_replace_file(folder.file("")));
  CHECK(are_same_file(link, path) && are_same_file(folder.file("./none"), folder.file("none")));
  CHECK(!are_same_file(path, folder.file("none")) && !are_same_file("", ""));
  CHECK(are_same_file("-", "/dev/stdout") && !are_same_file("-", "/dev/stderr"));
  std::filesystem::create_directory_symlink("/dev", folder.file("devices"));
  CHECK(destination_of(folder.file("devices/fd/2")).descriptor == 2);
  CHECK(!destination_of("/proc/1/fd/2").descriptor);
}

// A descriptor that is open already is written to where it stands, and may be one that does not
// block.
void test_open_descriptors()
{
  const Scratch_folder folder;
  const int shared = open(folder.file("log").c_str(), O_RDWR | O_CREAT, 0600);
  const std::string path = "/dev/fd/" + std::to_string(shared);
  CHECK(write(shared, "old", 3) == 3);
  CHECK(!would_replace_file(path));
  write_all(path);
  CHECK(write(shared, "end", 3) == 3);
  CHECK(read_bytes(folder.file("log")) == old_content + new_content + "end");
  close(shared);
  CHECK(failure_of([&]() { write_all(path); }).says("Bad file descriptor"));
  CHECK(failure_of([&]() { check_writable(path, 0); }).status == OUTPUT_NOT_WRITTEN);

  int ends[2];
  CHECK(pipe2(ends, O_NONBLOCK) == 0);
  std::string received;
  std::thread reader([&]() {
    std::array<char, 1000> bytes;
    pollfd waiting = {ends[0], POLLIN, 0};
    while (received.size() < new_content.size() && poll(&waiting, 1, 10000) == 1)
      received.append(bytes.data(), std::size_t((std::max)(
                                      read(ends[0], bytes.data(), bytes.size()), ssize_t(0))));
  });
  CHECK(failure_of([&]() { write_all("/dev/fd/" + std::to_string(ends[1])); }).status == 0);
  reader.join();
  CHECK(received == new_content);
  close(ends[0]);
  close(ends[1]);
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
  test_kept_file();
  test_ways_to_a_file();
  test_open_descriptors();
  test_failures();
  return test::result();
}
