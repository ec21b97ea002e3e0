#include "services/planning/algo/supports/planner/plate_solids.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::plate_solids_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr std::string_view kSquare = "(-5 -5, 5 -5, 5 5, -5 5)";
constexpr Coord kClearanceNm = 15 * kNmPerMm;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }
MultiPolygon Bed(double to_x) { return {{{Mm(0, 0), Mm(to_x, 0), Mm(to_x, 200), Mm(0, 200)}, {}}}; }

/// Returns layers in which each object is a square of 10 mm.
std::vector<SlicedLayer> Squares(int32_t objects) {
  std::vector<SlicedLayer> layers = LayersOrDie({kSquare, kSquare, kSquare});
  for (int32_t object = 1; object < objects; ++object)
    for (size_t i = 0; i < layers.size(); ++i)
      layers[i].sections.push_back(SectionOrDie(object, static_cast<int32_t>(i), kSquare));
  return layers;
}

TEST(PlateSolids, AnObjectAloneHasTheRoomAroundIt) {
  const std::vector<SlicedLayer> parts = Squares(1);
  const std::vector<PlacedCopy> copies = {{0, Mm(100, 100), {}}};
  PlateSolids plate(parts, copies);
  const SupportProblem problem = plate.ProblemOf(0, Bed(200), kClearanceNm);
  ASSERT_THAT(problem.part, SizeIs(3));
  EXPECT_EQ(problem.part[2].top_nm, 600'000);
  EXPECT_EQ(problem.part[2].height_nm, 200'000);
  EXPECT_THAT(problem.others, IsEmpty());
  EXPECT_EQ(Bounds(problem.bed), (Box{Mm(-20, -20), Mm(20, 20)}));
}

TEST(PlateSolids, TheBedIsWhatAllCopiesHaveOfIt) {
  const std::vector<SlicedLayer> parts = Squares(1);
  const std::vector<PlacedCopy> copies = {{0, Mm(8, 100), {}}, {0, Mm(190, 100), {}}};
  PlateSolids plate(parts, copies);
  const SupportProblem problem = plate.ProblemOf(0, Bed(200), kClearanceNm);
  EXPECT_EQ(Bounds(problem.bed), (Box{Mm(-8, -20), Mm(10, 20)}));
}

TEST(PlateSolids, WhatStandsAroundAnyCopyIsAroundAll) {
  const std::vector<SlicedLayer> parts = Squares(2);
  const std::vector<PlacedCopy> copies = {
      {0, Mm(50, 50), {}}, {0, Mm(150, 50), {}}, {1, Mm(50, 70), {}}, {1, Mm(170, 50), {}}};
  PlateSolids plate(parts, copies);
  const SupportProblem problem = plate.ProblemOf(0, Bed(200), kClearanceNm);
  ASSERT_THAT(problem.others, SizeIs(2)) << "each near one of the copies";
  ASSERT_THAT(problem.others[0], SizeIs(3));
  EXPECT_EQ(Bounds(*problem.others[0][0].outlines), (Box{Mm(-5, 15), Mm(5, 25)}));
  EXPECT_EQ(Bounds(*problem.others[1][0].outlines), (Box{Mm(15, -5), Mm(25, 5)}));
}

TEST(PlateSolids, CopiesHaveHalfTheWayToEachOther) {
  const std::vector<SlicedLayer> parts = Squares(1);
  const std::vector<PlacedCopy> copies = {{0, Mm(50, 100), {}}, {0, Mm(66, 100), {}}};
  PlateSolids plate(parts, copies);
  const SupportProblem problem = plate.ProblemOf(0, Bed(200), kClearanceNm);
  EXPECT_EQ(Bounds(problem.bed), (Box{Mm(-8, -8), Mm(8, 8)}));
}

TEST(PlateSolids, SupportsOfOthersAreInTheWayToo) {
  const std::vector<SlicedLayer> parts = Squares(2);
  const std::vector<PlacedCopy> copies = {{0, Mm(50, 50), {}}, {1, Mm(50, 70), {}}};
  AddedStack support;
  support.stack = Stack(2, 1, StackKind::kSupport);
  support.sections = {SectionOrDie(1, 0, "(-9 -9, -6 -9, -6 9, -9 9)")};
  support.sections[0].z_nm = 150'000;
  PlateSolids plate(parts, copies);
  plate.Add(support);
  const SupportProblem problem = plate.ProblemOf(0, Bed(200), kClearanceNm);
  ASSERT_THAT(problem.others, SizeIs(2));
  EXPECT_EQ(problem.others[1][0].top_nm, 150'000);
  EXPECT_EQ(Bounds(*problem.others[1][0].outlines), (Box{Mm(-9, 11), Mm(-6, 29)}));
}

TEST(PlateSolids, MarksOfThePartGoAlong) {
  std::vector<SlicedLayer> parts = Squares(1);
  parts[1].sections[0].marks = {{PartRole::kSupportBlocker, MakePolygonsOrDie(kSquare)}};
  const std::vector<PlacedCopy> copies = {{0, Mm(50, 50), {}}};
  PlateSolids plate(parts, copies);
  const SupportProblem problem = plate.ProblemOf(0, {}, kClearanceNm);
  EXPECT_EQ(problem.part[0].blockers, nullptr);
  ASSERT_NE(problem.part[1].blockers, nullptr);
  EXPECT_EQ(problem.part[1].enforcers, nullptr);
}

}  // namespace
}  // namespace slicefarm::planning::plate_solids_test
