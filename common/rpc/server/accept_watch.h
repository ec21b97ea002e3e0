#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace slicefarm::rpc {

/// Returns true if the server at `address` (host:port) accepts a new connection: it sends data, or
/// closes, within `patience`. A connection that only waits in the kernel's queue does not count.
/// `tls`: the server uses TLS; a server without TLS is greeted with HTTP/2. The server's
/// certificate does not matter.
bool TakesConnections(const std::string& address, bool tls, std::chrono::milliseconds patience);

/// Checks repeatedly that a server accepts new connections. This is necessary because a gRPC 1.51
/// server never accepts again after accept() has failed once because no file descriptor was free
/// (CVE-2023-4785).
class AcceptWatch {
 public:
  static constexpr int kTries = 6;

  /// Starts the checks. `address`: the address on which the server listens; 0.0.0.0 and [::] are
  /// checked at their loopback address. `dead`: called once, from a separate thread, after kTries
  /// consecutive checks have failed within `patience`.
  AcceptWatch(const std::string& address, bool tls, std::chrono::milliseconds patience,
              std::function<void()> dead);

 private:
  std::jthread thread_;
};

}  // namespace slicefarm::rpc
