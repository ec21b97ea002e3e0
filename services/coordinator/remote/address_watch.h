#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Function that returns the addresses (host:port, numeric host) of a name (host:port).
using Resolve = std::function<absl::StatusOr<std::vector<std::string>>(const std::string& name)>;

/// Resolves a name with the system's resolver. Returns all IPv4 addresses of the host; if it has
/// none, its IPv6 addresses. So a host with addresses of both kinds counts as one host. Errors:
/// InvalidArgument if the name is not host:port; Unavailable if the host cannot be resolved at the
/// moment.
absl::StatusOr<std::vector<std::string>> ResolveByDns(const std::string& name);

/// Splits a list of addresses: "a:1,b:2" -> {"a:1", "b:2"}. Ignores empty parts.
std::vector<std::string> SplitAddresses(std::string_view list);

/// Options of an AddressWatch.
struct AddressWatchOptions {
  std::chrono::milliseconds every{5'000};
  std::chrono::milliseconds least_pause{500};  ///< shortest pause between two lookups
  Resolve resolve = ResolveByDns;
};

/// Resolves names again at regular intervals, because the replicas behind a name change. If a name
/// cannot be resolved, it keeps its last addresses. Thread-safe.
class AddressWatch {
 public:
  /// Starts the lookups of `names` (host:port). Calls `changed` with the sorted addresses of all
  /// names whenever they have changed, beginning with the first lookup. The calls run on the
  /// watch's own thread.
  AddressWatch(std::vector<std::string> names,
               std::function<void(const std::vector<std::string>&)> changed,
               AddressWatchOptions options = {});

  /// Requests a lookup soon, because an address has failed.
  void Refresh();

 private:
  void Loop(const std::stop_token& stop);
  std::vector<std::string> Look();

  const std::vector<std::string> names_;
  const std::function<void(const std::vector<std::string>&)> changed_;
  const AddressWatchOptions options_;
  /// Last addresses of each name; used only by the thread.
  std::map<std::string, std::vector<std::string>> known_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  bool refresh_ = false;
  std::jthread thread_;  ///< last member, because the thread uses the other members
};

}  // namespace slicefarm::coordinator
