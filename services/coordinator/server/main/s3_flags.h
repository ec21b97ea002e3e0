#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/s3/s3_client.h"

namespace slicefarm::coordinator {

/// What a program can be told of the bucket for its blobs.
struct S3Flags {
  std::string url;  ///< empty: there is none
  bool bucket_in_host = false;
  std::string region = "us-east-1";
  std::string ca_file;
  std::string credentials_file;  ///< empty: the environment has them
};

void AddS3Flags(CLI::App& app, S3Flags* flags);

/// Of a JSON file `{"access_key": "...", "secret_key": "..."}`, and `session_token` if there is
/// one. Errors: InvalidArgument.
absl::StatusOr<S3Credentials> ParseS3Credentials(const std::string& text);

/// Of the file with this path. Errors: InvalidArgument, also if it cannot be read.
absl::StatusOr<S3Credentials> ReadS3Credentials(const std::string& path);

/// AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY and, if it is set, AWS_SESSION_TOKEN. Errors:
/// InvalidArgument.
absl::StatusOr<S3Credentials> S3CredentialsOfEnvironment();

/// Errors: InvalidArgument.
absl::StatusOr<std::shared_ptr<S3Client>> MakeS3Client(const S3Flags& flags,
                                                       S3CredentialsNow credentials);

}  // namespace slicefarm::coordinator
