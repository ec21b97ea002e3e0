// Tests of the simulated disk of the fault tests. They also check that it intercepts all relevant
// calls.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>

#include "absl/strings/str_cat.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/faults/crash_disk_test.h"
#include "services/coordinator/store/faults/disk_calls_test.h"

namespace slicefarm::coordinator::disk_faults_test {
namespace {

namespace fs = std::filesystem;

class DiskFaultsTest : public testing::Test {
 protected:
  int OpenFile(const std::string& name) {
    return open((root_ + "/" + name).c_str(), O_RDWR | O_CREAT, 0600);
  }
  void SyncFolder(const std::string& name) {
    const int fd = open((root_ + name).c_str(), O_RDONLY);
    EXPECT_EQ(fsync(fd), 0);
    close(fd);
  }
  /// Returns the content of file `name` after a power cut; "-" if the file does not exist.
  std::string After(const std::string& name, Leftover leftover, uint64_t seed = 1) {
    const std::string image = absl::StrCat(directory_.path(), "/image", images_++);
    std::mt19937_64 random(seed);
    disk_->now().WriteImage(image, leftover, random);
    std::ifstream file(image + "/" + name, std::ios::binary);
    if (!file.is_open()) return "-";
    return {std::istreambuf_iterator<char>(file), {}};
  }

  static std::unique_ptr<DiskCalls> Watch(const std::string& root) {
    fs::create_directory(root);
    return std::make_unique<DiskCalls>(root);
  }

  TempDirectory directory_;
  const std::string root_ = directory_.path() + "/root";
  std::unique_ptr<DiskCalls> disk_ = Watch(root_);
  int images_ = 0;
};

TEST_F(DiskFaultsTest, WhatIsNotSyncedMayBeLost) {
  const int fd = OpenFile("a");
  EXPECT_EQ(pwrite(fd, "old", 3, 0), 3);
  EXPECT_EQ(After("a", Leftover::kNothing), "-");
  EXPECT_EQ(After("a", Leftover::kEverything), "old");
  EXPECT_EQ(fsync(fd), 0);
  EXPECT_EQ(After("a", Leftover::kNothing), "-") << "its name is not";
  SyncFolder("");
  EXPECT_EQ(After("a", Leftover::kNothing), "old");
  EXPECT_EQ(pwrite(fd, "new", 3, 0), 3);
  EXPECT_EQ(After("a", Leftover::kNothing), "old");
  EXPECT_EQ(ftruncate(fd, 1), 0);
  EXPECT_EQ(After("a", Leftover::kEverything), "n");
  close(fd);
}

TEST_F(DiskFaultsTest, WritesAreTornAtSectors) {
  const int fd = OpenFile("a");
  SyncFolder("");
  const std::string bytes(2000, 'x');
  EXPECT_EQ(pwrite(fd, bytes.data(), bytes.size(), 100), std::ssize(bytes));
  std::set<std::string> seen;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const std::string left = After("a", Leftover::kAnything, seed);
    EXPECT_EQ(left, After("a", Leftover::kAnything, seed)) << "the same seed, the same bytes";
    for (size_t i = 1; i < left.size(); ++i) {
      EXPECT_TRUE(left[i] == left[i - 1] || i % 512 == 0 || i == 100) << i;
    }
    seen.insert(left);
  }
  EXPECT_GT(seen.size(), 10u);
  EXPECT_TRUE(seen.contains(std::string(2100, '\0'))) << "the size without the bytes";
  close(fd);
}

TEST_F(DiskFaultsTest, ARenameIsTwoNames) {
  ASSERT_EQ(mkdir((root_ + "/to").c_str(), 0700), 0);
  const int fd = OpenFile("a");
  EXPECT_EQ(pwrite(fd, "x", 1, 0), 1);
  EXPECT_EQ(fsync(fd), 0);
  close(fd);
  SyncFolder("");
  ASSERT_EQ(rename((root_ + "/a").c_str(), (root_ + "/to/b").c_str()), 0);
  EXPECT_EQ(After("a", Leftover::kNothing), "x");
  EXPECT_EQ(After("to/b", Leftover::kNothing), "-");
  SyncFolder("/to");
  EXPECT_EQ(After("a", Leftover::kNothing), "x") << "until its folder is synced, too";
  EXPECT_EQ(After("to/b", Leftover::kNothing), "x");
  SyncFolder("");
  EXPECT_EQ(After("a", Leftover::kNothing), "-");
}

TEST_F(DiskFaultsTest, AnFsyncThatFailsForgets) {
  const int fd = OpenFile("a");
  SyncFolder("");
  EXPECT_EQ(pwrite(fd, "abc", 3, 0), 3);
  disk_->FailAt(std::ssize(disk_->calls()), Fault::kEio, /*lasts=*/false);
  EXPECT_EQ(fsync(fd), -1);
  EXPECT_EQ(errno, EIO);
  EXPECT_TRUE(disk_->struck());
  EXPECT_EQ(pwrite(fd, "B", 1, 1), 1);
  EXPECT_EQ(fsync(fd), 0);
  EXPECT_EQ(After("a", Leftover::kNothing), std::string("\0B", 2));
  close(fd);
}

TEST_F(DiskFaultsTest, CallsFailAsTheyCan) {
  const int fd = OpenFile("a");
  const int64_t next = std::ssize(disk_->calls());
  disk_->FailAt(next, Fault::kShort, /*lasts=*/true);
  EXPECT_EQ(pwrite(fd, "abcd", 4, 0), 2);
  EXPECT_EQ(pwrite(fd, "cd", 2, 2), -1);
  EXPECT_EQ(errno, ENOSPC);
  disk_->Heal();
  EXPECT_EQ(pwrite(fd, "cd", 2, 2), 2);
  disk_->FailAt(next + 3, Fault::kEintr, /*lasts=*/false);
  EXPECT_EQ(unlink((root_ + "/a").c_str()), 0) << "which no signal interrupts";
  close(fd);
}

TEST_F(DiskFaultsTest, OtherDirectoriesAreLeftAlone) {
  disk_->FailAt(0, Fault::kEio, /*lasts=*/true);
  const std::string other = directory_.path() + "/root2";
  EXPECT_EQ(mkdir(other.c_str(), 0700), 0);
  EXPECT_TRUE(disk_->calls().empty());
}

/// Returns the undefined symbols of a library or object file, from the output of nm.
std::set<std::string> UndefinedSymbols(const std::string& arguments) {
  const std::string command = absl::StrCat("nm --undefined-only ", arguments);
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  std::set<std::string> symbols;
  std::array<char, 4096> line;
  while (fgets(line.data(), line.size(), output.get()) != nullptr) {
    std::istringstream words{std::string(line.data())};
    const std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
    if (!all.empty()) symbols.insert(all.back().substr(0, all.back().find('@')));
  }
  return symbols;
}

/// Functions of the C library that open or change files.
const std::set<std::string> kFileFunctions = {"__open64_2",
                                              "__open_2",
                                              "__pread64_chk",
                                              "__pread_chk",
                                              "__read_chk",
                                              "copy_file_range",
                                              "creat",
                                              "creat64",
                                              "fallocate",
                                              "fallocate64",
                                              "fdatasync",
                                              "fopen",
                                              "fopen64",
                                              "fsync",
                                              "ftruncate",
                                              "ftruncate64",
                                              "link",
                                              "linkat",
                                              "mkdir",
                                              "mkdirat",
                                              "mkostemp",
                                              "mkstemp",
                                              "mkstemp64",
                                              "open",
                                              "open64",
                                              "openat",
                                              "openat64",
                                              "pread",
                                              "pread64",
                                              "preadv",
                                              "pwrite",
                                              "pwrite64",
                                              "pwritev",
                                              "read",
                                              "readv",
                                              "remove",
                                              "rename",
                                              "renameat",
                                              "renameat2",
                                              "rmdir",
                                              "sendfile",
                                              "symlink",
                                              "syncfs",
                                              "truncate",
                                              "truncate64",
                                              "unlink",
                                              "unlinkat",
                                              "utimensat",
                                              "write",
                                              "writev",
                                              "posix_fallocate",
                                              "posix_fallocate64",
                                              "sync_file_range"};

// A new call in the stores must not bypass the fault tests.
TEST(DiskCalls, StandsBeforeAllThatTheStoresAndSqliteCall) {
  const std::vector<std::string> functions = DiskCalls::Functions();
  for (const std::string& arguments :
       {std::string(STORE_LIBRARY), absl::StrCat("--dynamic ", SQLITE_LIBRARY)}) {
    std::set<std::string> calls;
    for (const std::string& symbol : UndefinedSymbols(arguments)) {
      if (kFileFunctions.contains(symbol)) calls.insert(symbol);
    }
    EXPECT_THAT(calls, testing::SizeIs(testing::Gt(5))) << arguments;
    for (const std::string& call : calls) EXPECT_THAT(functions, testing::Contains(call));
  }
}

// The C++ library calls the C library internally, where these calls cannot be intercepted.
TEST(DiskCalls, TheStoresChangeNoFilesByTheCxxLibrary) {
  const std::set<std::string> symbols = UndefinedSymbols(STORE_LIBRARY);
  ASSERT_FALSE(symbols.empty());
  for (const std::string& symbol : symbols) {
    for (const char* change : {"6remove", "10remove_all", "6rename", "16create_directory",
                               "18create_directories", "9copy_file", "11resize_file"}) {
      EXPECT_FALSE(symbol.starts_with(absl::StrCat("_ZNSt10filesystem", change))) << symbol;
    }
    EXPECT_THAT(symbol, testing::Not(testing::HasSubstr("basic_ofstream")));
    EXPECT_THAT(symbol, testing::Not(testing::HasSubstr("basic_filebuf")));
  }
}

}  // namespace
}  // namespace slicefarm::coordinator::disk_faults_test
