#include "common/rpc/server/accept_watch.h"

#include <fcntl.h>
#include <openssl/bio.h>
#include <openssl/ssl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string_view>

#include "common/base/stoppable_sleep.h"
#include "common/base/stopwatch.h"
#include "common/rpc/address/socket_address.h"

namespace slicefarm::rpc {
namespace {

using std::chrono::milliseconds;

/// HTTP/2's preface and an empty SETTINGS frame, which a server answers with its own SETTINGS
/// frame.
constexpr std::string_view kHttp2Greeting("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n\0\0\0\4\0\0\0\0\0", 33);

/// Returns TLS's ClientHello. The handshake ends after it, so neither side has to show a
/// certificate.
std::string TlsGreeting() {
  const std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context(SSL_CTX_new(TLS_client_method()),
                                                                  SSL_CTX_free);
  const std::unique_ptr<SSL, decltype(&SSL_free)> tls(SSL_new(context.get()), SSL_free);
  BIO* sent = BIO_new(BIO_s_mem());  // the SSL owns both
  SSL_set_bio(tls.get(), BIO_new(BIO_s_mem()), sent);
  SSL_set_connect_state(tls.get());
  SSL_do_handshake(tls.get());
  char* bytes = nullptr;
  const long size = BIO_get_mem_data(sent, &bytes);
  return {bytes, static_cast<size_t>(std::max(size, 0L))};
}

class ProbeSocket {
 public:
  explicit ProbeSocket(const addrinfo& address)
      : fd_(socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {}
  ~ProbeSocket() {
    if (fd_ >= 0) close(fd_);
  }
  ProbeSocket(const ProbeSocket&) = delete;
  ProbeSocket& operator=(const ProbeSocket&) = delete;

  int fd() const { return fd_; }

  /// Waits for `events` or the end of the connection. Returns false if neither occurs within the
  /// time.
  bool Await(short events, milliseconds time) const {
    pollfd waiting{.fd = fd_, .events = events, .revents = 0};
    return poll(&waiting, 1, static_cast<int>(std::max<int64_t>(time.count(), 0))) == 1;
  }

 private:
  const int fd_;
};

/// Returns an address to connect to. A server can listen on all addresses (0.0.0.0 and [::]), but a
/// client must name one.
std::string ToConnect(const std::string& listened) {
  const size_t colon = listened.rfind(':');
  const std::string host = listened.substr(0, colon);
  if (host == "0.0.0.0") return "127.0.0.1" + listened.substr(colon);
  if (host == "[::]" || host == "::") return "[::1]" + listened.substr(colon);
  return listened;
}

}  // namespace

bool TakesConnections(const std::string& address, bool tls, milliseconds patience) {
  const SocketAddresses to = ResolveSocketAddress(address);
  if (!to) return false;
  const ProbeSocket socket(*to);
  const Stopwatch since;
  const auto left = [&] {
    return patience - milliseconds(static_cast<int64_t>(since.Seconds() * 1000));
  };
  if (socket.fd() < 0) return false;
  if (connect(socket.fd(), to->ai_addr, to->ai_addrlen) != 0 && errno != EINPROGRESS) return false;
  if (!socket.Await(POLLOUT, left())) return false;
  int error = 0;
  socklen_t size = sizeof error;
  if (getsockopt(socket.fd(), SOL_SOCKET, SO_ERROR, &error, &size) != 0 || error != 0) return false;
  const std::string greeting = tls ? TlsGreeting() : std::string(kHttp2Greeting);
  if (send(socket.fd(), greeting.data(), greeting.size(), MSG_NOSIGNAL) < 0) return false;
  return socket.Await(POLLIN, left());
}

AcceptWatch::AcceptWatch(const std::string& address, bool tls, milliseconds patience,
                         std::function<void()> dead)
    : thread_([address = ToConnect(address), tls, every = patience / kTries,
               dead = std::move(dead)](const std::stop_token& stop) {
        int failed = 0;
        while (SleepUnlessStopped(stop, every)) {
          failed = TakesConnections(address, tls, every) ? 0 : failed + 1;
          if (failed == kTries) return dead();
        }
      }) {}

}  // namespace slicefarm::rpc
