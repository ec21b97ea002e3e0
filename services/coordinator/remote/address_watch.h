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

/// Addresses (host:port, numeric host) behind one name (host:port).
using Resolve = std::function<absl::StatusOr<std::vector<std::string>>(const std::string& name)>;

/// By the system's resolver: all IPv4 addresses of the host; if it has none, the IPv6 ones, so that
/// a host with both is not taken for two. Errors: InvalidArgument for a name that is no host:port;
/// Unavailable if the host is not known (now).
absl::StatusOr<std::vector<std::string>> ResolveByDns(const std::string& name);

/// "a:1,b:2" -> {"a:1", "b:2"}; empty parts are left out.
std::vector<std::string> SplitAddresses(std::string_view list);

struct AddressWatchOptions {
  std::chrono::milliseconds every{5'000};
  std::chrono::milliseconds least_pause{500};  ///< between looks that Refresh asks for
  Resolve resolve = ResolveByDns;
};

/// Looks names up again and again, because replicas come and go behind them. A name that cannot be
/// resolved keeps the addresses it had. Thread-safe.
class AddressWatch {
 public:
  /// `changed` is told, by the watch's thread, each new set of addresses, sorted; from the first
  /// look on.
  AddressWatch(std::vector<std::string> names,
               std::function<void(const std::vector<std::string>&)> changed,
               AddressWatchOptions options = {});

  /// Asks for a look soon: an address has failed.
  void Refresh();

 private:
  void Loop(const std::stop_token& stop);
  std::vector<std::string> Look();

  const std::vector<std::string> names_;
  const std::function<void(const std::vector<std::string>&)> changed_;
  const AddressWatchOptions options_;
  std::map<std::string, std::vector<std::string>> known_;  ///< of the thread alone
  std::mutex mutex_;
  std::condition_variable_any wake_;
  bool refresh_ = false;
  std::jthread thread_;  ///< the last member: it uses the others
};

}  // namespace slicefarm::coordinator
