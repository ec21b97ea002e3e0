#include "common/wire/stage_jobs_wire.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/stage/exposure_job.h"
#include "common/stage/motion_job.h"
#include "common/stage/ordering_job.h"
#include "common/wire/fields/fields.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::stage_jobs_wire_test {
namespace {

std::vector<Copy> Copies() { return {{0, {}, 0}, {1, {2'000, -3'000}, 4}}; }

BeadingTable Beading() {
  BeadingTable table(2);
  table[1].perimeters = 7;
  return table;
}

InfillTable Infill() {
  InfillTable table(2);
  table[1].density = 0.7;
  return table;
}

OrderingJob Ordering() {
  OrderingJob job;
  auto& [options, copies] = job;
  options.infill_first = true;
  options.walls = {{true, false}, {false, true}};
  copies = Copies();
  return job;
}

MotionJob Motion() {
  MotionJob job;
  auto& [options, facts] = job;
  // The value after 100 % would be refused.
  options.tool().cooling.max_fan_percent = 50;
  options.tool().cooling.bridge_fan_percent = 50;
  options.speeds.resize(2);
  options.speeds[1].small_perimeter_speed_mm_s = 7;
  facts = {40, {{"a", 0, 0, 1}, {"b", 1, 0, 2}}, {{}, {3, 2, 1'000}}};
  return job;
}

ExposureJob Exposure() {
  ExposureJob job;
  auto& [settings, copies] = job;
  settings.regions.resize(2);
  // Skins have a distance of their own, because the value after 0 would be refused.
  for (ExposureOptions& region : settings.regions)
    region.upskin_distance_nm = region.downskin_distance_nm = 90'000;
  settings.regions[1].spot_nm = 7;
  settings.output.layer = 3;
  copies = Copies();
  return job;
}

TEST(StageJobsWire, Return) {
  ExpectReturns<v1::BeadingTable>(Beading());
  ExpectReturns<v1::InfillTable>(Infill());
  ExpectReturns<v1::OrderingJob>(Ordering());
  ExpectReturns<v1::MotionJob>(Motion());
  ExpectReturns<v1::ExposureJob>(Exposure());
}

TEST(StageJobsWire, EveryFieldChangedAloneReturns) {
  // A shift increased by one nanometre is no whole micrometre.
  ExpectEveryChangeReturns<v1::OrderingJob, OrderingJob>(ProtoOf<v1::OrderingJob>(Ordering()),
                                                         {"options", "shift"});
  // Object "a" has only one copy, so a second copy is refused.
  ExpectEveryChangeReturns<v1::MotionJob, MotionJob>(ProtoOf<v1::MotionJob>(Motion()),
                                                     {"options", "facts.copies[0].copy"});
  ExpectEveryChangeReturns<v1::ExposureJob, ExposureJob>(ProtoOf<v1::ExposureJob>(Exposure()),
                                                         {"settings", "shift"});
}

TEST(StageJobsWire, RefuseTablesThatNoJobHas) {
  ExpectMalformed(FromProto(v1::BeadingTable()).status(), "rows.value 1");
  auto beading = ProtoOf<v1::BeadingTable>(Beading());
  BeadingTable no_walls = Beading();
  no_walls[1].perimeters = -1;
  beading.set_rows(PackFields(no_walls));
  ExpectMalformed(FromProto(beading).status(), "rows.walls[1].perimeters");
  auto infill = ProtoOf<v1::InfillTable>(Infill());
  infill.set_rows(PackFields(InfillTable(1'001)));
  EXPECT_EQ(DetailOf(FromProto(infill).status()).reason, Reason::kRequestTooLarge);
  auto exposure = ProtoOf<v1::ExposureJob>(Exposure());
  exposure.set_settings(PackFields(ExposureSettings{.regions = {}, .output = {}}));
  ExpectMalformed(FromProto(exposure).status(), "settings.regions");
}

TEST(StageJobsWire, RefuseCopiesAndFactsThatNoJobHas) {
  auto ordering = ProtoOf<v1::OrderingJob>(Ordering());
  ordering.mutable_copies(1)->set_pass(-1);
  ExpectMalformed(FromProto(ordering).status(), "copies[1].pass");
  ordering = ProtoOf<v1::OrderingJob>(Ordering());
  while (ordering.copies_size() <= 1'000) *ordering.add_copies() = ordering.copies(0);
  EXPECT_EQ(DetailOf(FromProto(ordering).status()).reason, Reason::kRequestTooLarge);
  ordering = ProtoOf<v1::OrderingJob>(Ordering());
  ordering.clear_options();
  ExpectMalformed(FromProto(ordering).status(), "options.value 1");
  auto motion = ProtoOf<v1::MotionJob>(Motion());
  motion.mutable_facts()->set_layer_count(-1);
  ExpectMalformed(FromProto(motion).status(), "facts.layer_count");
  auto exposure = ProtoOf<v1::ExposureJob>(Exposure());
  while (exposure.copies_size() <= 1'000) *exposure.add_copies() = exposure.copies(0);
  EXPECT_EQ(DetailOf(FromProto(exposure).status()).reason, Reason::kRequestTooLarge);
}

TEST(SharedWire, AValueIsSentByItsDigestAndReadOnce) {
  const Shared<InfillTable> table = Infill();
  const auto& part = PartOf(table);
  ASSERT_TRUE(part.ok()) << part.status();
  EXPECT_EQ((*part)->kind, "slicefarm.v1.InfillTable");
  EXPECT_EQ(&PartOf(Shared<InfillTable>(table)), &part);
  EXPECT_EQ((*PartOf(Shared<InfillTable>(Infill())))->digest, (*part)->digest);
  SharedCache cache(1 << 20);
  const auto take = [&] { return TakeShared<InfillTable>(cache, (*part)->digest, "start.shared"); };
  EXPECT_EQ(MissingDigest(take().status()), (*part)->digest);
  cache.Put(**part);
  const auto taken = take();
  ASSERT_TRUE(taken.ok()) << taken.status();
  EXPECT_EQ(**taken, Infill());
  EXPECT_EQ(&**take(), &**taken);
}

TEST(SharedWire, NamesTheFieldOfWhatCannotBe) {
  SharedCache cache(1 << 20);
  ExpectMalformed(TakeShared<InfillTable>(cache, "0123", "start.shared").status(), "start.shared");
  const std::string kind = "slicefarm.v1.InfillTable";
  const std::string no_message = "\xff", no_rows;
  for (const std::string& bytes : {no_message, no_rows})
    cache.Put({kind, SharedDigest(kind, bytes), bytes});
  const auto refusal = [&](const std::string& bytes) {
    return TakeShared<InfillTable>(cache, SharedDigest(kind, bytes), "start.shared").status();
  };
  ExpectMalformed(refusal(no_message), "start.shared.bytes");
  ExpectMalformed(refusal(no_rows), "start.shared.rows.value 1");
}

}  // namespace
}  // namespace slicefarm::stage_jobs_wire_test
