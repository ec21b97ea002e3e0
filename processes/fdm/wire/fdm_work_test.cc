#include "processes/fdm/wire/fdm_work.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/model/paths_test.h"
#include "common/wire/fields/fields.h"
#include "common/wire/support/round_trip_test.h"
#include "processes/fdm/task/fdm_shared.h"

namespace slicefarm::fdm_work_test {
namespace {

constexpr LayerRange kRange{3, 5};

std::vector<Copy> Copies() { return {{0, {}, 0}, {1, {2'000, -3'000}, 4}}; }

// Sets every member. A new member does not compile until it is set here, and thus tested on the
// wire.
FdmWork Work() {
  FdmWork work;
  auto& [range, plans] = work;
  range = kRange;
  plans = {{{1, 2}, false, true, {{0, {3, 4}, Point{9, 9}, {{5, 6}}}}, {}, {}},
           {{7, 8}, true, false, {}, {MakePathOrDie("(0 0, 9 0)")}, {}}};
  return work;
}

FdmShared Job() {
  FdmShared job;
  auto& [settings, copies, facts] = job;
  settings.regions.resize(2);
  settings.regions[1].walls.perimeters = 7;
  settings.regions[1].infill.density = 0.7;
  settings.regions[1].order = {true, false};
  settings.regions[1].motion.small_perimeter_speed_mm_s = 7;
  copies = Copies();
  facts = {40, {{"a", 0, 0, 1}, {"b", 1, 0, 2}}, {{}, {3, 2, 1'000}}};
  return job;
}

TEST(FdmWork, Returns) {
  const absl::StatusOr<FdmWork> work = FromProto(ProtoOf<v1::FdmWork>(Work()));
  ASSERT_TRUE(work.ok()) << work.status();
  EXPECT_EQ(work->range, kRange);
  EXPECT_EQ(work->plans, Work().plans);
  ExpectReturns<v1::FdmShared>(Job());
}

TEST(FdmWork, EveryFieldChangedAloneReturns) {
  // Some changes cannot be accepted: another range has another number of plans, the only copy of
  // "a" has no second one, and one additional nanometre is not a whole micrometre.
  ExpectEveryChangeReturns<v1::FdmWork, FdmWork>(ProtoOf<v1::FdmWork>(Work()), {"range"});
  ExpectEveryChangeReturns<v1::FdmShared, FdmShared>(ProtoOf<v1::FdmShared>(Job()),
                                                     {"settings", "shift", "facts.copies[0].copy"});
}

TEST(FdmWork, RefusesMoreCopiesThanAJobMayHave) {
  auto job = ProtoOf<v1::FdmShared>(Job());
  while (job.copies_size() <= 1'000) *job.add_copies() = job.copies(0);
  EXPECT_EQ(DetailOf(FromProto(job).status()).reason, Reason::kRequestTooLarge);
}

TEST(FdmWork, RefusesWhatDoesNotAddUp) {
  auto work = ProtoOf<v1::FdmWork>(Work());
  work.mutable_plans()->RemoveLast();
  ExpectMalformed(FromProto(work).status(), "plans");
  work = ProtoOf<v1::FdmWork>(Work());
  work.mutable_plans(1)->mutable_paths(0)->clear_feature();
  ExpectMalformed(FromProto(work).status(), "plans[1].paths[0].feature");
  auto job = ProtoOf<v1::FdmShared>(Job());
  FdmSettings no_regions = Job().settings;
  no_regions.regions.clear();
  job.set_settings(PackFields(no_regions));
  ExpectMalformed(FromProto(job).status(), "settings.speeds");
  job = ProtoOf<v1::FdmShared>(Job());
  job.mutable_copies(0)->set_object(1'000);
  ExpectMalformed(FromProto(job).status(), "copies[0].object");
  job = ProtoOf<v1::FdmShared>(Job());
  job.mutable_facts()->mutable_copies(0)->set_copies(0);
  ExpectMalformed(FromProto(job).status(), "facts.copies[0].copy");
}

// A huge range must be refused before memory for its plans is allocated.
TEST(FdmWork, ARangeWithoutItsPlansIsRefused) {
  auto work = ProtoOf<v1::FdmWork>(Work());
  work.mutable_range()->set_first(0);
  work.mutable_range()->set_last(20'000);
  ExpectMalformed(FromProto(work).status(), "plans");
}

}  // namespace
}  // namespace slicefarm::fdm_work_test
