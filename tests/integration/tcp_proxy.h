#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace slicefarm {

/// A way to a server that can break: every connection to `address()` is carried on to `target`.
/// Dies if it cannot listen.
class TcpProxy {
 public:
  explicit TcpProxy(const std::string& target);
  ~TcpProxy();
  TcpProxy(const TcpProxy&) = delete;
  TcpProxy& operator=(const TcpProxy&) = delete;

  std::string address() const;

  /// Ends all connections at once; new ones may come.
  void Cut();

  /// Nothing passes any more, in both directions, and no end is told: as if the machines between
  /// were gone.
  void Hold();
  /// What was held goes on.
  void Pass();

  /// Bytes that have passed so far.
  int64_t passed() const;

 private:
  void Accept();
  void Carry(int client);
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
