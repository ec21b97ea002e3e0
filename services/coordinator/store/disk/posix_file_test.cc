#include "services/coordinator/store/disk/posix_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"

namespace slicefarm::coordinator::posix_file_test {
namespace {

TEST(PosixFile, WritesAndReads) {
  TempDirectory directory;
  const auto file = PosixFile::OpenToWrite(directory.path() + "/a");
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_TRUE(file->WriteAt(0, "0123456789").ok());
  ASSERT_TRUE(file->WriteAt(4, "xy").ok());
  ASSERT_TRUE(file->Truncate(8).ok());
  ASSERT_TRUE(file->Sync().ok());
  EXPECT_EQ(*file->Size(), 8);
  EXPECT_EQ(*file->ReadAt(2, 100), "23xy67");
  EXPECT_EQ(*file->ReadAt(8, 100), "");
  ASSERT_TRUE(file->SyncAnew().ok());
  EXPECT_EQ(*file->ReadAt(0, 100), "0123xy67");
}

TEST(PosixFile, ErrorsNameThePath) {
  TempDirectory directory;
  const absl::Status missing = PosixFile::OpenToRead(directory.path() + "/no").status();
  EXPECT_TRUE(absl::IsNotFound(missing));
  EXPECT_THAT(missing.message(), testing::HasSubstr("/no"));
}

TEST(PosixFile, AFullDiskIsToldAsSuch) {
  const auto full = PosixFile::OpenToWrite("/dev/full");
  ASSERT_TRUE(full.ok()) << full.status();
  const absl::Status status = full->WriteAt(0, "x");
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kDiskFull);
}

TEST(PosixFile, RenamesAndRemoves) {
  TempDirectory directory;
  const std::string a = directory.path() + "/a", b = directory.path() + "/b";
  ASSERT_TRUE(PosixFile::OpenToWrite(a)->WriteAt(0, "x").ok());
  ASSERT_TRUE(RenameFile(a, b).ok());
  EXPECT_TRUE(absl::IsNotFound(PosixFile::OpenToRead(a).status()));
  EXPECT_TRUE(PosixFile::OpenToRead(b).ok());
  EXPECT_TRUE(RemoveFile(b).ok());
  EXPECT_TRUE(RemoveFile(b).ok());
  EXPECT_FALSE(RenameFile(a, b).ok());
}

TEST(PosixFile, TouchesWhatIsThere) {
  namespace fs = std::filesystem;
  TempDirectory directory;
  const std::string path = directory.path() + "/a";
  ASSERT_TRUE(PosixFile::OpenToWrite(path).ok());
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(9));
  ASSERT_TRUE(TouchFile(path).ok());
  EXPECT_GT(fs::last_write_time(path), fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_TRUE(TouchFile(path + "b").ok());
  EXPECT_FALSE(fs::exists(path + "b"));
}

TEST(MakeDirectory, MakesParents) {
  TempDirectory directory;
  EXPECT_TRUE(MakeDirectory(directory.path() + "/x/y/z").ok());
  EXPECT_TRUE(MakeDirectory(directory.path() + "/x/y/z").ok());
  EXPECT_TRUE(std::filesystem::is_directory(directory.path() + "/x/y/z"));
}

}  // namespace
}  // namespace slicefarm::coordinator::posix_file_test
