#include "common/rpc/status_mapping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "common/base/error.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace slicefarm::rpc::status_mapping_test {
namespace {

using testing::ElementsAre;
using testing::Pair;

constexpr char kInfoUrl[] = "type.googleapis.com/google.rpc.ErrorInfo";

google::rpc::Status DetailsOf(const grpc::Status& status) {
  google::rpc::Status details;
  EXPECT_TRUE(details.ParseFromString(status.error_details()));
  return details;
}

TEST(StatusMapping, OkIsOk) {
  EXPECT_TRUE(ToGrpc(absl::OkStatus()).ok());
  EXPECT_TRUE(FromGrpc(grpc::Status::OK).ok());
}

TEST(StatusMapping, ErrorsCarryErrorInfo) {
  const grpc::Status status =
      ToGrpc(MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshTruncated, "too short",
                       {{"limit", "84"}, {"got", "12"}}));
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(status.error_message(), "too short");
  const google::rpc::Status details = DetailsOf(status);
  EXPECT_EQ(details.code(), 3);
  EXPECT_EQ(details.message(), "too short");
  ASSERT_EQ(details.details_size(), 1);
  EXPECT_EQ(details.details(0).type_url(), kInfoUrl);
  google::rpc::ErrorInfo info;
  ASSERT_TRUE(details.details(0).UnpackTo(&info));
  EXPECT_EQ(info.reason(), "MESH_TRUNCATED");
  EXPECT_EQ(info.domain(), "slicefarm");
  EXPECT_EQ(info.metadata().at("limit"), "84");
  EXPECT_EQ(info.metadata().at("got"), "12");
}

/// Returns the detail of type `Detail`.
template <typename Detail>
Detail Find(const absl::Status& status) {
  Detail found;
  int count = 0;
  const google::rpc::Status proto = DetailsOf(ToGrpc(status));
  for (const google::protobuf::Any& any : proto.details()) {
    if (any.Is<Detail>()) count += any.UnpackTo(&found);
  }
  EXPECT_EQ(count, 1) << Detail::descriptor()->full_name();
  return found;
}

TEST(StatusMapping, WrongFieldsAreNamed) {
  for (const auto& [key, field] : {std::pair("field", "age"), {"setting", "settings.age"}}) {
    const auto bad = Find<google::rpc::BadRequest>(MakeError(absl::StatusCode::kInvalidArgument,
                                                             Reason::kSettingMalformed, "too old",
                                                             {{key, "age"}, {"limit", "3"}}));
    ASSERT_EQ(bad.field_violations_size(), 1);
    EXPECT_EQ(bad.field_violations(0).field(), field);
    EXPECT_EQ(bad.field_violations(0).description(), "too old");
  }
}

TEST(StatusMapping, QuotasAreNamed) {
  const auto quota = Find<google::rpc::QuotaFailure>(
      MakeError(absl::StatusCode::kResourceExhausted, Reason::kQueueFull, "full"));
  ASSERT_EQ(quota.violations_size(), 1);
  EXPECT_EQ(quota.violations(0).subject(), "QUEUE_FULL");
  EXPECT_EQ(quota.violations(0).description(), "full");
}

TEST(StatusMapping, WhatIsMissingIsNamed) {
  const auto failure = Find<google::rpc::PreconditionFailure>(
      MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBlobNotFound, "not uploaded",
                {{"sha256", "ab"}}));
  ASSERT_EQ(failure.violations_size(), 1);
  EXPECT_EQ(failure.violations(0).type(), "BLOB_NOT_FOUND");
  EXPECT_EQ(failure.violations(0).subject(), "blobs/ab");
  EXPECT_EQ(failure.violations(0).description(), "not uploaded");
}

TEST(StatusMapping, EqualErrorsAreEqualBytes) {
  const auto bytes = [] {
    return ToGrpc(LimitError(Reason::kRequestTooLarge, "things", 3, 7)).error_details();
  };
  const std::string first = bytes();
  for (int i = 0; i < 50; ++i) EXPECT_EQ(bytes(), first);
}

TEST(StatusMapping, EveryReasonReturns) {
  for (int i = 0; i <= static_cast<int>(Reason::kInternal); ++i) {
    const auto reason = static_cast<Reason>(i);
    const absl::Status back = FromGrpc(
        ToGrpc(MakeError(absl::StatusCode::kAborted, reason, "message", {{"key", "value"}})));
    EXPECT_EQ(back.code(), absl::StatusCode::kAborted);
    EXPECT_EQ(back.message(), "message");
    EXPECT_EQ(DetailOf(back).reason, reason);
    EXPECT_THAT(DetailOf(back).metadata, ElementsAre(Pair("key", "value")));
  }
}

TEST(StatusMapping, RetryAfterTravelsAsRetryInfo) {
  const grpc::Status status =
      ToGrpc(MakeError(absl::StatusCode::kResourceExhausted, Reason::kOverloaded, "full",
                       {{kRetryAfterMs, "1250"}, {"limit", "4"}}));
  const google::rpc::Status details = DetailsOf(status);
  google::rpc::RetryInfo retry;
  ASSERT_TRUE(details.details(0).UnpackTo(&retry));
  EXPECT_EQ(retry.retry_delay().seconds(), 1);
  EXPECT_EQ(retry.retry_delay().nanos(), 250'000'000);
  EXPECT_THAT(DetailOf(FromGrpc(status)).metadata,
              ElementsAre(Pair("limit", "4"), Pair(kRetryAfterMs, "1250")));
}

TEST(StatusMapping, ARetryInfoThatCannotBeIsBounded) {
  google::rpc::RetryInfo retry;
  retry.mutable_retry_delay()->set_seconds(std::numeric_limits<int64_t>::max());
  google::rpc::Status details;
  details.set_code(8);
  details.add_details()->PackFrom(retry);
  const grpc::Status status(grpc::StatusCode::RESOURCE_EXHAUSTED, "full",
                            details.SerializeAsString());
  EXPECT_THAT(DetailOf(FromGrpc(status)).metadata, ElementsAre(Pair(kRetryAfterMs, "86400000")));
}

TEST(StatusMapping, ErrorsWithoutDetailGetTheReasonOfTheirCode) {
  EXPECT_EQ(DetailOf(FromGrpc(ToGrpc(absl::CancelledError("x")))).reason, Reason::kCancelled);
  EXPECT_EQ(DetailOf(FromGrpc(ToGrpc(absl::UnknownError("x")))).reason, Reason::kInternal);
}

TEST(StatusMapping, WhatStrangersSentFitsIntoTrailers) {
  std::map<std::string, std::string> metadata;
  for (int i = 0; i < 100; ++i) metadata[std::to_string(i)] = std::string(100'000, 'x');
  metadata["field"] = std::string(100'000, 'y');
  const grpc::Status status =
      ToGrpc(MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                       std::string(1'000'000, '\xff'), metadata));
  EXPECT_LT(status.error_message().size() + status.error_details().size(), 8'000)
      << "clients of gRPC take 8 KiB";
  EXPECT_EQ(DetailOf(FromGrpc(status)).reason, Reason::kSettingMalformed);
  EXPECT_THAT(std::string(FromGrpc(status).message()), testing::MatchesRegex("\\?+"));
}

TEST(StatusMapping, ReasonsOfALaterVersionAreInternal) {
  google::rpc::ErrorInfo info;
  info.set_reason("PRINTER_ON_FIRE");
  google::rpc::Status details;
  details.add_details()->PackFrom(info);
  const absl::Status status = FromGrpc(
      grpc::Status(grpc::StatusCode::FAILED_PRECONDITION, "hot", details.SerializeAsString()));
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_EQ(DetailOf(status).reason, Reason::kInternal);
}

struct Library {
  std::string name;
  grpc::Status status;
  absl::StatusCode code;
  Reason reason;
  bool broke = false;
};

class FromLibrary : public testing::TestWithParam<Library> {};

TEST_P(FromLibrary, GetsCodeAndReason) {
  const absl::Status status = FromGrpc(GetParam().status);
  EXPECT_EQ(status.code(), GetParam().code) << status;
  EXPECT_EQ(DetailOf(status).reason, GetParam().reason) << status;
  EXPECT_EQ(DetailOf(status).metadata.contains(kConnectionBroke), GetParam().broke);
}

INSTANTIATE_TEST_SUITE_P(
    Grpc, FromLibrary,
    testing::Values(Library{"NoThreadIsFree",
                            {grpc::StatusCode::RESOURCE_EXHAUSTED, "Server Threadpool Exhausted"},
                            absl::StatusCode::kResourceExhausted,
                            Reason::kOverloaded},
                    Library{"MessageTooLarge",
                            {grpc::StatusCode::RESOURCE_EXHAUSTED,
                             "Received message larger than max (5000000 vs. 4194304)"},
                            absl::StatusCode::kInvalidArgument,
                            Reason::kRequestTooLarge},
                    Library{"ConnectionReset",
                            {grpc::StatusCode::UNKNOWN, "Stream removed"},
                            absl::StatusCode::kUnavailable,
                            Reason::kUnavailable,
                            true},
                    Library{"ServerKilled",
                            {grpc::StatusCode::UNAVAILABLE, "Socket closed"},
                            absl::StatusCode::kUnavailable,
                            Reason::kUnavailable,
                            true},
                    Library{
                        "KilledAndNotBackYet",
                        {grpc::StatusCode::UNAVAILABLE,
                         "failed to connect to all addresses; last error: UNKNOWN: Socket closed"},
                        absl::StatusCode::kUnavailable,
                        Reason::kUnavailable},
                    Library{"StreamReset",
                            {grpc::StatusCode::INTERNAL, "Received RST_STREAM with error code 2"},
                            absl::StatusCode::kUnavailable,
                            Reason::kUnavailable,
                            true},
                    Library{"Refused",
                            {grpc::StatusCode::UNAVAILABLE, "failed to connect to all addresses"},
                            absl::StatusCode::kUnavailable,
                            Reason::kUnavailable},
                    Library{"TimeUp",
                            {grpc::StatusCode::DEADLINE_EXCEEDED, "Deadline Exceeded"},
                            absl::StatusCode::kDeadlineExceeded,
                            Reason::kDeadlineExceeded},
                    Library{"NoSuchMethod",
                            {grpc::StatusCode::UNIMPLEMENTED, ""},
                            absl::StatusCode::kUnimplemented,
                            Reason::kInternal},
                    Library{"BrokenDetails",
                            {grpc::StatusCode::INTERNAL, "x", "\xff\xff"},
                            absl::StatusCode::kInternal,
                            Reason::kInternal}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::rpc::status_mapping_test
