#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "common/base/from_environment_test.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/infill/algo/inside_checks_test.h"
#include "services/infill/algo/solid.h"
#include "services/infill/algo/solid_raster_test.h"
#include "services/infill/algo/sparse.h"

/// Tests of all patterns on random regions: with holes, islands in holes, slivers, parts that
/// touch. Environment:
///   SLICEFARM_FILL_REGIONS   number of regions for each pattern (40)
///   SLICEFARM_FILL_SEED      first seed (1); to repeat a failure: its seed, and 1 region
namespace slicefarm::infill::random_regions_test {
namespace {

/// Returns one or two islands, often cut by a thin slit or joined at a corner.
MultiPolygon RandomRegion(std::mt19937& random) {
  MultiPolygon region =
      RandomIsland(random, {FromMm(Uniform(random, -40, 40)), 0}, Uniform(random, 0.4, 25));
  if (random() % 3 == 0)
    region = Union(region, RandomIsland(random, {0, FromMm(Uniform(random, -20, 20))},
                                        Uniform(random, 0.2, 12)));
  if (random() % 3 == 0) {
    const Coord x = FromMm(Uniform(random, -20, 20)), w = FromMm(Uniform(random, 0.001, 0.6));
    region = Difference(
        region,
        {{{{x, -FromMm(30)}, {x + w, -FromMm(30)}, {x + w, FromMm(30)}, {x, FromMm(30)}}, {}}});
  }
  return region;
}

/// Returns random lines for patterns that planning lays out.
std::vector<Polyline> RandomLines(std::mt19937& random) {
  std::vector<Polyline> lines;
  const auto coord = [&] { return FromMm(Uniform(random, -50, 50)); };
  const auto at = [&] { return Point{coord(), coord()}; };
  for (int i = 0; i < 40; ++i) lines.push_back({at(), at(), at()});
  return lines;
}

TEST(RandomRegions, AreFilledInsideTheSameEachTime) {
  const uint64_t count = FromEnvironment("SLICEFARM_FILL_REGIONS", 40);
  const uint64_t seed = FromEnvironment("SLICEFARM_FILL_SEED", 1);
  for (const FillPatternInfo& info : kFillPatterns) {
    for (uint64_t i = seed; i < seed + count; ++i) {
      SCOPED_TRACE(std::string(info.name) + " seed " + std::to_string(i));
      std::mt19937 random(static_cast<uint32_t>(i));
      const MultiPolygon region = RandomRegion(random);
      const std::vector<Polyline> planned =
          info.planned ? RandomLines(random) : std::vector<Polyline>{};
      const SparseFill sparse{.pattern = info.pattern,
                              .density = Uniform(random, 0.05, 0.9),
                              .angle_rad = Uniform(random, 0, 3),
                              .layer = static_cast<int32_t>(i % 100),
                              .z_nm = FromMm(Uniform(random, 0, 50)),
                              .overlap_nm = 112'500,
                              .anchor_nm = 2'700'000,
                              .anchor_max_nm = 50'000'000,
                              .planned = planned};
      if (info.sparse) {
        const auto paths = FillSparse(region, sparse);
        ASSERT_TRUE(paths.ok());
        ExpectInside(*paths, region);
        EXPECT_EQ(*paths, *FillSparse(region, sparse));
      }
      if (info.solid == SolidFillStyle::kNone || region.empty()) continue;
      const SolidFill solid{.pattern = info.pattern,
                            .angle_rad = sparse.angle_rad,
                            .layer = sparse.layer,
                            .overlap_nm = 112'500};
      const auto group = FillSolid(region[0], solid);
      ASSERT_TRUE(group.ok());
      ExpectInside(group->paths, {region[0]});
      if (info.solid == SolidFillStyle::kLines) {
        const Flow flow = FlowOf(group->paths, solid.height_nm);
        EXPECT_LE(flow.jumps, 2 * flow.length_m);
        EXPECT_GE(flow.narrowest_nm, 240'000);
      }
      EXPECT_EQ(*group, *FillSolid(region[0], solid));
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace slicefarm::infill::random_regions_test
