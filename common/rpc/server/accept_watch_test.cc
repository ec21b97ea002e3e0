#include "common/rpc/server/accept_watch.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "common/rpc/event_test.h"
#include "common/rpc/observe/metrics.h"
#include "common/rpc/security/dev_certs_test.h"
#include "common/rpc/security/tls.h"
#include "common/rpc/server/server.h"

namespace slicefarm::rpc::accept_watch_test {
namespace {

using std::chrono::milliseconds;
constexpr std::chrono::seconds kLong(60);

/// A port on which connections wait without end, as on a server with a failed accept().
class DeafPort {
 public:
  DeafPort() : fd_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in any = {};
    any.sin_family = AF_INET;
    any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof any;
    EXPECT_EQ(bind(fd_, reinterpret_cast<sockaddr*>(&any), size), 0);
    EXPECT_EQ(listen(fd_, 100), 0);
    EXPECT_EQ(getsockname(fd_, reinterpret_cast<sockaddr*>(&any), &size), 0);
    port_ = ntohs(any.sin_port);
  }
  ~DeafPort() { close(fd_); }

  std::string address(const std::string& host = "127.0.0.1") const {
    return host + ":" + std::to_string(port_);
  }

 private:
  const int fd_;
  int port_ = 0;
};

class AcceptWatchTest : public testing::Test {
 protected:
  std::string Serve(const ServerOptions& options = {}) {
    auto server = Server::Start(options, {}, call_metrics_);
    EXPECT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
    return "127.0.0.1:" + std::to_string(server_->port());
  }

 private:
  Metrics metrics_;
  CallMetrics call_metrics_{metrics_.registry()};
  std::unique_ptr<Server> server_;
};

TEST_F(AcceptWatchTest, AServerTakesConnections) {
  EXPECT_TRUE(TakesConnections(Serve(), /*tls=*/false, kLong));
}

TEST_F(AcceptWatchTest, SoDoesOneWithTlsWhateverItsCertificate) {
  DevCerts certs;
  for (const int days : {30, 0}) {
    const auto tls = Tls::Open(certs.Make("worker"));
    ASSERT_TRUE(tls.ok()) << tls.status();
    ServerOptions options;
    options.credentials = (*tls)->ForServer(ClientCerts::kRequired);
    const std::string address = Serve(options);
    certs.Make("worker", days);
    EXPECT_TRUE(TakesConnections(address, /*tls=*/true, kLong));
  }
}

TEST_F(AcceptWatchTest, AConnectionThatOnlyWaitsIsNotTaken) {
  const DeafPort port;
  EXPECT_FALSE(TakesConnections(port.address(), /*tls=*/false, milliseconds(20)));
  EXPECT_FALSE(TakesConnections(port.address(), /*tls=*/true, milliseconds(20)));
}

TEST_F(AcceptWatchTest, NobodyListens) {
  std::string address;
  {
    const DeafPort port;
    address = port.address();
  }
  EXPECT_FALSE(TakesConnections(address, /*tls=*/false, kLong));
}

TEST_F(AcceptWatchTest, TellsOfADeafPortOnce) {
  const DeafPort port;
  int reported = 0;
  Event dead;
  {
    const AcceptWatch watch(port.address("0.0.0.0"), /*tls=*/false, milliseconds(60), [&] {
      ++reported;
      dead.Happen();
    });
    dead.Await();
  }
  EXPECT_EQ(reported, 1);
}

}  // namespace
}  // namespace slicefarm::rpc::accept_watch_test
