#include "common/rpc/security/tls.h"

#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "common/base/error.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/client/client_call.h"
#include "common/rpc/observe/metrics.h"
#include "common/rpc/security/authorizer.h"
#include "common/rpc/security/bearer_token.h"
#include "common/rpc/security/certificate_metrics.h"
#include "common/rpc/security/dev_certs_test.h"
#include "common/rpc/security/identity.h"
#include "common/rpc/server/server.h"
#include "slicefarm/v1/motion.grpc.pb.h"

namespace slicefarm::rpc::tls_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Service that answers with the identity and the token of its caller.
class WhoCalls final : public v1::Motion::Service {
 public:
  grpc::Status FrameProgram(grpc::ServerContext* context,
                            const v1::ProgramEnvelopeRequest* /*request*/,
                            v1::ProgramEnvelope* response) override {
    response->set_prologue(PeerIdentity(*context->auth_context()));
    response->set_epilogue(BearerToken(*context).value_or("none"));
    return grpc::Status::OK;
  }
};

class TlsTest : public testing::Test {
 protected:
  struct Answer {
    std::string identity;
    std::string token;
  };

  /// Starts a server. `policy` empty: no authorizer.
  void Serve(const TlsFiles& files, ClientCerts client_certs = ClientCerts::kRequired,
             std::shared_ptr<Authorizer> authorizer = nullptr) {
    auto tls = Tls::Open(files);
    ASSERT_TRUE(tls.ok()) << tls.status();
    ServerOptions options;
    options.credentials = (*tls)->ForServer(client_certs);
    if (authorizer) options.credentials->SetAuthMetadataProcessor(authorizer);
    auto server = Server::Start(options, {&service_}, call_metrics_);
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
  }

  std::shared_ptr<grpc::Channel> Channel(std::shared_ptr<grpc::ChannelCredentials> credentials,
                                         ChannelOptions options = {}) const {
    options.credentials = std::move(credentials);
    options.own_connection = true;
    options.retries = false;
    return MakeChannel("127.0.0.1:" + std::to_string(server_->port()), options);
  }

  /// Returns a channel of a client that has these files and accepts only a server with this
  /// identity.
  std::shared_ptr<grpc::Channel> ChannelOf(const TlsFiles& files,
                                           const std::string& server = StageIdentity("motion")) {
    return Channel((*Tls::Open(files))->ForIdentity(server, log_));
  }

  static absl::StatusOr<Answer> Call(const std::shared_ptr<grpc::Channel>& channel) {
    v1::ProgramEnvelope response;
    const auto stub = v1::Motion::NewStub(channel);
    const absl::Status status =
        UnaryCall({seconds(20), {}}, v1::ProgramEnvelopeRequest(), &response,
                  [&](auto&&... arguments) { return stub->AsyncFrameProgram(arguments...); });
    if (!status.ok()) return status;
    return Answer{response.prologue(), response.epilogue()};
  }

  static absl::Status AskHealth(const std::shared_ptr<grpc::Channel>& channel) {
    const grpc::ByteBuffer request(nullptr, 0);
    grpc::ByteBuffer response;
    grpc::GenericStub stub(channel);
    return UnaryCall<grpc::ByteBuffer, grpc::ByteBuffer>(
        {seconds(20), {}}, request, &response, [&](auto* context, auto& sent, auto* queue) {
          auto reader = stub.PrepareUnaryCall(context, "/grpc.health.v1.Health/Check", sent, queue);
          reader->StartCall();
          return reader;
        });
  }

  std::shared_ptr<Authorizer> Inner() { return *Authorizer::Make(InnerPolicy(), log_); }

  DevCerts certs_;
  const TlsFiles motion_ = certs_.Make("stage/motion");
  const TlsFiles coordinator_ = certs_.Make("coordinator");
  std::ostringstream log_text_;
  const JsonLog log_{"test",
                     std::make_shared<spdlog::logger>(
                         "test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log_text_))};
  WhoCalls service_;
  Metrics metrics_;
  CallMetrics call_metrics_{metrics_.registry()};
  std::unique_ptr<Server> server_;
};

TEST_F(TlsTest, EachSideKnowsTheOther) {
  Serve(motion_);
  const auto answer = Call(ChannelOf(coordinator_));
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->identity, kCoordinatorIdentity);
  EXPECT_EQ(answer->token, "none");
}

TEST_F(TlsTest, ClientsThatCannotProveWhoTheyAreGetNoConnection) {
  Serve(motion_);
  DevCerts others;
  TlsFiles stranger = others.Make("coordinator");
  stranger.ca = coordinator_.ca;
  TlsFiles none;
  none.ca = coordinator_.ca;
  for (const TlsFiles& files : {stranger, none}) {
    const absl::Status status = Call(ChannelOf(files)).status();
    EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  }
  EXPECT_TRUE(absl::IsUnavailable(Call(Channel(nullptr)).status()));  // without TLS
}

TEST_F(TlsTest, ClientsWhoseCertificateExpiresGetNoNewConnection) {
  SwappedDirectory client(certs_.path() + "/coordinator");
  Serve(motion_);
  const auto tls = *Tls::Open(DevCerts::In(client.path()));
  const auto first = Channel(tls->ForIdentity(StageIdentity("motion"), log_));
  EXPECT_TRUE(Call(first).ok());
  certs_.Make("coordinator", 0);
  client.PointTo(certs_.path() + "/coordinator");
  while (Call(Channel(tls->ForIdentity(StageIdentity("motion"), log_))).ok()) {
    std::this_thread::yield();
  }
  EXPECT_TRUE(Call(first).ok());  // keeps its connection open
}

TEST_F(TlsTest, AServerWithAnothersCertificateIsNotSpokenTo) {
  Serve(motion_);
  const absl::Status status = Call(ChannelOf(coordinator_, StageIdentity("infill"))).status();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_THAT(log_text_.str(),
              testing::HasSubstr(R"("expected":"spiffe://slicefarm/stage/infill")"));
  EXPECT_THAT(log_text_.str(), testing::HasSubstr("spiffe://slicefarm/stage/motion"));
}

TEST_F(TlsTest, AServerIsKnownByItsName) {
  Serve(motion_);
  const auto tls = *Tls::Open(coordinator_);
  EXPECT_TRUE(Call(Channel(tls->ForServerName())).ok());  // the certificate contains 127.0.0.1
  ChannelOptions options;
  options.server_name = "motion";
  EXPECT_TRUE(Call(Channel(tls->ForServerName(), options)).ok());
  options.server_name = "farm.example";
  EXPECT_TRUE(absl::IsUnavailable(Call(Channel(tls->ForServerName(), options)).status()));
}

TEST_F(TlsTest, ATenantsCertificateServesNobody) {
  Serve(certs_.Make("tenant/a"));
  const absl::Status status = Call(Channel((*Tls::Open(coordinator_))->ForServerName())).status();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
}

TEST_F(TlsTest, RenewedFilesHoldForNewConnections) {
  certs_.Make("worker");
  SwappedDirectory server(certs_.path() + "/stage-motion");
  Serve(DevCerts::In(server.path()));
  const auto old = ChannelOf(coordinator_);
  EXPECT_TRUE(Call(old).ok());
  server.PointTo(certs_.path() + "/worker");
  // The client retries repeatedly.
  EXPECT_TRUE(ChannelOf(coordinator_, kWorkerIdentity)
                  ->WaitForConnected(std::chrono::system_clock::now() + seconds(60)));
  EXPECT_TRUE(Call(old).ok());
  EXPECT_FALSE(Call(ChannelOf(coordinator_)).ok());
}

TEST_F(TlsTest, AKeyThatDoesNotFitIsGotOver) {
  certs_.Make("worker");
  SwappedDirectory server(certs_.path() + "/stage-motion");
  Serve(DevCerts::In(server.path()));
  const std::string half = certs_.path() + "/half";
  std::filesystem::create_directory(half);
  std::filesystem::copy(certs_.path() + "/worker/cert.pem", half);
  std::filesystem::copy(certs_.path() + "/worker/ca.pem", half);
  std::filesystem::copy(certs_.path() + "/stage-motion/key.pem", half);
  server.PointTo(half);
  while (Call(ChannelOf(coordinator_)).ok()) std::this_thread::yield();
  server.PointTo(certs_.path() + "/worker");
  EXPECT_TRUE(ChannelOf(coordinator_, kWorkerIdentity)
                  ->WaitForConnected(std::chrono::system_clock::now() + seconds(60)));
}

TEST_F(TlsTest, OnlyTheCoordinatorMayCallAStage) {
  Serve(motion_, ClientCerts::kRequired, Inner());
  EXPECT_TRUE(Call(ChannelOf(coordinator_)).ok());
  for (const char* role : {"worker", "stage/motion", "tenant/a"}) {
    const auto channel = ChannelOf(certs_.Make(role));
    const absl::Status status = Call(channel).status();
    EXPECT_TRUE(absl::IsPermissionDenied(status)) << status;
    EXPECT_EQ(DetailOf(status).reason, Reason::kPermissionDenied);
    EXPECT_THAT(std::string(status.message()),
                testing::EndsWith(" may not call /slicefarm.v1.Motion/FrameProgram"));
    EXPECT_TRUE(AskHealth(channel).ok());
  }
  EXPECT_THAT(log_text_.str(), testing::HasSubstr(R"("peer":"spiffe://slicefarm/tenant/a")"));
}

TEST_F(TlsTest, WhereCertificatesAreOptionalThePolicySeesWhoHasNone) {
  Serve(motion_, ClientCerts::kOptional, Inner());
  TlsFiles none;
  none.ca = coordinator_.ca;
  const absl::Status status = Call(ChannelOf(none)).status();
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kUnauthenticated);
  EXPECT_TRUE(absl::IsUnauthenticated(AskHealth(ChannelOf(none))));
  EXPECT_TRUE(Call(ChannelOf(coordinator_)).ok());
}

TEST_F(TlsTest, TheOpenPolicyLetsAnybodyPass) {
  Serve(motion_, ClientCerts::kOptional, *Authorizer::Make(OpenPolicy(), log_));
  TlsFiles none;
  none.ca = coordinator_.ca;
  EXPECT_TRUE(Call(ChannelOf(none)).ok());
}

TEST_F(TlsTest, APolicyInAFileIsReadAgainWhenItChanges) {
  const std::string path = certs_.path() + "/policy.json";
  const auto write = [&](const std::string& principal) {
    std::ofstream(path + ".new") << R"({"allow_rules": [{"source": {"principals": [")" << principal
                                 << R"("]}}]})";
    std::filesystem::rename(path + ".new", path);
  };
  EXPECT_FALSE(Authorizer::Watch(path, log_).ok());
  write(kWorkerIdentity);
  auto authorizer = Authorizer::Watch(path, log_, milliseconds(1));
  ASSERT_TRUE(authorizer.ok()) << authorizer.status();
  Serve(motion_, ClientCerts::kRequired, *authorizer);
  const auto channel = ChannelOf(coordinator_);
  EXPECT_TRUE(absl::IsPermissionDenied(Call(channel).status()));
  write(kCoordinatorIdentity);
  while (!Call(channel).ok()) std::this_thread::yield();
  std::ofstream(path) << "{";
  while (log_text_.str().find("remains in use") == std::string::npos) std::this_thread::yield();
  EXPECT_TRUE(Call(channel).ok());
}

TEST_F(TlsTest, TokensGoAlongWithEachCall) {
  Serve(motion_);
  ChannelOptions options;
  options.token = "sf_secret";
  const auto tls = *Tls::Open(coordinator_);
  const auto channel = Channel(tls->ForServerName(), options);
  EXPECT_EQ(Call(channel)->token, "sf_secret");
  EXPECT_EQ(Call(channel)->token, "sf_secret");
}

TEST(TlsFiles, AreLookedAtBeforeTheyAreUsed) {
  DevCerts certs;
  const TlsFiles good = certs.Make("worker");
  EXPECT_TRUE(CheckTlsFiles(good).ok());
  TlsFiles only_ca;
  only_ca.ca = good.ca;
  EXPECT_TRUE(CheckTlsFiles(only_ca).ok());

  const auto fails = [](const TlsFiles& files, Reason reason, const std::string& file) {
    const absl::Status status = CheckTlsFiles(files);
    EXPECT_EQ(DetailOf(status).reason, reason) << status;
    EXPECT_EQ(DetailOf(status).metadata["file"], file);
  };
  TlsFiles files = good;
  files.cert = good.key;
  fails(files, Reason::kRequestMalformed, good.key);
  files = good;
  files.key = certs.Make("coordinator").key;
  fails(files, Reason::kRequestMalformed, files.key);
  files = good;
  files.ca = "/nowhere/ca.pem";
  fails(files, Reason::kRequestMalformed, files.ca);
  files = certs.Make("tenant/a", 0);
  fails(files, Reason::kUnauthenticated, files.cert);
}

TEST(CertificateMetrics, SayWhenTheFilesOfNowExpire) {
  DevCerts certs;
  const TlsFiles files = certs.Make("worker", 10);
  const CertificateMetrics metrics(files);
  const auto days_left = [&] {
    const double expiry = metrics.Collect().at(0).metric.at(0).gauge.value;
    return (expiry - static_cast<double>(std::time(nullptr))) / 86'400;
  };
  EXPECT_NEAR(days_left(), 10, 0.1);
  certs.Make("worker", 20);
  EXPECT_NEAR(days_left(), 20, 0.1);
  certs.Make("worker", 0);
  EXPECT_NEAR(days_left(), 0, 0.1);
  std::filesystem::copy(certs.Make("coordinator").key, files.key,
                        std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(metrics.Collect().at(0).metric.at(0).gauge.value, 0);
}

TEST(Identity, NamesATenantOrNot) {
  EXPECT_EQ(TenantOfIdentity("spiffe://slicefarm/tenant/acme"), "acme");
  for (const char* other : {"", "spiffe://slicefarm/tenant/", "spiffe://slicefarm/worker",
                            "spiffe://elsewhere/tenant/acme"}) {
    EXPECT_EQ(TenantOfIdentity(other), std::nullopt) << other;
  }
}

}  // namespace
}  // namespace slicefarm::rpc::tls_test
