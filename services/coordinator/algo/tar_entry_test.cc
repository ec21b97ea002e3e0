#include "services/coordinator/algo/tar_entry.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "common/base/temp_directory_test.h"

namespace slicefarm::coordinator::tar_entry_test {
namespace {

std::string ReadFile(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// Reads the archive with the tar program of the system.
TEST(TarEntry, TarReadsWhatWasWritten) {
  const TempDirectory directory;
  const std::string large(100'000, 'x');
  const std::string name(100, 'n');
  std::ofstream archive(directory.path() + "/a.tar", std::ios::binary);
  const auto add = [&](const std::string& file, const std::string& content) {
    archive << TarHeader(file, std::ssize(content), 1'700'000'000) << content
            << TarPadding(std::ssize(content));
  };
  add("jobs/one.json", "{}");
  add("blobs/empty", "");
  add("blobs/block", large.substr(0, 512));
  add("blobs/large", large);
  add(name, "long name");
  archive << TarEnd();
  archive.close();
  ASSERT_EQ(std::system(
                ("tar -xf '" + directory.path() + "/a.tar' -C '" + directory.path() + "'").c_str()),
            0);
  EXPECT_EQ(ReadFile(directory.path() + "/jobs/one.json"), "{}");
  EXPECT_EQ(ReadFile(directory.path() + "/blobs/empty"), "");
  EXPECT_EQ(ReadFile(directory.path() + "/blobs/block"), large.substr(0, 512));
  EXPECT_EQ(ReadFile(directory.path() + "/blobs/large"), large);
  EXPECT_EQ(ReadFile(directory.path() + "/" + name), "long name");
}

TEST(TarEntry, PaddingFillsABlock) {
  for (const int64_t size : {0, 1, 511, 512, 513, 1024})
    EXPECT_EQ((size + std::ssize(TarPadding(size))) % 512, 0) << size;
  EXPECT_EQ(TarPadding(512), "");
}

}  // namespace
}  // namespace slicefarm::coordinator::tar_entry_test
