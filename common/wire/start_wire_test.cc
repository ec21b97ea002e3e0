#include "common/wire/start_wire.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/model/paths_test.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::start_wire_test {
namespace {

constexpr LayerRange kRange{3, 5};

StageCall Call() {
  StageCall call;
  call.job_id = "job-1";
  return call;
}

std::vector<Copy> Copies() { return {{0, {}, 0}, {1, {2'000, -3'000}, 4}}; }

JobFacts Facts() { return {40, {{"a", 0, 0, 1}, {"b", 1, 0, 2}}, {{}, {3, 2, 1'000}}}; }

MotionOptions Motion() {
  MotionOptions options;
  // The next value of 100 % would be refused.
  options.cooling.max_fan_percent = 50;
  options.cooling.bridge_fan_percent = 50;
  options.speeds.resize(2);
  options.speeds[1].small_perimeter_speed_mm_s = 7;
  return options;
}

// The bindings name every member: a new one does not compile until it is sent here, and so on the
// wire.
template <typename Start>
Start RangeStartOf() {
  Start start;
  auto& [call, options, range] = start;
  call = Call();
  options.resize(2);
  range = kRange;
  return start;
}

BeadStart Bead() {
  BeadStart start = RangeStartOf<BeadStart>();
  start.options[1].perimeters = 7;
  return start;
}

FillStart Fill() {
  FillStart start = RangeStartOf<FillStart>();
  start.options[1].density = 0.7;
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

OrderStart Order() {
  OrderStart start;
  auto& [call, options, copies] = start;
  call = Call();
  options.infill_first = true;
  options.walls = {{true, false}, {false, true}};
  copies = Copies();
  return start;
}

ProgramStart Program() {
  ProgramStart start;
  auto& [call, options, facts] = start;
  call = Call();
  options = Motion();
  facts = Facts();
  return start;
}

TEST(StartWire, BeadAndFillReturn) {
  const absl::StatusOr<BeadStart> bead = FromProto(ProtoOf<v1::BeadStart>(Bead()));
  ASSERT_TRUE(bead.ok()) << bead.status();
  EXPECT_EQ(bead->call.job_id, "job-1");
  EXPECT_EQ(bead->options, Bead().options);
  EXPECT_EQ(bead->range, kRange);
  const absl::StatusOr<FillStart> fill = FromProto(ProtoOf<v1::FillStart>(Fill()));
  ASSERT_TRUE(fill.ok()) << fill.status();
  EXPECT_EQ(fill->call.job_id, "job-1");
  EXPECT_EQ(fill->options, Fill().options);
  EXPECT_EQ(fill->range, kRange);
}

TEST(StartWire, PlanAndOrderReturn) {
  const absl::StatusOr<PlanStart> plan = FromProto(ProtoOf<v1::PlanStart>(Plan()));
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_EQ(plan->call.job_id, "job-1");
  EXPECT_EQ(plan->options, Plan().options);
  EXPECT_EQ(plan->copies, Plan().copies);
  EXPECT_EQ(plan->object_names, Plan().object_names);
  const absl::StatusOr<OrderStart> order = FromProto(ProtoOf<v1::OrderStart>(Order()));
  ASSERT_TRUE(order.ok()) << order.status();
  EXPECT_EQ(order->call.job_id, "job-1");
  EXPECT_EQ(order->options, Order().options);
  EXPECT_EQ(order->copies, Copies());
}

TEST(StartWire, ProgramReturns) {
  const absl::StatusOr<ProgramStart> program = FromProto(ProtoOf<v1::ProgramStart>(Program()));
  ASSERT_TRUE(program.ok()) << program.status();
  EXPECT_EQ(program->call.job_id, "job-1");
  EXPECT_EQ(program->options, Motion());
  EXPECT_EQ(program->facts, Facts());
}

TEST(StartWire, ExposureReturns) {
  ExposeStart start;
  auto& [call, settings, range, copies] = start;
  call = Call();
  settings.regions.resize(2);
  // Skins of a distance of their own: the next value of 0 would be refused.
  for (ExposureOptions& region : settings.regions)
    region.upskin_distance_nm = region.downskin_distance_nm = 90'000;
  settings.regions[1].spot_nm = 7;
  settings.output.layer = 3;
  range = kRange;
  copies = Copies();
  const absl::StatusOr<ExposeStart> back = FromProto(ProtoOf<v1::ExposeStart>(start));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->call.job_id, "job-1");
  EXPECT_EQ(back->settings, settings);
  EXPECT_EQ(back->range, kRange);
  EXPECT_EQ(back->copies, Copies());
  ExpectEveryChangeReturns<v1::ExposeStart, ExposeStart>(ProtoOf<v1::ExposeStart>(start),
                                                         {"build_id", "shift"});
}

TEST(StartWire, EveryFieldChangedAloneReturns) {
  ExpectEveryChangeReturns<v1::BeadStart, BeadStart>(ProtoOf<v1::BeadStart>(Bead()), {"build_id"});
  ExpectEveryChangeReturns<v1::FillStart, FillStart>(ProtoOf<v1::FillStart>(Fill()), {"build_id"});
  // One nanometre more is no whole micrometre.
  ExpectEveryChangeReturns<v1::PlanStart, PlanStart>(ProtoOf<v1::PlanStart>(Plan()),
                                                     {"build_id", "shift"});
  ExpectEveryChangeReturns<v1::OrderStart, OrderStart>(ProtoOf<v1::OrderStart>(Order()),
                                                       {"build_id", "shift"});
  // The only copy of "a" has no second one.
  ExpectEveryChangeReturns<v1::ProgramStart, ProgramStart>(ProtoOf<v1::ProgramStart>(Program()),
                                                           {"build_id", "facts.copies[0].copy"});
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

TEST(StartWire, RefusesRangesAndTablesThatNoJobHas) {
  auto bead = ProtoOf<v1::BeadStart>(Bead());
  bead.clear_range();
  ExpectMalformed(FromProto(bead).status(), "range");
  bead = ProtoOf<v1::BeadStart>(Bead());
  bead.clear_options();
  ExpectMalformed(FromProto(bead).status(), "options");
  bead = ProtoOf<v1::BeadStart>(Bead());
  bead.mutable_options(1)->set_perimeters(-1);
  ExpectMalformed(FromProto(bead).status(), "options[1].perimeters");
  auto fill = ProtoOf<v1::FillStart>(Fill());
  fill.mutable_range()->set_last(20'001);
  ExpectMalformed(FromProto(fill).status(), "range");
  fill = ProtoOf<v1::FillStart>(Fill());
  while (fill.options_size() <= 1'000) *fill.add_options() = fill.options(0);
  EXPECT_EQ(DetailOf(FromProto(fill).status()).reason, Reason::kRequestTooLarge);
}

/// The reason for which `message` is refused once it has more than 1,000 copies.
template <typename Start>
Reason WithManyCopies(Start message) {
  while (message.copies_size() <= 1'000) *message.add_copies() = message.copies(0);
  return DetailOf(FromProto(message).status()).reason;
}

TEST(StartWire, RefusesMoreCopiesThanAJobMayHave) {
  EXPECT_EQ(WithManyCopies(ProtoOf<v1::PlanStart>(Plan())), Reason::kRequestTooLarge);
  EXPECT_EQ(WithManyCopies(ProtoOf<v1::OrderStart>(Order())), Reason::kRequestTooLarge);
}

TEST(StartWire, RefusesNamesThatNoJobHas) {
  auto plan = ProtoOf<v1::PlanStart>(Plan());
  plan.set_object_names(1, std::string(256, 'a'));
  EXPECT_EQ(DetailOf(FromProto(plan).status()).reason, Reason::kRequestTooLarge);
  plan = ProtoOf<v1::PlanStart>(Plan());
  while (plan.object_names_size() <= 1'000) plan.add_object_names("a");
  EXPECT_EQ(DetailOf(FromProto(plan).status()).reason, Reason::kRequestTooLarge);
}

TEST(StartWire, RefusesCopiesAndFactsThatNoJobHas) {
  auto plan = ProtoOf<v1::PlanStart>(Plan());
  plan.mutable_copies(1)->set_object(-1);
  ExpectMalformed(FromProto(plan).status(), "copies[1].object");
  auto order = ProtoOf<v1::OrderStart>(Order());
  order.mutable_copies(1)->set_pass(-1);
  ExpectMalformed(FromProto(order).status(), "copies[1].pass");
  order = ProtoOf<v1::OrderStart>(Order());
  order.clear_options();
  ExpectMalformed(FromProto(order).status(), "options.travel");
  auto program = ProtoOf<v1::ProgramStart>(Program());
  program.mutable_facts()->set_layer_count(-1);
  ExpectMalformed(FromProto(program).status(), "facts.layer_count");
}

}  // namespace
}  // namespace slicefarm::start_wire_test
