#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

struct HttpPostOptions {
  std::vector<std::string> headers = {};  ///< "Name: value"
  std::chrono::milliseconds timeout{10'000};
  bool private_addresses = false;  ///< may the host be in a private network?
};

/// Posts JSON over http or https and returns the status of the answer, of which the rest is thrown
/// away. Follows no redirect, uses no proxy, and looks at the address that the name really led to.
/// Blocks at most `timeout`. Errors: Unavailable with the cause; PermissionDenied for an address
/// that is not public.
absl::StatusOr<int> HttpPost(const std::string& url, const std::string& body,
                             const HttpPostOptions& options);

}  // namespace slicefarm::coordinator
