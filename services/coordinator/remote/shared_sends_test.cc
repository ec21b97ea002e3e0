#include "services/coordinator/remote/shared_sends.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "common/base/shared/shared_cache.h"
#include "common/model/limits.h"
#include "common/model/scene/scene.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/client/client_call.h"
#include "common/rpc/observe/metrics.h"
#include "common/rpc/server/server.h"
#include "common/rpc/server/shared_store.h"
#include "slicefarm/v1/shared.grpc.pb.h"

namespace slicefarm::coordinator::shared_sends_test {
namespace {

using std::chrono::seconds;

rpc::JsonLog NoLog() {
  return rpc::JsonLog("test", std::make_shared<spdlog::logger>(
                                  "test", std::make_shared<spdlog::sinks::null_sink_mt>()));
}

std::shared_ptr<const SharedBytes> Part(const std::string& bytes) {
  return std::make_shared<const SharedBytes>(
      SharedBytes{"text", SharedDigest("text", bytes), bytes});
}

/// Server that stores values and can be restarted.
struct Host {
  rpc::SharedStore keeper{NoLog()};
  rpc::Metrics metrics;
  rpc::CallMetrics call_metrics{metrics.registry()};
  std::unique_ptr<rpc::Server> server =
      *rpc::Server::Start({.listen = "127.0.0.1:0"}, {&keeper.service()}, call_metrics);
  std::shared_ptr<grpc::Channel> channel =
      rpc::MakeChannel("127.0.0.1:" + std::to_string(server->port()));
};

class SharedSendsTest : public testing::Test {
 protected:
  /// Makes a call that reads all parts.
  absl::Status Attempt(Host& host, const SharedParts& parts) {
    ++attempts_;
    for (const auto& part : parts) {
      const auto taken = host.keeper.cache().Take<std::string>(
          part->digest, "text",
          [](std::string_view bytes) { return absl::StatusOr<std::string>(std::string(bytes)); });
      if (!taken.ok()) return taken.status();
      EXPECT_EQ(**taken, part->bytes);
    }
    return absl::OkStatus();
  }

  absl::Status Call(Host& host, const SharedParts& parts, const StageCall& call = {}) {
    return sends_.Call(host.channel, call, parts, [&] { return Attempt(host, parts); });
  }

  SharedSends sends_{seconds(60)};
  std::atomic<int> attempts_ = 0;
};

TEST_F(SharedSendsTest, WhatAServerDoesNotKeepIsSentOnce) {
  Host host;
  const SharedParts parts = {Part("a"), Part("b"), Part("")};
  EXPECT_EQ(Call(host, parts), absl::OkStatus());
  EXPECT_EQ(attempts_, 4) << "one for each that is missing, and one more";
  EXPECT_EQ(Call(host, parts), absl::OkStatus());
  EXPECT_EQ(attempts_, 5);
  EXPECT_EQ(host.keeper.cache().counts().entries, 3);
}

TEST_F(SharedSendsTest, AServerInItsPlaceIsSentItAgain) {
  const SharedParts parts = {Part("a")};
  for (int i = 0; i < 2; ++i) {
    Host host;
    EXPECT_EQ(Call(host, parts), absl::OkStatus());
    EXPECT_EQ(host.keeper.cache().counts().entries, 1);
  }
}

TEST_F(SharedSendsTest, ManyPiecesArriveAsOne) {
  Host host;
  std::string bytes;
  for (int64_t i = 0; i < 3 * limits::kSharedPieceBytes + 7; ++i)
    bytes += static_cast<char>(i * 31 + i / 251);
  EXPECT_EQ(Call(host, {Part(bytes)}), absl::OkStatus());
}

TEST_F(SharedSendsTest, CallsThatMissTheSameSendItOnce) {
  Host host;
  const SharedParts parts = {Part(std::string(20 << 20, 'x'))};
  std::vector<std::jthread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] { EXPECT_EQ(Call(host, parts), absl::OkStatus()); });
  threads.clear();
  EXPECT_EQ(host.keeper.cache().counts().entries, 1);
  EXPECT_LE(attempts_, 16);
}

TEST_F(SharedSendsTest, OtherErrorsAreTheCallers) {
  Host host;
  const absl::Status status =
      sends_.Call(host.channel, {}, {Part("a")}, [] { return absl::InternalError("x"); });
  EXPECT_EQ(status.message(), "x");
  const absl::Status unknown = MakeError(absl::StatusCode::kFailedPrecondition,
                                         Reason::kSharedMissing, "y", {{"digest", "0123"}});
  EXPECT_EQ(sends_.Call(host.channel, {}, {Part("a")}, [&] { return unknown; }), unknown);
}

TEST_F(SharedSendsTest, AServerThatForgetsAtOnceIsOverloaded) {
  Host host;
  const auto part = Part("a");
  const absl::Status missing = MakeError(absl::StatusCode::kFailedPrecondition,
                                         Reason::kSharedMissing, "", {{"digest", part->digest}});
  const absl::Status status = sends_.Call(host.channel, {}, {part}, [&] { return missing; });
  EXPECT_EQ(DetailOf(status).reason, Reason::kOverloaded) << status;
}

TEST_F(SharedSendsTest, ACallThatIsNotWantedEnds) {
  Host host;
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  EXPECT_EQ(Call(host, {Part("a")}, call).code(), absl::StatusCode::kCancelled);
}

/// Returns the server's status for these messages.
absl::Status Keep(Host& host, const std::vector<v1::KeepRequest>& requests) {
  v1::SharedValues::Stub stub(host.channel);
  rpc::StreamCall<v1::KeepRequest, v1::KeepResponse> stream(
      {seconds(60)},
      [&](auto* context, auto* queue) { return stub.PrepareAsyncKeep(context, queue); });
  for (const v1::KeepRequest& request : requests) stream.Write(request);
  stream.WritesDone();
  v1::KeepResponse response;
  stream.Read(&response);
  return stream.Finish();
}

v1::KeepRequest Start(const std::string& bytes, int64_t size) {
  v1::KeepRequest request;
  request.mutable_start()->set_kind("text");
  request.mutable_start()->set_digest(SharedDigest("text", bytes));
  request.mutable_start()->set_size(size);
  return request;
}

v1::KeepRequest Piece(const std::string& bytes) {
  v1::KeepRequest request;
  request.set_piece(bytes);
  return request;
}

TEST(SharedStore, RefusesWhatIsNotWhatItsDigestPromises) {
  Host host;
  EXPECT_EQ(DetailOf(Keep(host, {Start("abc", 3), Piece("abd")})).reason,
            Reason::kBlobDigestMismatch);
  EXPECT_FALSE(host.keeper.cache().Has(SharedDigest("text", "abc")));
  EXPECT_EQ(Keep(host, {Start("abc", 3), Piece("a"), Piece("bc")}), absl::OkStatus());
  EXPECT_TRUE(host.keeper.cache().Has(SharedDigest("text", "abc")));
  EXPECT_EQ(Keep(host, {Start("abc", 3)}), absl::OkStatus()) << "it is there";
}

TEST(SharedStore, RefusesWhatCannotBe) {
  Host host;
  v1::KeepRequest no_digest = Start("abc", 3), no_kind = no_digest;
  no_digest.mutable_start()->set_digest("../abc");
  no_kind.mutable_start()->clear_kind();
  const std::vector<std::vector<v1::KeepRequest>> calls = {
      {},
      {Piece("abc")},
      {no_digest, Piece("abc")},
      {no_kind, Piece("abc")},
      {Start("abc", -1), Piece("abc")},
      {Start("abc", 2), Piece("abc")},
      {Start("abc", 4), Piece("abc")},
      {Start("abc", 3), Start("abc", 3), Piece("abc")},
  };
  for (size_t i = 0; i < calls.size(); ++i)
    EXPECT_EQ(DetailOf(Keep(host, calls[i])).reason, Reason::kRequestMalformed) << i;
  const ErrorDetail detail = DetailOf(Keep(host, {Start("abc", int64_t{1} << 40)}));
  EXPECT_EQ(detail.reason, Reason::kRequestTooLarge);
  EXPECT_EQ(detail.metadata.at("limit"), std::to_string(limits::kMaxSharedBytes));
  EXPECT_EQ(host.keeper.cache().counts().entries, 0);
}

}  // namespace
}  // namespace slicefarm::coordinator::shared_sends_test
