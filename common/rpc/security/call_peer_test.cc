#include "common/rpc/security/call_peer.h"

#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <map>

#include "common/base/error.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/observe/metrics.h"
#include "common/rpc/security/dev_certs_test.h"
#include "common/rpc/security/identity.h"
#include "common/rpc/security/tls.h"
#include "common/rpc/server/server.h"
#include "common/rpc/status_mapping.h"
#include "slicefarm/v1/motion.grpc.pb.h"

namespace slicefarm::rpc::call_peer_test {
namespace {

/// Returns the certificate in the form of nginx's `$ssl_client_escaped_cert`.
std::string Escaped(const TlsFiles& files) {
  std::ifstream file(files.cert);
  std::string escaped;
  for (auto byte = std::istreambuf_iterator<char>(file); byte != std::istreambuf_iterator<char>();
       ++byte) {
    const auto code = static_cast<unsigned char>(*byte);
    escaped += std::isalnum(code) != 0 ? std::string(1, *byte) : fmt::format("%{:02X}", code);
  }
  return escaped;
}

/// Service that answers with the identity and address of its caller.
class WhoCalls final : public v1::Motion::Service {
 public:
  grpc::Status FrameProgram(grpc::ServerContext* context,
                            const v1::ProgramEnvelopeRequest* /*request*/,
                            v1::ProgramEnvelope* response) override {
    const auto peer = PeerOf(*context);
    if (!peer.ok()) return ToGrpc(peer.status());
    response->set_prologue(peer->identity + (peer->certified ? "" : " without certificate"));
    response->set_epilogue(peer->address);
    return grpc::Status::OK;
  }
};

class CallPeerTest : public testing::Test {
 protected:
  using Headers = std::map<std::string, std::string>;

  CallPeerTest() {
    ServerOptions options;
    options.credentials =
        (*Tls::Open(certs_.Make("coordinator")))->ForServer(ClientCerts::kOptional);
    server_ = *Server::Start(options, {&service_}, call_metrics_);
  }

  absl::StatusOr<v1::ProgramEnvelope> Ask(const TlsFiles& files, const Headers& headers = {}) {
    ChannelOptions options;
    options.credentials = (*Tls::Open(files))->ForIdentity(kCoordinatorIdentity, JsonLog("test"));
    const auto channel = MakeChannel("127.0.0.1:" + std::to_string(server_->port()), options);
    grpc::ClientContext context;
    for (const auto& [key, value] : headers) context.AddMetadata(key, value);
    v1::ProgramEnvelope answer;
    const grpc::Status status = v1::Motion::NewStub(channel)->FrameProgram(&context, {}, &answer);
    if (!status.ok()) return FromGrpc(status);
    return answer;
  }

  Metrics metrics_;
  CallMetrics call_metrics_{metrics_.registry()};
  DevCerts certs_;
  WhoCalls service_;
  std::unique_ptr<Server> server_;
};

TEST_F(CallPeerTest, IsTheOneOfTheConnection) {
  const auto answer = Ask(certs_.Make("tenant/a"));
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->prologue(), "spiffe://slicefarm/tenant/a");
  EXPECT_THAT(answer->epilogue(), testing::StartsWith("ipv4:127.0.0.1:"));
}

TEST_F(CallPeerTest, IsTheOneThatTheProxyNames) {
  const auto answer = Ask(
      certs_.Make("proxy"),
      {{kProxiedCertificate, Escaped(certs_.Make("tenant/a"))}, {kProxiedAddress, "192.0.2.7"}});
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->prologue(), "spiffe://slicefarm/tenant/a");
  EXPECT_EQ(answer->epilogue(), "192.0.2.7");
}

TEST_F(CallPeerTest, IsNobodyIfTheProxyNamesNone) {
  const auto answer = Ask(certs_.Make("proxy"), {{kProxiedAddress, "192.0.2.7"}});
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->prologue(), " without certificate");
}

TEST_F(CallPeerTest, NobodyElseNamesAnother) {
  TlsFiles without = certs_.Make("tenant/a");
  const std::string of_b = Escaped(certs_.Make("tenant/b"));
  const TlsFiles files[] = {without, certs_.Make("worker"), certs_.Make("coordinator"),
                            TlsFiles{.cert = "", .key = "", .ca = without.ca}};
  for (const TlsFiles& each : files) {
    for (const Headers& headers :
         {Headers{{kProxiedCertificate, of_b}}, Headers{{kProxiedAddress, "192.0.2.7"}}}) {
      const absl::Status refused = Ask(each, headers).status();
      EXPECT_EQ(DetailOf(refused).reason, Reason::kPermissionDenied) << each.cert << refused;
    }
  }
}

TEST_F(CallPeerTest, ACertificateThatCannotBeReadIsNobodys) {
  for (const char* text :
       {"", "%", "%2", "-----BEGIN CERTIFICATE-----%0A", "spiffe://slicefarm/tenant/a"}) {
    const absl::Status refused = Ask(certs_.Make("proxy"), {{kProxiedCertificate, text}}).status();
    EXPECT_EQ(DetailOf(refused).reason, Reason::kUnauthenticated) << text << refused;
  }
}

TEST(PeerOfCertificate, NamesItsFingerprint) {
  DevCerts certs;
  const auto a = PeerOfCertificate(Escaped(certs.Make("tenant/a")));
  const auto renewed = PeerOfCertificate(Escaped(certs.Make("tenant/a")));
  ASSERT_TRUE(a && renewed);
  EXPECT_EQ(a->identity, renewed->identity);
  EXPECT_EQ(a->fingerprint.size(), 64U);
  EXPECT_NE(a->fingerprint, renewed->fingerprint);
}

}  // namespace
}  // namespace slicefarm::rpc::call_peer_test
