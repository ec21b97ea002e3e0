#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "common/base/temp_directory_test.h"
#include "common/rpc/security/tls_files.h"

namespace slicefarm::rpc {

/// A CA and certificates that it signs, made by deploy/dev-certs.sh.
class DevCerts {
 public:
  /// Makes a certificate for a role ("stage/motion"); `days` 0: it has expired.
  TlsFiles Make(const std::string& role, int days = 30) {
    const std::string command = fmt::format("{}/deploy/dev-certs.sh '{}' --days {} {}",
                                            SLICEFARM_SOURCE, path(), days, role);
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::string name = role;
    std::ranges::replace(name, '/', '-');
    return In(path() + "/" + name);
  }

  static TlsFiles In(const std::string& directory) {
    return {directory + "/cert.pem", directory + "/key.pem", directory + "/ca.pem"};
  }

  const std::string& path() const { return directory_.path(); }

 private:
  TempDirectory directory_;
};

/// A path that can be switched to another directory in one step, as when certificates are renewed.
class SwappedDirectory {
 public:
  explicit SwappedDirectory(const std::string& to) { PointTo(to); }

  void PointTo(const std::string& to) {
    std::filesystem::create_directory_symlink(std::filesystem::canonical(to), path() + ".new");
    std::filesystem::rename(path() + ".new", path());
  }

  std::string path() const { return directory_.path() + "/link"; }

 private:
  TempDirectory directory_;
};

}  // namespace slicefarm::rpc
