#include "tests/integration/tcp_proxy.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace slicefarm {
namespace {

sockaddr_in Loopback(int port) {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

bool SendAll(int to, const char* bytes, ssize_t count) {
  while (count > 0) {
    const ssize_t sent = send(to, bytes, static_cast<size_t>(count), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes += sent;
    count -= sent;
  }
  return true;
}

}  // namespace

TcpProxy::TcpProxy(const std::string& target)
    : target_(target), listener_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address = Loopback(0);
  socklen_t size = sizeof(address);
  if (bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      listen(listener_, 64) != 0 ||
      getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    std::abort();
  }
  port_ = ntohs(address.sin_port);
  acceptor_ = std::thread([this] { Accept(); });
}

TcpProxy::~TcpProxy() {
  {
    std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  shutdown(listener_, SHUT_RDWR);
  acceptor_.join();
  Cut();
  for (std::thread& pump : pumps_) pump.join();
  close(listener_);
  for (const int fd : open_) close(fd);
}

std::string TcpProxy::address() const { return "127.0.0.1:" + std::to_string(port_); }

void TcpProxy::Cut() {
  std::lock_guard lock(mutex_);
  for (const int fd : open_) shutdown(fd, SHUT_RDWR);
}

void TcpProxy::Hold() {
  std::lock_guard lock(mutex_);
  held_ = true;
}

void TcpProxy::Pass() {
  {
    std::lock_guard lock(mutex_);
    held_ = false;
  }
  changed_.notify_all();
}

int64_t TcpProxy::passed() const {
  std::lock_guard lock(mutex_);
  return passed_;
}

void TcpProxy::Accept() {
  while (true) {
    const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (client < 0) return;
    Relay(client);
  }
}

/// Descriptors stay open to the end. Otherwise a reused number could be shut down.
void TcpProxy::Relay(int client) {
  const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in address = Loopback(std::stoi(target_.substr(target_.rfind(':') + 1)));
  const bool reached =
      connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  std::lock_guard lock(mutex_);
  open_.insert({client, server});
  if (!reached || ended_) {
    shutdown(client, SHUT_RDWR);
    return;
  }
  pumps_.emplace_back([this, client, server] { Pump(client, server); });
  pumps_.emplace_back([this, client, server] { Pump(server, client); });
}

void TcpProxy::Pump(int from, int to) {
  std::array<char, 16'384> buffer = {};
  while (true) {
    const ssize_t count = recv(from, buffer.data(), buffer.size(), 0);
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return !held_ || ended_; });
      if (count > 0) passed_ += count;
    }
    if (count <= 0 || !SendAll(to, buffer.data(), count)) break;
  }
  shutdown(from, SHUT_RDWR);
  shutdown(to, SHUT_RDWR);
}

}  // namespace slicefarm
