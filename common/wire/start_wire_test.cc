#include "common/wire/start_wire.h"

#include <gtest/gtest.h>

#include <vector>

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

// The bindings name every member: a new one does not compile until it is sent here, and so on the
// wire.
template <typename Start>
Start RangeStartOf() {
  Start start;
  auto& [call, shared, range] = start;
  call = Call();
  shared = kDigest;
  range = kRange;
  return start;
}

/// The same of those that know no range.
template <typename Start>
Start StartOf() {
  Start start;
  auto& [call, shared] = start;
  call = Call();
  shared = kDigest;
  return start;
}

BeadStart Bead() { return RangeStartOf<BeadStart>(); }
FillStart Fill() { return RangeStartOf<FillStart>(); }
ExposeStart Expose() { return RangeStartOf<ExposeStart>(); }
OrderStart Order() { return StartOf<OrderStart>(); }
ProgramStart Program() { return StartOf<ProgramStart>(); }

PlanStart Plan() {
  PlanStart start;
  auto& [call, options, copies, object_names] = start;
  call = Call();
  object_names = {"a", "b"};
  options.objects = {{SeamPosition::kRear}, {SeamPosition::kNearest}};
  copies = {{0, {}, {}}, {1, {2'000, -3'000}, {{1, 2}, {3, 4}, {5, 6}}}};
  return start;
}

template <typename Proto, typename Start>
void ExpectReturned(const Start& start) {
  const absl::StatusOr<Start> back = FromProto(ProtoOf<Proto>(start));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->call.job_id, "job-1");
  EXPECT_EQ(back->shared, kDigest);
  if constexpr (requires { back->range; }) {
    EXPECT_EQ(back->range, kRange);
  }
}

TEST(StartWire, StartsReturn) {
  ExpectReturned<v1::BeadStart>(Bead());
  ExpectReturned<v1::FillStart>(Fill());
  ExpectReturned<v1::OrderStart>(Order());
  ExpectReturned<v1::ProgramStart>(Program());
  ExpectReturned<v1::ExposeStart>(Expose());
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
  ExpectEveryChangeReturns<v1::BeadStart, BeadStart>(ProtoOf<v1::BeadStart>(Bead()), {"build_id"});
  ExpectEveryChangeReturns<v1::FillStart, FillStart>(ProtoOf<v1::FillStart>(Fill()), {"build_id"});
  // One nanometre more is no whole micrometre.
  ExpectEveryChangeReturns<v1::PlanStart, PlanStart>(ProtoOf<v1::PlanStart>(Plan()),
                                                     {"build_id", "options", "shift"});
  ExpectEveryChangeReturns<v1::OrderStart, OrderStart>(ProtoOf<v1::OrderStart>(Order()),
                                                       {"build_id"});
  ExpectEveryChangeReturns<v1::ProgramStart, ProgramStart>(ProtoOf<v1::ProgramStart>(Program()),
                                                           {"build_id"});
  ExpectEveryChangeReturns<v1::ExposeStart, ExposeStart>(ProtoOf<v1::ExposeStart>(Expose()),
                                                         {"build_id"});
}

template <typename Start, typename Proto>
void ExpectAnotherBuildIsRefused(const Start& start) {
  auto proto = ProtoOf<Proto>(start);
  proto.mutable_call()->set_build_id("another");
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kBuildMismatch);
  proto.clear_call();
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kBuildMismatch);
}

TEST(StartWire, AnotherBuildIsRefused) {
  ExpectAnotherBuildIsRefused<BeadStart, v1::BeadStart>(Bead());
  ExpectAnotherBuildIsRefused<FillStart, v1::FillStart>(Fill());
  ExpectAnotherBuildIsRefused<PlanStart, v1::PlanStart>(Plan());
  ExpectAnotherBuildIsRefused<OrderStart, v1::OrderStart>(Order());
  ExpectAnotherBuildIsRefused<ProgramStart, v1::ProgramStart>(Program());
}

TEST(StartWire, RefusesRangesThatNoJobHas) {
  auto bead = ProtoOf<v1::BeadStart>(Bead());
  bead.clear_range();
  ExpectMalformed(FromProto(bead).status(), "range");
  auto fill = ProtoOf<v1::FillStart>(Fill());
  fill.mutable_range()->set_last(20'001);
  ExpectMalformed(FromProto(fill).status(), "range");
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
