#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace slicefarm::rpc {

/// Returns true if the server at `address` (host:port) accepts a new connection: it sends data or
/// closes the connection within `patience`. A connection that waits in the kernel's queue is not
/// accepted yet. `tls`: true if the server uses TLS; to a server without TLS, the beginning of an
/// HTTP/2 connection is sent. The server's certificate is not checked.
bool TakesConnections(const std::string& address, bool tls, std::chrono::milliseconds patience);

/// Checks repeatedly that a server accepts new connections. In gRPC 1.51, a server that runs out of
/// file descriptors during accept() never accepts connections again (CVE-2023-4785).
class AcceptWatch {
 public:
  static constexpr int kTries = 6;

  /// Starts the checks. `address`: the address on which the server listens; for 0.0.0.0 and [::],
  /// the loopback address is checked. `dead`: called once, on another thread, after kTries
  /// consecutive failed checks. These checks take at most `patience` in total.
  AcceptWatch(const std::string& address, bool tls, std::chrono::milliseconds patience,
              std::function<void()> dead);

 private:
  std::jthread thread_;
};

}  // namespace slicefarm::rpc
