#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace slicefarm {

/// Proxy that can break connections to a server: every connection to `address()` is forwarded to
/// `target`. Aborts if it cannot listen.
class TcpProxy {
 public:
  explicit TcpProxy(const std::string& target);
  ~TcpProxy();
  TcpProxy(const TcpProxy&) = delete;
  TcpProxy& operator=(const TcpProxy&) = delete;

  std::string address() const;

  /// Ends all connections at once. New connections are accepted.
  void Cut();

  /// Stops all transfers in both directions without ending connections, as if the machines between
  /// were gone.
  void Hold();
  /// Continues after Hold and forwards the held bytes.
  void Pass();

  /// Returns the number of forwarded bytes.
  int64_t passed() const;

 private:
  void Accept();
  void Relay(int client);
  void Pump(int from, int to);

  const std::string target_;
  int listener_ = -1;
  int port_ = 0;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool held_ = false;
  bool ended_ = false;
  int64_t passed_ = 0;
  std::set<int> open_;
  std::vector<std::thread> pumps_;
  std::thread acceptor_;
};

}  // namespace slicefarm
