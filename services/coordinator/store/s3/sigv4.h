#pragma once

#include <string>
#include <utility>
#include <vector>

namespace slicefarm::coordinator {

/// Who asks a bucket for something.
struct S3Credentials {
  std::string access_key;
  std::string secret_key;
  std::string session_token = {};  ///< of keys that are for some time; empty: none
};

/// An HTTP request that is to be signed.
struct S3Request {
  std::string method;
  std::string path;                                             ///< as UriEncoded made it
  std::vector<std::pair<std::string, std::string>> query = {};  ///< not encoded
  /// All that are signed, `host` among them; names in lower case.
  std::vector<std::pair<std::string, std::string>> headers;
  std::string payload_sha256;
};

/// Bytes that an URI does not take as they are become %XX; `/` stays if it parts a path.
std::string UriEncoded(std::string_view text, bool is_path);

/// The header `authorization` of a request. `time`: YYYYMMDDThhmmssZ, the same as in the header
/// `x-amz-date`. Source: AWS Signature Version 4 (AWS4-HMAC-SHA256), "Authenticating Requests:
/// Using the Authorization Header", Amazon S3 API reference.
std::string S3Authorization(const S3Request& request, const S3Credentials& credentials,
                            const std::string& region, const std::string& time);

}  // namespace slicefarm::coordinator
