#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/s3/s3_client.h"

namespace slicefarm::coordinator {

/// Options of the bucket for blobs.
struct S3Flags {
  std::string url;  ///< address of the bucket (s3_address.h); empty: no bucket
  bool bucket_in_host = false;
  std::string region = "us-east-1";
  std::string ca_file;
  std::string credentials_file;  ///< file of the credentials; empty: they are in the environment
};

/// Adds the options to `app`.
void AddS3Flags(CLI::App& app, S3Flags* flags);

/// Reads credentials from JSON: `{"access_key": "...", "secret_key": "..."}`, and optionally
/// `session_token`. Errors: InvalidArgument.
absl::StatusOr<S3Credentials> ParseS3Credentials(const std::string& text);

/// Reads credentials from the file. Errors: InvalidArgument, also if the file cannot be read.
absl::StatusOr<S3Credentials> ReadS3Credentials(const std::string& path);

/// Returns the credentials from the environment variables AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY
/// and, if it is set, AWS_SESSION_TOKEN. Errors: InvalidArgument if one of the first two is not
/// set.
absl::StatusOr<S3Credentials> S3CredentialsOfEnvironment();

/// Creates a client of the bucket. Errors: InvalidArgument.
absl::StatusOr<std::shared_ptr<S3Client>> MakeS3Client(const S3Flags& flags,
                                                       S3CredentialsNow credentials);

}  // namespace slicefarm::coordinator
