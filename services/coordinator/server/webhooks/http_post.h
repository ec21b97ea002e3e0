#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Options of HttpPost.
struct HttpPostOptions {
  std::vector<std::string> headers = {};  ///< headers as "Name: value"
  std::chrono::milliseconds timeout{10'000};
  bool private_addresses = false;  ///< true if the host may have an address of a private network
};

/// Posts JSON over http or https and returns the status of the response. Ignores the body of the
/// response. Follows no redirect and uses no proxy. Checks the address to which the host name was
/// resolved. Blocks for at most `timeout`. Errors: Unavailable with the cause; PermissionDenied if
/// the address is not public.
absl::StatusOr<int> HttpPost(const std::string& url, const std::string& body,
                             const HttpPostOptions& options);

}  // namespace slicefarm::coordinator
