#include "services/coordinator/remote/remote_call.h"

#include <gtest/gtest.h>

#include <utility>

#include "common/base/error.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/remote/fake_replica_test.h"

namespace slicefarm::coordinator::remote_call_test {
namespace {

/// A call whose server sends nothing and ends it with `end`, of a caller who needs more than that.
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

// A stage that is killed while it answers has not answered what does not fit.
TEST(RemoteCall, AnAnswerThatIsCutOffIsOfAServerThatWentAway) {
  const absl::Status status =
      CallThatEndsWith(grpc::Status(grpc::StatusCode::UNAVAILABLE, "the connection broke"));
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
}

}  // namespace
}  // namespace slicefarm::coordinator::remote_call_test
