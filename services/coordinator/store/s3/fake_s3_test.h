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

/// For tests: tests/fake_s3.py as a process of its own, as long as it is in scope. Dies if it does
/// not start.
class FakeS3 {
 public:
  FakeS3() {
    // In a shell of its own, so that it can be ended by its id.
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

  std::string Url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/farm/prefix"; }

  /// Of a client that gives up soon.
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

  std::shared_ptr<S3Client> Client(const std::string& secret = "secret") const {
    return std::make_shared<S3Client>(Options(secret));
  }

  /// From now on the next `times` requests of this method fail so; those before it do not any more.
  void Fail(const std::string& method, const std::string& kind, int times) const {
    const std::string rule = "[{\"method\": \"" + method + "\", \"kind\": \"" + kind +
                             "\", \"times\": " + std::to_string(times) + "}]";
    const std::string path = directory_.path() + "/.faults";
    std::ofstream(path + ".new") << rule;
    std::filesystem::rename(path + ".new", path);
  }

  const std::string& directory() const { return directory_.path(); }

 private:
  TempDirectory directory_;
  FILE* output_ = nullptr;
  int pid_ = -1;
  int port_ = 0;
};

}  // namespace slicefarm::coordinator
