#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace slicefarm {

/// Directory for one test, removed at its end. `parent` ends with a slash.
class TempDirectory {
 public:
  explicit TempDirectory(const std::string& parent = testing::TempDir()) {
    std::string pattern = parent + "slicefarm-XXXXXX";
    path_ = mkdtemp(pattern.data());
  }
  ~TempDirectory() { std::filesystem::remove_all(path_); }
  TempDirectory(const TempDirectory&) = delete;
  TempDirectory& operator=(const TempDirectory&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace slicefarm
