#include "processes/laser/wire/laser_work.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::laser_work_test {
namespace {

constexpr LayerRange kRange{3, 5};

std::vector<Copy> Copies() { return {{0, {}, 0}, {1, {2'000, -3'000}, 4}}; }

LaserWork Work() {
  LaserWork work;
  auto& [settings, range, copies] = work;
  settings.regions = {{}, {}};
  for (ExposureOptions& region : settings.regions)
    region.upskin_distance_nm = region.downskin_distance_nm = 90'000;
  settings.regions[1].spot_nm = 7;
  settings.output.layer = 3;
  range = kRange;
  copies = Copies();
  return work;
}

TEST(LaserWork, Returns) {
  const absl::StatusOr<LaserWork> back = FromProto(ProtoOf<v1::LaserWork>(Work()));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->settings, Work().settings);
  EXPECT_EQ(back->range, kRange);
  EXPECT_EQ(back->copies, Copies());
  ExpectEveryChangeReturns<v1::LaserWork, LaserWork>(ProtoOf<v1::LaserWork>(Work()), {"shift"});
}

TEST(LaserWork, RefusesWhatNoJobHas) {
  auto work = ProtoOf<v1::LaserWork>(Work());
  work.clear_range();
  ExpectMalformed(FromProto(work).status(), "range");
  work = ProtoOf<v1::LaserWork>(Work());
  work.mutable_settings()->clear_regions();
  ExpectMalformed(FromProto(work).status(), "settings.regions");
  work = ProtoOf<v1::LaserWork>(Work());
  while (work.copies_size() <= 1'000) *work.add_copies() = work.copies(0);
  EXPECT_EQ(DetailOf(FromProto(work).status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::laser_work_test
