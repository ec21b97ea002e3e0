#include "services/coordinator/remote/remote_call.h"

#include <gtest/gtest.h>

#include <utility>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/remote/fake_replica_test.h"

namespace slicefarm::coordinator::remote_call_test {
namespace {

/// Makes a call to a server that sends nothing and ends the call with `end`. The caller expects an
/// answer.
absl::Status CallThatEndsWith(const grpc::Status& end) {
  FakeReplica server;
  server.OnWork([end] { return end; });
  SingleReplica replicas(rpc::MakeChannel(server.address()));
  return StreamOver(
      replicas, std::chrono::seconds(60), {}, "work", &v1::Worker::Stub::PrepareAsyncWorkRange,
      [](auto& /*stream*/) { return absl::OkStatus(); },
      [](auto& stream) {
        for (v1::WorkResponse response; stream.Read(&response);) continue;
        return Malformed("piece", "less than was announced");
      });
}

TEST(RemoteCall, AnAnswerThatDoesNotFitIsTheServersFault) {
  const absl::Status status = CallThatEndsWith(grpc::Status::OK);
  EXPECT_EQ(status.code(), absl::StatusCode::kInternal) << status;
  EXPECT_EQ(DetailOf(status).metadata.at("stage"), "work");
}

// A stage that dies during its answer must not be reported as a stage with a wrong answer.
TEST(RemoteCall, AnAnswerThatIsCutOffIsOfAServerThatWentAway) {
  const absl::Status status =
      CallThatEndsWith(grpc::Status(grpc::StatusCode::UNAVAILABLE, "Socket closed"));
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_TRUE(WasLost(status)) << status;
}

// A job that calls such a server, during an upgrade or at a wrong address, waits for the right
// server.
TEST(RemoteCall, AServerWithoutTheMethodIsOfAnotherBuild) {
  const absl::Status status = CallThatEndsWith(grpc::Status(grpc::StatusCode::UNIMPLEMENTED, ""));
  EXPECT_EQ(DetailOf(status).reason, Reason::kBuildMismatch) << status;
  EXPECT_EQ(DetailOf(status).metadata.at("stage"), "work");
  EXPECT_TRUE(IsReplicasFault(status)) << "another replica may be the right one";
}

// Otherwise a call that kills stages would be tried as often as a call to an unreachable stage.
TEST(RemoteCall, OnlyACallThatWasUnderWayIsLost) {
  const absl::Status stops = rpc::FromGrpc(rpc::ToGrpc(
      MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "Socket closed")));
  EXPECT_FALSE(WasLost(CallThatEndsWith(rpc::ToGrpc(stops)))) << "its server says why";
  SingleReplica nobody(rpc::MakeChannel("127.0.0.1:1"));
  const absl::Status away = nobody.Call({}, [](const auto& channel) {
    grpc::ClientContext context;
    v1::WorkerInfo info;
    return OutcomeOf("work", std::chrono::seconds(60),
                     rpc::FromGrpc(v1::Worker::NewStub(channel)->GetWorkerInfo(
                         &context, v1::GetWorkerInfoRequest(), &info)));
  });
  EXPECT_TRUE(absl::IsUnavailable(away)) << away;
  EXPECT_FALSE(WasLost(away)) << away;
}

}  // namespace
}  // namespace slicefarm::coordinator::remote_call_test
