#include "services/coordinator/store/s3/s3_address.h"

#include <curl/curl.h>
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "absl/strings/string_view.h"

namespace slicefarm::coordinator {
namespace {

// A key has at most 1024 bytes, of which the store needs less than 200.
constexpr size_t kMostPrefix = 512;

/// Returns true if the text needs no escaping in a URL and is safe as a part of a path.
bool IsPlain(std::string_view part) {
  return !part.empty() && part != "." && part != ".." && std::ranges::all_of(part, [](char c) {
    return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
  });
}

bool IsHost(std::string_view host) {
  return !host.empty() && std::ranges::all_of(host, [](char c) {
    return absl::ascii_isalnum(static_cast<unsigned char>(c)) ||
           std::string_view("-.:[]").find(c) != std::string_view::npos;
  });
}

/// Returns true if all parts of a path are plain. `path` has no slash at its beginning and end.
bool IsPlainPath(std::string_view path) {
  while (!path.empty()) {
    const size_t end = std::min(path.find('/'), path.size());
    if (!IsPlain(path.substr(0, end))) return false;
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return true;
}

/// Returns a part of a path, escaped for a URL.
std::string Escaped(absl::string_view part) {
  if (part.empty()) return {};  // libcurl treats the length 0 as unknown
  const std::unique_ptr<char, decltype(&curl_free)> escaped(
      curl_easy_escape(nullptr, part.data(), static_cast<int>(part.size())), &curl_free);
  return escaped.get();
}

}  // namespace

std::string S3Address::UrlOf(const std::string& key) const {
  const std::string path = path_prefix + "/" + key_prefix + key;
  return endpoint +
         absl::StrJoin(absl::StrSplit(path, '/'), "/",
                       [](std::string* url, absl::string_view part) { *url += Escaped(part); });
}

absl::StatusOr<S3Address> ParseS3Address(const std::string& url, bool bucket_in_host) {
  const auto bad = [&](std::string_view why) {
    return absl::InvalidArgumentError(
        fmt::format("the address of a bucket is http[s]://HOST[:PORT]/BUCKET[/PREFIX]: {}", why));
  };
  const size_t scheme = url.find("://");
  if (scheme == std::string::npos ||
      (url.substr(0, scheme) != "https" && url.substr(0, scheme) != "http"))
    return bad("it begins with http:// or https://");
  const std::string_view rest = std::string_view(url).substr(scheme + 3);
  const size_t slash = std::min(rest.find('/'), rest.size());
  const std::string_view host = rest.substr(0, slash);
  if (!IsHost(host)) return bad("the host is missing, or has other characters");
  std::string_view path = rest.substr(slash);
  while (path.starts_with('/')) path.remove_prefix(1);
  while (path.ends_with('/')) path.remove_suffix(1);
  if (path.size() > kMostPrefix || !IsPlainPath(path))
    return bad("the path is of a-z, A-Z, 0-9, '-', '_', '.' and single slashes");
  S3Address address;
  address.endpoint = fmt::format("{}://{}", url.substr(0, scheme), host);
  if (!bucket_in_host) {
    const size_t end = std::min(path.find('/'), path.size());
    if (end == 0) return bad("the bucket is missing");
    address.path_prefix = fmt::format("/{}", path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  if (!path.empty()) address.key_prefix = fmt::format("{}/", path);
  return address;
}

}  // namespace slicefarm::coordinator
