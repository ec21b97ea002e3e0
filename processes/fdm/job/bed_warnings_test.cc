#include "processes/fdm/job/bed_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "common/model/paths_test.h"

namespace slicefarm::coordinator::bed_warnings_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A bed of 100 mm with a cup on the left, a lid on the right, and a second lid in the middle.
class BedWarningsTest : public testing::Test {
 protected:
  std::vector<std::string> Of(const JobPlan& plan) const {
    return BedWarnings(plan, bed_, copies_, names_);
  }

  /// Returns a plan that adds only this stack.
  static JobPlan With(StackKind kind, MultiPolygon outlines, int32_t object = kPlateObject) {
    JobPlan plan;
    AddedStack& added = plan.stacks.emplace_back();
    added.stack = Stack(3, object, kind);
    added.sections.emplace_back().regions = {{Role::kRaft, 0, 0, std::move(outlines)}};
    return plan;
  }
  static JobPlan With(StackKind kind, std::string_view outlines) {
    return With(kind, MakePolygonsOrDie(outlines));
  }
  static JobPlan WithSkirt(std::vector<Path> loops) {
    JobPlan plan;
    plan.skirt = {std::move(loops), 2};
    return plan;
  }

  static Polygon Ring(std::string_view text) { return MakePolygonsOrDie(text)[0].outer; }

  const MultiPolygon bed_ = {{Ring("(0 0, 100 0, 100 100, 0 100)"), {}}};
  const std::vector<PlacedCopy> copies_ = {{0, {}, Ring("(2 40, 12 40, 12 50, 2 50)")},
                                           {1, {}, Ring("(90 40, 99 40, 99 50, 90 50)")},
                                           {1, {}, Ring("(50 40, 60 40, 60 50, 50 50)")}};
  const std::vector<std::string> names_ = {"cup", "lid"};
};

TEST_F(BedWarningsTest, NothingAtTheEdgeNothingToSay) {
  EXPECT_THAT(Of(With(StackKind::kBrim, "(1 39, 13 39, 13 51, 1 51)")), IsEmpty());
  EXPECT_THAT(Of(WithSkirt({MakePathOrDie("(1 39, 99 39, 99 51)", true)})), IsEmpty());
  EXPECT_THAT(Of({}), IsEmpty());
}

TEST_F(BedWarningsTest, NamesTheObjectWhoseBrimIsCut) {
  EXPECT_THAT(Of(With(StackKind::kBrim, "(0 39, 13 39, 13 51, 0 51)")),
              ElementsAre("cup: the brim reaches the edge of the bed and is cut there"));
  EXPECT_THAT(
      Of(With(StackKind::kBrim, "(0 39, 13 39, 13 51, 0 51) ; (89 39, 100 39, 100 51, 89 51)")),
      ElementsAre("cup, lid: the brim reaches the edge of the bed and is cut there"));
}

TEST_F(BedWarningsTest, NamesTheObjectWhoseRaftIsCut) {
  EXPECT_THAT(Of(With(StackKind::kRaft, "(89 39, 100 39, 100 51, 89 51)")),
              ElementsAre("lid: the raft reaches the edge of the bed and is cut there"));
}

TEST_F(BedWarningsTest, WhatIsAnObjectsOwnIsNotInPlateCoordinates) {
  EXPECT_THAT(Of(With(StackKind::kRaft, MakePolygonsOrDie("(89 39, 100 39, 100 51, 89 51)"), 1)),
              IsEmpty());
}

TEST_F(BedWarningsTest, ASkirtThatIsOpenWasCut) {
  std::vector<Path> loops = {MakePathOrDie("(0.3 39, 50 30, 50 60, 0.3 51)", false)};
  EXPECT_THAT(Of(WithSkirt(loops)),
              ElementsAre("cup: the skirt reaches the edge of the bed and is cut there"));
  loops.push_back(MakePathOrDie("(1 39, 99 39, 99 51)", true));
  EXPECT_THAT(Of(WithSkirt(loops)),
              ElementsAre("cup: the skirt reaches the edge of the bed and is cut there"));
}

TEST_F(BedWarningsTest, NamesAFewOfManyObjects) {
  std::vector<PlacedCopy> copies;
  std::vector<std::string> names;
  MultiPolygon brims;
  for (int32_t i = 0; i < 7; ++i) {
    const Coord x = FromMm(5 + 12 * i);
    copies.push_back({i, {}, {{x, FromMm(5)}, {x + FromMm(5), FromMm(5)}, {x, FromMm(9)}}});
    names.push_back("part " + std::to_string(i));
    brims.push_back({{{x, 0}, {x + FromMm(5), 0}, {x, FromMm(5)}}, {}});
  }
  EXPECT_THAT(BedWarnings(With(StackKind::kBrim, brims), bed_, copies, names),
              ElementsAre("part 0, part 1, part 2, part 3, part 4 and 2 more: the brim reaches the "
                          "edge of the bed and is cut there"));
}

TEST_F(BedWarningsTest, WithoutABedNothingIsCut) {
  const JobPlan plan = With(StackKind::kBrim, "(0 39, 13 39, 13 51, 0 51)");
  EXPECT_THAT(BedWarnings(plan, {}, copies_, names_), IsEmpty());
}

}  // namespace
}  // namespace slicefarm::coordinator::bed_warnings_test
