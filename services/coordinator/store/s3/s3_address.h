#pragma once

#include <string>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Where a bucket is, and what of it is ours.
struct S3Address {
  std::string endpoint;     ///< `https://HOST` or `http://HOST:PORT`
  std::string path_prefix;  ///< of a path: `/BUCKET`, or empty if the bucket is in the host's name
  std::string key_prefix;   ///< of keys: empty, or `PREFIX/`

  /// The URL of an object. Bytes of its path that a URL does not take become %XX.
  std::string UrlOf(const std::string& key) const;
};

/// Of `http[s]://HOST[:PORT]/BUCKET[/PREFIX]`; `bucket_in_host`: HOST is the bucket's own, and the
/// path the prefix alone. Errors: InvalidArgument.
absl::StatusOr<S3Address> ParseS3Address(const std::string& url, bool bucket_in_host = false);

}  // namespace slicefarm::coordinator
