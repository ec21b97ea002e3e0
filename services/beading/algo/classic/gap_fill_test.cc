#include "services/beading/algo/classic/gap_fill.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"

namespace slicefarm::beading::gap_fill_test {
namespace {

std::vector<Path> Fill(std::string_view text, bool along_outline) {
  return *FillGaps({{MakePolygonsOrDie(text)[0], along_outline}}, {}, {});
}

TEST(GapFill, BetweenWallsTheRectangleFillsTheGap) {
  const auto paths = Fill("(0 0, 10 0, 10 0.4, 0 0.4)", false);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].feature, Feature::kGapFill);
  ASSERT_EQ(paths[0].widths_nm.size(), 1u);
  EXPECT_NEAR(Spacing(paths[0].widths_nm[0], 200'000), 400'000, 2);
}

TEST(GapFill, AlongTheOutlineTheBeadStaysInside) {
  const auto paths = Fill("(0 0, 10 0, 10 0.4, 0 0.4)", true);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(paths[0].widths_nm[0], 400'000, 2);
}

TEST(GapFill, ThinBeadsGetTheGapsArea) {
  const auto paths = Fill("(0 0, 10 0, 10 0.1, 0 0.1)", false);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(SectionMm2(paths[0].widths_nm[0], 200'000), 0.1 * 0.2, 1e-5);
}

TEST(GapFill, WidthIsBounded) {
  const auto paths = Fill("(0 0, 10 0, 10 2, 0 2)", true);
  ASSERT_FALSE(paths.empty());
  for (const Path& path : paths)
    for (const Coord width : path.widths_nm) EXPECT_LE(width, 800'000);
}

TEST(GapFill, SliversAndSpecksAreLeftOut) {
  EXPECT_TRUE(Fill("(0 0, 10 0, 10 0.009, 0 0.009)", false).empty());
  EXPECT_TRUE(Fill("(0 0, 0.1 0, 0.1 0.1, 0 0.1)", false).empty());
}

TEST(GapFill, StopsWhenCancelled) {
  const Gap gap = {MakePolygonsOrDie("(0 0, 10 0, 10 0.4, 0 0.4)")[0], false};
  int polls = 0;
  const CancelToken cancel([&] { return ++polls > 2; });
  const auto paths = FillGaps({gap, gap, gap, gap}, {}, cancel);
  EXPECT_TRUE(absl::IsCancelled(paths.status()));
  EXPECT_EQ(polls, 3);
}

TEST(GapFill, AWedgeHasAWidthForEachPoint) {
  const auto paths = Fill("(0 0, 10 -0.3, 10 0.3)", false);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].widths_nm.size(), paths[0].points.size());
  double volume = 0;
  for (size_t i = 1; i < paths[0].points.size(); ++i) {
    const Coord width = (paths[0].WidthAt(i - 1) + paths[0].WidthAt(i)) / 2;
    volume += SectionMm2(width, 200'000) *
              ToMm(std::hypot(paths[0].points[i].x - paths[0].points[i - 1].x,
                              paths[0].points[i].y - paths[0].points[i - 1].y));
  }
  EXPECT_NEAR(volume, 0.2 * 3, 0.2 * 3 * 0.1);
}

struct FillAreaCase {
  std::string name;
  std::string area;
  size_t beads;
  double left_mm2;
};
class NarrowFillArea : public testing::TestWithParam<FillAreaCase> {};

TEST_P(NarrowFillArea, HasTheBeadsThatAreWorthTheirTravel) {
  MultiPolygon area = MakePolygonsOrDie(GetParam().area);
  const double before_mm2 = Area(area) / 1e12;
  const auto paths = FillNarrowParts({}, {}, area);
  ASSERT_TRUE(paths.ok()) << paths.status();
  EXPECT_EQ(paths->size(), GetParam().beads);
  EXPECT_NEAR(Area(area) / 1e12, GetParam().left_mm2, 0.1);
  if (paths->empty() && !area.empty()) {
    EXPECT_EQ(Area(area) / 1e12, before_mm2);
  }
}

// Parts connected to a wider part are left to the infill below 2 mm2. Isolated parts are left empty
// below 0.02 mm2.
INSTANTIATE_TEST_SUITE_P(
    GapFill, NarrowFillArea,
    testing::Values(
        FillAreaCase{"Wide", "(0 0, 9 0, 9 9, 0 9)", 0, 81},
        FillAreaCase{"Strip", "(0 0, 9 0, 9 0.6, 0 0.6)", 1, 0},
        FillAreaCase{"DotAlone", "(0 0, 0.5 0, 0.5 0.5, 0 0.5)", 1, 0},
        FillAreaCase{"SpeckAlone", "(0 0, 0.1 0, 0.1 0.1, 0 0.1)", 0, 0},
        FillAreaCase{"LongEnd", "(0 0, 5 0, 5 2.3, 11 2.3, 11 2.7, 5 2.7, 5 5, 0 5)", 1, 25},
        FillAreaCase{"ShortEnd", "(0 0, 5 0, 5 2.3, 5.9 2.3, 5.9 2.7, 5 2.7, 5 5, 0 5)", 0, 25.36},
        FillAreaCase{"LongNeck",
                     "(0 0, 5 0, 5 2.3, 11 2.3, 11 0, 16 0, 16 5, 11 5, 11 2.7, 5 2.7, "
                     "5 5, 0 5)",
                     1, 50},
        FillAreaCase{"Wedge", "(0 0, 5 0, 8 2.5, 5 5, 0 5)", 0, 32.5},
        FillAreaCase{"EachOnItsOwn", "(0 0, 9 0, 9 0.6, 0 0.6); (0 2, 9 2, 9 9, 0 9)", 1, 63}),
    [](const auto& info) { return info.param.name; });

TEST(NarrowFillAreas, StopsWhenCancelled) {
  MultiPolygon area = MakePolygonsOrDie("(0 0, 9 0, 9 0.6, 0 0.6)");
  const auto paths = FillNarrowParts({}, CancelToken([] { return true; }), area);
  EXPECT_TRUE(absl::IsCancelled(paths.status()));
}

TEST(GapFill, ShortBeadsAreLeftOutIfAskedFor) {
  const Gap gap = {MakePolygonsOrDie("(0 0, 3 0, 3 0.4, 0 0.4)")[0], false};
  GapFillOptions options;
  options.min_length_nm = 2 * kNmPerMm;
  EXPECT_EQ(FillGaps({gap}, options, {})->size(), 1u);
  options.min_length_nm = 4 * kNmPerMm;
  EXPECT_TRUE(FillGaps({gap}, options, {})->empty());
}

TEST(NarrowFillAreas, AreLeftToTheInfillIfAskedFor) {
  const MultiPolygon strips =
      MakePolygonsOrDie("(0 0, 9 0, 9 0.6, 0 0.6); (20 0, 29 0, 29 0.6, 20 0.6)");
  GapFillOptions options;
  options.narrow_parts = false;
  MultiPolygon area = strips;
  EXPECT_TRUE(FillNarrowParts(options, {}, area)->empty());
  EXPECT_EQ(area, strips);
  options.narrow_parts = true;
  const MultiPolygon right = MakePolygonsOrDie("(19 0, 30 0, 30 5, 19 5)");
  options.among = &right;
  EXPECT_EQ(FillNarrowParts(options, {}, area)->size(), 1u);
  EXPECT_EQ(area, MultiPolygon{strips[0]});
}

}  // namespace
}  // namespace slicefarm::beading::gap_fill_test
