#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace slicefarm::rpc {

/// Returns true if who listens on `address` (host:port) takes a new connection: it sends something,
/// or closes, within `patience`. A connection that only waits in the kernel's queue does not count.
/// `tls`: the server's; a server without TLS is greeted as HTTP/2. Its certificate does not matter.
bool TakesConnections(const std::string& address, bool tls, std::chrono::milliseconds patience);

/// Asks a server again and again for a new connection, because that of gRPC 1.51 takes none for
/// ever after accept() has failed once for want of a descriptor (CVE-2023-4785).
class AcceptWatch {
 public:
  static constexpr int kTries = 6;

  /// `address`: where the server listens; 0.0.0.0 and [::] are asked at their loopback address.
  /// Calls `dead` once, from its own thread, after kTries tries in a row have failed in `patience`.
  AcceptWatch(const std::string& address, bool tls, std::chrono::milliseconds patience,
              std::function<void()> dead);

 private:
  std::jthread thread_;
};

}  // namespace slicefarm::rpc
