#include "common/wire/start_wire.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/wire/plan_start_wire.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::start_wire_test {
namespace {

constexpr LayerRange kRange{3, 5};

StageCall Call() {
  StageCall call;
  call.job_id = "job-1";
  return call;
}

constexpr char kDigest[] = "00112233";

// The structured bindings name every member. A new member does not compile until it is added here,
// and thereby to the message.
StageStart Start() {
  StageStart start;
  auto& [call, shared, range] = start;
  call = Call();
  shared = kDigest;
  range = kRange;
  return start;
}

PlanStart Plan() {
  PlanStart start;
  auto& [call, options, copies, object_names] = start;
  call = Call();
  object_names = {"a", "b"};
  options.objects = {{SeamPosition::kRear}, {SeamPosition::kNearest}};
  copies = {{0, {}, {}}, {1, {2'000, -3'000}, {{1, 2}, {3, 4}, {5, 6}}}};
  return start;
}

TEST(StartWire, StartsReturn) {
  StageStart start = Start();
  for (const LayerRange range : {kRange, LayerRange{}}) {
    start.range = range;
    const absl::StatusOr<StageStart> back = FromProto(ProtoOf<v1::StageStart>(start));
    ASSERT_TRUE(back.ok()) << back.status();
    EXPECT_EQ(back->call.job_id, "job-1");
    EXPECT_EQ(back->shared, kDigest);
    EXPECT_EQ(back->range, range);
  }
}

TEST(StartWire, PlanReturns) {
  const absl::StatusOr<PlanStart> plan = FromProto(ProtoOf<v1::PlanStart>(Plan()));
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_EQ(plan->call.job_id, "job-1");
  EXPECT_EQ(plan->options, Plan().options);
  EXPECT_EQ(plan->copies, Plan().copies);
  EXPECT_EQ(plan->object_names, Plan().object_names);
}

TEST(StartWire, EveryFieldChangedAloneReturns) {
  ExpectEveryChangeReturns<v1::StageStart, StageStart>(ProtoOf<v1::StageStart>(Start()),
                                                       {"build_id"});
  // A shift increased by one nanometre is no whole micrometre.
  ExpectEveryChangeReturns<v1::PlanStart, PlanStart>(ProtoOf<v1::PlanStart>(Plan()),
                                                     {"build_id", "options", "shift"});
}

template <typename Proto, typename Start>
void ExpectAnotherBuildIsRefused(const Start& start) {
  auto proto = ProtoOf<Proto>(start);
  proto.mutable_call()->set_build_id("another");
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kBuildMismatch);
  proto.clear_call();
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kBuildMismatch);
}

TEST(StartWire, AnotherBuildIsRefused) {
  ExpectAnotherBuildIsRefused<v1::StageStart>(Start());
  ExpectAnotherBuildIsRefused<v1::PlanStart>(Plan());
}

TEST(StartWire, RefusesRangesThatNoJobHas) {
  auto start = ProtoOf<v1::StageStart>(Start());
  start.mutable_range()->set_last(20'001);
  ExpectMalformed(FromProto(start).status(), "range");
  start.mutable_range()->set_last(start.range().first());
  ExpectMalformed(FromProto(start).status(), "range");
  start.mutable_range()->set_first(-1);
  ExpectMalformed(FromProto(start).status(), "range");
}

TEST(StartWire, RefusesMoreCopiesThanAJobMayHave) {
  auto plan = ProtoOf<v1::PlanStart>(Plan());
  while (plan.copies_size() <= 1'000) *plan.add_copies() = plan.copies(0);
  EXPECT_EQ(DetailOf(FromProto(plan).status()).reason, Reason::kRequestTooLarge);
}

TEST(StartWire, RefusesNamesThatNoJobHas) {
  auto plan = ProtoOf<v1::PlanStart>(Plan());
  plan.set_object_names(1, std::string(256, 'a'));
  EXPECT_EQ(DetailOf(FromProto(plan).status()).reason, Reason::kRequestTooLarge);
  plan = ProtoOf<v1::PlanStart>(Plan());
  while (plan.object_names_size() <= 1'000) plan.add_object_names("a");
  EXPECT_EQ(DetailOf(FromProto(plan).status()).reason, Reason::kRequestTooLarge);
}

TEST(StartWire, RefusesCopiesThatNoJobHas) {
  auto plan = ProtoOf<v1::PlanStart>(Plan());
  plan.mutable_copies(1)->set_object(-1);
  ExpectMalformed(FromProto(plan).status(), "copies[1].object");
}

}  // namespace
}  // namespace slicefarm::start_wire_test
