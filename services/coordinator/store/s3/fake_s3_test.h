#pragma once

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/s3/s3_client.h"

namespace slicefarm::coordinator {

/// Process of tests/fake_s3.py for tests; it ends with this object. Aborts if the process does not
/// start.
class FakeS3 {
 public:
  FakeS3() {
    // The shell prints its process id, so that the process can be ended.
    const std::string line = "echo $$; exec python3 '" SLICEFARM_SOURCE
                             "/tests/fake_s3.py' --dir '" +
                             directory_.path() + "'";
    output_ = popen(line.c_str(), "r");
    if (output_ == nullptr || std::fscanf(output_, "%d %d", &pid_, &port_) != 2) std::abort();
  }
  ~FakeS3() {
    kill(pid_, SIGKILL);
    pclose(output_);
  }
  FakeS3(const FakeS3&) = delete;
  FakeS3& operator=(const FakeS3&) = delete;

  /// Returns the URL of the bucket with the prefix.
  std::string Url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/farm/prefix"; }

  /// Returns options of a client with short time limits.
  S3Options Options(const std::string& secret = "secret") const {
    const auto credentials =
        std::make_shared<const S3Credentials>(S3Credentials{"access", secret, ""});
    S3Options options;
    options.address = *ParseS3Address(Url());
    options.credentials = [credentials] { return credentials; };
    options.http.stall = std::chrono::seconds(1);
    options.first_pause = std::chrono::milliseconds(1);
    return options;
  }

  /// Returns a client with the options of Options.
  std::shared_ptr<S3Client> Client(const std::string& secret = "secret") const {
    return std::make_shared<S3Client>(Options(secret));
  }

  /// Makes the next `times` requests of this method fail with this kind of fault. Ends earlier
  /// faults.
  void Fail(const std::string& method, const std::string& kind, int times) const {
    const std::string rule = "[{\"method\": \"" + method + "\", \"kind\": \"" + kind +
                             "\", \"times\": " + std::to_string(times) + "}]";
    const std::string path = directory_.path() + "/.faults";
    std::ofstream(path + ".new") << rule;
    std::filesystem::rename(path + ".new", path);
  }

  /// Returns the directory with the objects.
  const std::string& directory() const { return directory_.path(); }

 private:
  TempDirectory directory_;
  FILE* output_ = nullptr;
  int pid_ = -1;
  int port_ = 0;
};

}  // namespace slicefarm::coordinator
