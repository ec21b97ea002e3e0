#include "services/planning/algo/infill/infill_areas.h"

#include <gtest/gtest.h>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "services/planning/algo/infill/sparse_areas.h"
#include "services/planning/algo/infill/stacks_test.h"

namespace slicefarm::planning::infill_areas_test {
namespace {

double Mm2(const MultiPolygon& region) { return Area(region) * 1e-12; }

// A tunnel of 4 mm through a block. Above the tunnel, infill rests on solid infill. Below the
// tunnel, infill supports solid infill.
TEST(LeaveOutUnneeded, OnlyWhatCarriesSomethingIsLeft) {
  const ObjectStack stack = StackOf(30, [](int i) {
    return MakePolygonsOrDie(i < 20 ? "(0 0, 30 0, 30 10, 0 10)" : "(0 0, 10 0, 10 10, 0 10)");
  });
  const auto areas = SparseAreas(stack, InnerAreas(stack, 1'000'000), {2, 2});
  const auto roofs = RoofsOf(areas);
  std::vector<InfillAreas> infill_areas(stack.size());
  LeaveOutUnneeded(areas, roofs, 900'000, 500'000, infill_areas);
  // In this model every place has a top above it.
  for (size_t i = 0; i < stack.size(); ++i)
    EXPECT_NEAR(Mm2(Intersection(areas[i], infill_areas[i].left_out)), 0, 1e-6) << i;
}

TEST(LeaveOutUnneeded, ConesThatWidenUpwardsNeedLittleNearTheBed) {
  // A wedge that opens upwards. Everything to the right of the narrow foot overhangs the bed.
  const ObjectStack stack = StackOf(40, [](int i) {
    const Coord right = FromMm(10 + 0.2 * i);
    return MultiPolygon{{{{0, 0}, {right, 0}, {right, FromMm(10)}, {0, FromMm(10)}}, {}}};
  });
  const auto areas = SparseAreas(stack, InnerAreas(stack, 1'000'000), {2, 2});
  std::vector<MultiPolygon> roofs(stack.size());
  roofs[20] = MakePolygonsOrDie("(2 2, 5 2, 5 5, 2 5) ; (6 6, 6.3 6, 6.3 8, 6 8)");
  std::vector<InfillAreas> infill_areas(stack.size());
  LeaveOutUnneeded(areas, roofs, 900'000, 500'000, infill_areas);
  EXPECT_NEAR(Mm2(Difference(areas[21], infill_areas[21].left_out)), 0, 1e-6);
  for (const size_t i : {20u, 10u, 5u})  // the sliver needs no infill
    EXPECT_NEAR(Mm2(Difference(areas[i], infill_areas[i].left_out)), 9, 1e-3) << i;
}

TEST(CombineLayers, TheLastOfEachStretchPrintsWhatAllShare) {
  const ObjectStack stack = StackOf(12, [](int i) {
    return MakePolygonsOrDie(i < 6 ? "(0 0, 20 0, 20 10, 0 10)" : "(0 0, 10 0, 10 10, 0 10)");
  });
  const auto areas = SparseAreas(stack, InnerAreas(stack, 1'000'000), {1, 1});
  std::vector<InfillAreas> infill_areas(stack.size());
  CombineLayers(stack, areas, 3, 1'800'000, infill_areas);
  // Groups: layers 1-3, 4-6, 7-9. Layers 10 and 11 are too few for another group.
  for (const size_t i : {0u, 10u, 11u}) {
    EXPECT_TRUE(infill_areas[i].left_out.empty()) << i;
    EXPECT_TRUE(infill_areas[i].combined.empty()) << i;
  }
  for (const size_t i : {3u, 6u, 9u}) {
    EXPECT_TRUE(infill_areas[i].left_out.empty()) << i;
    EXPECT_EQ(infill_areas[i].combined_height_nm, 3 * kStackHeight) << i;
    const double shared = i == 3 ? 18 * 8 : 8 * 8;
    EXPECT_NEAR(Mm2(Intersection(infill_areas[i].combined, areas[i])), shared, 1e-6) << i;
    // Layer 4 is 10 mm longer. Layer 5 has 1 mm more beside its skin, which is too narrow.
    for (const size_t k : {i - 1, i - 2})
      EXPECT_NEAR(Mm2(Difference(areas[k], infill_areas[k].left_out)), k == 4 ? 10 * 8 : 0, 1e-6)
          << k;
  }
}

// On a slope each layer has an extra strip compared with the layer above.
TEST(CombineLayers, StripsWithoutRoomForLinesGoWithWhatIsBesideThem) {
  const ObjectStack stack = StackOf(12, [](int i) {
    const Coord edge = FromMm(20 - 0.3 * i);
    return MultiPolygon{{{{0, 0}, {edge, 0}, {edge, FromMm(10)}, {0, FromMm(10)}}, {}}};
  });
  const auto areas = SparseAreas(stack, InnerAreas(stack, 1'000'000), {1, 1});
  std::vector<InfillAreas> infill_areas(stack.size());
  CombineLayers(stack, areas, 2, 1'800'000, infill_areas);
  int groups = 0;
  for (size_t last = 2; last + 1 < stack.size(); last += 2, ++groups) {
    EXPECT_TRUE(Difference(areas[last], infill_areas[last].combined).empty()) << last;
    EXPECT_TRUE(Difference(areas[last - 1], infill_areas[last - 1].left_out).empty()) << last;
  }
  EXPECT_EQ(groups, 5);
}

}  // namespace
}  // namespace slicefarm::planning::infill_areas_test
