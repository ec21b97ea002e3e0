#include "common/rpc/server/server.h"

#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <functional>
#include <future>
#include <sstream>
#include <thread>

#include "common/base/error.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/client/client_call.h"
#include "common/rpc/event_test.h"
#include "common/rpc/observe/metrics.h"
#include "common/rpc/server/call_limiter.h"
#include "prometheus/text_serializer.h"
#include "slicefarm/v1/motion.grpc.pb.h"

namespace slicefarm::rpc::server_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Any service is suitable; this one has a method with streams and one without.
class TestService final : public v1::Motion::Service {
 public:
  using Work = std::function<absl::Status(Call&)>;

  explicit TestService(const CallLimiterOptions& options, JsonLog log)
      : gate_(options, std::move(log)) {}

  void OnCall(Work work) { work_ = std::move(work); }

  grpc::Status FrameProgram(grpc::ServerContext* context, const v1::ProgramEnvelopeRequest* request,
                            v1::ProgramEnvelope* response) override {
    response->set_epilogue(request->settings_text());
    return gate_.Run(*context, "FrameProgram", work_);
  }

  grpc::Status ProgramLayers(
      grpc::ServerContext* /*context*/,
      grpc::ServerReaderWriter<v1::LayerProgram, v1::ProgramRequest>* stream) override {
    v1::ProgramRequest request;
    while (stream->Read(&request)) {
      v1::LayerProgram program;
      *program.mutable_frame() = request.layer().frame();
      stream->Write(program);
    }
    return grpc::Status::OK;
  }

 private:
  CallLimiter gate_;
  Work work_ = [](Call&) { return absl::OkStatus(); };
};

/// Works until the caller cancels.
absl::Status WorkForever(Call& call) {
  while (!call.cancel.Cancelled()) std::this_thread::yield();
  return call.cancel.Check();
}

class ServerTest : public testing::Test {
 protected:
  void Start(const CallLimiterOptions& gate = {}, const ServerOptions& options = {}) {
    service_ = std::make_unique<TestService>(gate, log_);
    auto server = Server::Start(options, {service_.get()}, call_metrics_);
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
    channel_ = MakeChannel(Address());
  }

  std::string Address() const { return "127.0.0.1:" + std::to_string(server_->port()); }

  absl::Status CallFrame(const ClientCallOptions& options = {}, const std::string& text = "text") {
    v1::ProgramEnvelopeRequest request;
    request.set_settings_text(text);
    v1::ProgramEnvelope response;
    const auto stub = v1::Motion::NewStub(channel_);
    const absl::Status status = UnaryCall(options, request, &response, [&](auto&&... arguments) {
      return stub->AsyncFrameProgram(arguments...);
    });
    EXPECT_EQ(response.epilogue(), status.ok() ? text : "");
    return status;
  }

  /// Calls a method with message types that are unknown here.
  absl::Status CallRaw(const std::string& method, const std::string& bytes, std::string* answer) {
    const grpc::Slice slice(bytes);
    const grpc::ByteBuffer request(&slice, 1);
    StreamCall<grpc::ByteBuffer, grpc::ByteBuffer> call({}, [&](auto* context, auto* queue) {
      return grpc::GenericStub(channel_).PrepareCall(context, method, queue);
    });
    grpc::ByteBuffer response;
    if (call.Write(request) && call.WritesDone() && call.Read(&response)) {
      grpc::Slice flat;
      (void)response.DumpToSingleSlice(&flat);
      answer->assign(flat.begin(), flat.end());
    }
    return call.Finish();
  }

  std::string MetricsText() {
    return prometheus::TextSerializer().Serialize(metrics_.registry().Collect());
  }

  std::ostringstream log_text_;
  const JsonLog log_{"test",
                     std::make_shared<spdlog::logger>(
                         "test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log_text_))};
  Metrics metrics_;
  CallMetrics call_metrics_{metrics_.registry()};
  std::unique_ptr<TestService> service_;
  std::unique_ptr<Server> server_;
  std::shared_ptr<grpc::Channel> channel_;
};

TEST_F(ServerTest, AnswersAndCounts) {
  Start();
  EXPECT_TRUE(CallFrame().ok());
  service_->OnCall([](Call& call) {
    call.job_id = "j7";
    call.layers = {3, 9};
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingUnknown, "no such setting",
                     {{"setting", "colour"}});
  });
  const absl::Status status =
      CallFrame({.trace = {"4bf92f3577b34da6a3ce929d0e0e4736", "00f067aa0ba902b7"}});
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(DetailOf(status).reason, Reason::kSettingUnknown);
  EXPECT_EQ(DetailOf(status).metadata["setting"], "colour");

  server_->Drain(seconds(10));  // the counts are complete when the calls have ended
  EXPECT_THAT(MetricsText(),
              testing::AllOf(
                  testing::HasSubstr(R"(grpc_server_started_total{grpc_method="FrameProgram",)"
                                     R"(grpc_service="slicefarm.v1.Motion"} 2)"),
                  testing::HasSubstr(R"(grpc_server_handled_total{grpc_code="OK",grpc_method=)"
                                     R"("FrameProgram",grpc_service="slicefarm.v1.Motion"} 1)"),
                  testing::HasSubstr(R"(grpc_server_handled_total{grpc_code="INVALID_ARGUMENT")"),
                  testing::HasSubstr("grpc_server_handling_seconds_bucket")));
  EXPECT_THAT(
      log_text_.str(),
      testing::HasSubstr(
          R"("method":"FrameProgram","job":"j7","trace_id":"4bf92f3577b34da6a3ce929d0e0e4736",)"
          R"("span_id":"00f067aa0ba902b7","layer_first":3,)"
          R"("layer_last":8,)"));
  EXPECT_THAT(log_text_.str(), testing::HasSubstr(R"("reason":"SETTING_UNKNOWN")"));
}

TEST_F(ServerTest, MethodsThatNobodyHasGetNoLabelsOfTheirOwn) {
  Start();
  std::string answer;
  for (const char* method : {"/slicefarm.v1.Motion/Dance", "/stranger.A/B", "/a/b/c"}) {
    EXPECT_FALSE(CallRaw(method, "", &answer).ok());
  }
  EXPECT_TRUE(CallRaw("/grpc.health.v1.Health/Check", "", &answer).ok());
  server_->Drain(seconds(10));
  EXPECT_THAT(MetricsText(), testing::AllOf(testing::HasSubstr(R"(grpc_method="unknown")"),
                                            testing::HasSubstr(R"(grpc_method="Check")"),
                                            testing::Not(testing::HasSubstr("Dance")),
                                            testing::Not(testing::HasSubstr("stranger"))));
}

TEST_F(ServerTest, WhatStorageSaysIsForTheLogAlone) {
  ServerOptions options;
  options.log = log_;
  Start({}, options);
  struct Case {
    absl::StatusCode code;
    Reason reason;
    bool is_reported;
  };
  for (const Case& c : {Case{absl::StatusCode::kInternal, Reason::kStoreFailed, false},
                        Case{absl::StatusCode::kUnavailable, Reason::kStoreFailed, false},
                        Case{absl::StatusCode::kResourceExhausted, Reason::kDiskFull, false},
                        Case{absl::StatusCode::kDataLoss, Reason::kStoreFailed, true},
                        Case{absl::StatusCode::kInternal, Reason::kInternal, true}}) {
    const std::string error = "fsync /var/lib/slicefarm/blobs: no luck";
    service_->OnCall([&](Call&) {
      return MakeError(c.code, c.reason, error, {{"retry_after_ms", "1500"}, {"job", "7"}});
    });
    log_text_.str("");
    const absl::Status status = CallFrame();
    EXPECT_EQ(status.code(), c.code);
    EXPECT_EQ(DetailOf(status).reason, c.reason);
    EXPECT_EQ(DetailOf(status).metadata["job"], "7");
    EXPECT_EQ(DetailOf(status).metadata["retry_after_ms"], "1500");
    EXPECT_EQ(status.message().find("/var/lib") != std::string::npos, c.is_reported) << status;
    EXPECT_EQ(log_text_.str().find("storage failed") == std::string::npos, c.is_reported);
    EXPECT_THAT(log_text_.str(), testing::HasSubstr(error));
  }
}

// Bytes that are not a message, and a string field that is not UTF-8.
TEST_F(ServerTest, WhatCannotBeReadHasAReason) {
  Start();
  for (const char* bytes : {"\xff\xff\xff", "\x3a\x02\xc3("}) {
    std::string answer;
    const absl::Status status = CallRaw("/slicefarm.v1.Motion/FrameProgram", bytes, &answer);
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  }
  server_->Drain(seconds(10));
  EXPECT_THAT(MetricsText(),
              testing::HasSubstr(R"(grpc_server_handled_total{grpc_code=)"
                                 R"("INVALID_ARGUMENT",grpc_method="FrameProgram")"));
}

TEST_F(ServerTest, StreamsBothWays) {
  Start();
  StreamCall<v1::ProgramRequest, v1::LayerProgram> call({}, [&](auto* context, auto* queue) {
    return v1::Motion::NewStub(channel_)->PrepareAsyncProgramLayers(context, queue);
  });
  for (int i = 0; i < 5; ++i) {
    v1::ProgramRequest request;
    request.mutable_layer()->mutable_frame()->set_index(i);
    ASSERT_TRUE(call.Write(request));
  }
  ASSERT_TRUE(call.WritesDone());
  v1::LayerProgram program;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(call.Read(&program));
    EXPECT_EQ(program.frame().index(), i);
  }
  EXPECT_FALSE(call.Read(&program));
  EXPECT_TRUE(call.Finish().ok());
}

TEST_F(ServerTest, ReportsHealth) {
  Start();
  std::string answer;
  ASSERT_TRUE(CallRaw("/grpc.health.v1.Health/Check", "", &answer).ok());
  EXPECT_EQ(answer, "\x08\x01");  // HealthCheckResponse{status: SERVING}
}

TEST_F(ServerTest, ListsItsServices) {
  Start();
  std::string answer;
  const std::string list_services("\x3a\0", 2);  // ServerReflectionRequest{list_services: ""}
  ASSERT_TRUE(CallRaw("/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo",
                      list_services, &answer)
                  .ok());
  EXPECT_THAT(answer, testing::HasSubstr("slicefarm.v1.Motion"));
  EXPECT_THAT(answer, testing::HasSubstr("grpc.health.v1.Health"));
}

TEST_F(ServerTest, CancellationReachesTheWork) {
  Start();
  Event begun;
  Event stopped;
  service_->OnCall([&](Call& call) {
    begun.Happen();
    const absl::Status status = WorkForever(call);
    stopped.Happen();
    return status;
  });
  const absl::Status status =
      CallFrame({seconds(60), CancelToken([&] { return begun.Happened(); })});
  EXPECT_TRUE(absl::IsCancelled(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kCancelled);
  stopped.Await();
}

TEST_F(ServerTest, TheClientsDeadlineReachesTheWork) {
  Start();
  Event stopped;
  service_->OnCall([&](Call& call) {
    const absl::Status status = WorkForever(call);
    stopped.Happen();
    return status;
  });
  const absl::Status status = CallFrame({milliseconds(50), {}});
  EXPECT_TRUE(absl::IsDeadlineExceeded(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kDeadlineExceeded);
  stopped.Await();
}

TEST_F(ServerTest, WorkWithoutADeadlineGetsOne) {
  Start({1, 0, milliseconds(50)});
  service_->OnCall(WorkForever);
  grpc::ClientContext context;  // has no deadline, unlike calls of slicefarm's clients
  v1::ProgramEnvelope response;
  const grpc::Status status = v1::Motion::NewStub(channel_)->FrameProgram(&context, {}, &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
}

TEST_F(ServerTest, MoreCallsThanItTakesAreRefused) {
  Start({1, 0, seconds(60)});
  Event begun;
  Event go_on;
  service_->OnCall([&](Call&) {
    begun.Happen();
    go_on.Await();
    return absl::OkStatus();
  });
  auto first = std::async(std::launch::async, [&] { return CallFrame(); });
  begun.Await();
  const absl::Status second = CallFrame();
  EXPECT_EQ(second.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(DetailOf(second).reason, Reason::kOverloaded);
  go_on.Happen();
  EXPECT_TRUE(first.get().ok());
}

TEST_F(ServerTest, MoreCallsThanAConnectionMayHaveWaitInTheClient) {
  ServerOptions options;
  options.max_streams_per_connection = 1;
  Start({}, options);
  Event begun;
  Event go_on;
  std::atomic<int> calls = 0;
  service_->OnCall([&](Call&) {
    if (++calls > 1) return absl::OkStatus();
    begun.Happen();
    go_on.Await();
    return absl::OkStatus();
  });
  auto first = std::async(std::launch::async, [&] { return CallFrame(); });
  begun.Await();
  ClientCallOptions hurried;
  hurried.deadline = std::chrono::milliseconds(50);
  EXPECT_EQ(CallFrame(hurried).code(), absl::StatusCode::kDeadlineExceeded);
  EXPECT_EQ(calls, 1) << "it never reached the server";
  auto second = std::async(std::launch::async, [&] { return CallFrame(); });
  go_on.Happen();
  EXPECT_TRUE(first.get().ok());
  EXPECT_TRUE(second.get().ok());
}

TEST_F(ServerTest, MessagesBeyondTheLimitAreRefused) {
  ServerOptions options;
  options.max_message_bytes = 1000;
  Start({}, options);
  EXPECT_TRUE(CallFrame({}, std::string(900, 'x')).ok());
  const absl::Status status = CallFrame({}, std::string(2000, 'x'));
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge);
}

TEST_F(ServerTest, DrainingFinishesWhatIsInFlight) {
  Start();
  Event begun;
  Event go_on;
  service_->OnCall([&](Call&) {
    begun.Happen();
    go_on.Await();
    return absl::OkStatus();
  });
  auto call = std::async(std::launch::async, [&] { return CallFrame(); });
  begun.Await();
  const auto channel = MakeChannel(Address());
  const auto far = std::chrono::system_clock::now() + seconds(60);
  EXPECT_TRUE(channel->WaitForConnected(far));
  auto drain = std::async(std::launch::async, [&] { server_->Drain(seconds(60)); });
  // Once the drain has begun, connections are told to close, and new calls are refused.
  EXPECT_TRUE(channel->WaitForStateChange(GRPC_CHANNEL_READY, far));
  grpc::ClientContext context;
  context.set_deadline(far);
  v1::ProgramEnvelope response;
  const grpc::Status refused = v1::Motion::NewStub(channel)->FrameProgram(&context, {}, &response);
  EXPECT_EQ(refused.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(drain.wait_for(milliseconds(0)), std::future_status::timeout);
  go_on.Happen();
  EXPECT_TRUE(call.get().ok());
  drain.get();
}

TEST_F(ServerTest, DrainingWithoutPatienceCancels) {
  Start();
  Event begun;
  service_->OnCall([&](Call& call) {
    begun.Happen();
    return WorkForever(call);
  });
  auto call = std::async(std::launch::async, [&] { return CallFrame(); });
  begun.Await();
  server_->Drain(milliseconds(0));
  const absl::Status status = call.get();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
}

TEST_F(ServerTest, TwoServersOnOnePortAreRefused) {
  Start();
  ServerOptions options;
  options.listen = Address();
  const absl::Status status = Server::Start(options, {}, call_metrics_).status();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(DetailOf(status).metadata["address"], Address());
}

TEST_F(ServerTest, NobodyThereIsUnavailable) {
  Start();
  server_->Drain(milliseconds(0));
  const absl::Status status = CallFrame({seconds(20), {}});
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
}

}  // namespace
}  // namespace slicefarm::rpc::server_test
