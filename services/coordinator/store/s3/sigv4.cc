#include "services/coordinator/store/s3/sigv4.h"

#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "absl/strings/ascii.h"
#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "common/base/sha256.h"

namespace slicefarm::coordinator {
namespace {

constexpr const char* kAlgorithm = "AWS4-HMAC-SHA256";

using Pairs = std::vector<std::pair<std::string, std::string>>;

bool IsUnreserved(char c) {
  return absl::ascii_isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("-_.~").find(c) != std::string_view::npos;
}

std::string Hmac(const std::string& key, std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest = {};
  unsigned int size = 0;
  HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()),
       reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data(), &size);
  return {reinterpret_cast<const char*>(digest.data()), size};
}

std::string CanonicalQuery(const S3Request& request) {
  Pairs encoded;
  for (const auto& [name, value] : request.query)
    encoded.emplace_back(UriEncoded(name, false), UriEncoded(value, false));
  std::ranges::sort(encoded);
  return absl::StrJoin(encoded, "&", absl::PairFormatter("="));
}

Pairs Sorted(Pairs headers) {
  std::ranges::sort(headers);
  return headers;
}

std::string CanonicalRequest(const S3Request& request, const Pairs& headers,
                             const std::string& signed_names) {
  std::string text =
      absl::StrCat(request.method, "\n", request.path, "\n", CanonicalQuery(request), "\n");
  for (const auto& [name, value] : headers) absl::StrAppend(&text, name, ":", value, "\n");
  absl::StrAppend(&text, "\n", signed_names, "\n", request.payload_sha256);
  return text;
}

}  // namespace

std::string UriEncoded(std::string_view text, bool is_path) {
  std::string encoded;
  for (const char c : text) {
    if (IsUnreserved(c) || (is_path && c == '/')) {
      encoded += c;
    } else {
      absl::StrAppendFormat(&encoded, "%%%02X", static_cast<unsigned char>(c));
    }
  }
  return encoded;
}

std::string S3Authorization(const S3Request& request, const S3Credentials& credentials,
                            const std::string& region, const std::string& time) {
  const std::string day = time.substr(0, 8);
  const Pairs headers = Sorted(request.headers);
  const std::string names = absl::StrJoin(
      headers, ";", [](std::string* out, const auto& header) { *out += header.first; });
  const std::string scope = absl::StrCat(day, "/", region, "/s3/aws4_request");
  const std::string to_sign = absl::StrCat(kAlgorithm, "\n", time, "\n", scope, "\n",
                                           Sha256Hex(CanonicalRequest(request, headers, names)));
  const std::string of_day = Hmac("AWS4" + credentials.secret_key, day);
  const std::string key = Hmac(Hmac(Hmac(of_day, region), "s3"), "aws4_request");
  return absl::StrCat(kAlgorithm, " Credential=", credentials.access_key, "/", scope,
                      ",SignedHeaders=", names,
                      ",Signature=", absl::BytesToHexString(Hmac(key, to_sign)));
}

}  // namespace slicefarm::coordinator
