#pragma once

#include <string>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Address of a bucket, and the prefix of this farm's keys.
struct S3Address {
  std::string endpoint;  ///< `https://HOST` or `http://HOST:PORT`
  /// Prefix of paths: `/BUCKET`, or empty if the host's name contains the bucket.
  std::string path_prefix;
  std::string key_prefix;  ///< prefix of keys: empty, or `PREFIX/`

  /// Returns the URL of an object. Bytes that are not allowed in a URL become %XX.
  std::string UrlOf(const std::string& key) const;
};

/// Reads an address `http[s]://HOST[:PORT]/BUCKET[/PREFIX]`. `bucket_in_host`: the name HOST
/// identifies the bucket, and the path is only PREFIX. Errors: InvalidArgument.
absl::StatusOr<S3Address> ParseS3Address(const std::string& url, bool bucket_in_host = false);

}  // namespace slicefarm::coordinator
