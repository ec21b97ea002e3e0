#include "services/beading/algo/section_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/beading_options.h"
#include "services/beading/algo/local_beading_stage.h"

namespace slicefarm::beading::section_walls_test {
namespace {

double Mm2(const MultiPolygon& area) { return Area(area) * 1e-12; }

/// Returns a square of 20 mm with row 1 of the settings in its right half.
ObjectSection Halves() {
  ObjectSection section{0, 3, 9, 200'000, {}, MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)"), 0, {}};
  section.regions = {{Role::kPart, 0, 0, MakePolygonsOrDie("(0 0, 10 0, 10 20, 0 20)")},
                     {Role::kPart, 1, 0, MakePolygonsOrDie("(10 0, 20 0, 20 20, 10 20)")}};
  return section;
}

WalledSection Walled(const ObjectSection& section, const std::vector<BeadingOptions>& regions,
                     bool on_bed = false) {
  const NeighbourOutlines neighbours({&OutlineOf(section)});
  auto result = WallSection({section, on_bed, neighbours, 0}, regions, {});
  EXPECT_TRUE(result.ok()) << result.status();
  return result->walled;
}

TEST(WallSection, WallsRunOnWhereOnlyTheInfillChanges) {
  const WalledSection walled = Walled(Halves(), {{}, {}});
  ASSERT_EQ(walled.islands.size(), 1u);
  EXPECT_EQ(walled.islands[0].walls.size(), 3u);
  EXPECT_EQ(walled.islands[0].walls,
            Walled({0, 3, 9, 200'000, {{Role::kPart, 0, 0, Halves().whole}}, {}, 0, {}}, {{}})
                .islands[0]
                .walls);
  ASSERT_EQ(walled.islands[0].fill_areas.size(), 2u);
  for (int32_t row : {0, 1}) {
    const FillArea& area = walled.islands[0].fill_areas[static_cast<size_t>(row)];
    EXPECT_EQ(area.settings, row);
    const MultiPolygon inside =
        Intersection(area.area, Halves().regions[static_cast<size_t>(row)].outlines);
    EXPECT_NEAR(Mm2(area.area), Mm2(inside), 1e-6);
  }
  EXPECT_NEAR(Mm2(walled.islands[0].fill_areas[0].area), Mm2(walled.islands[0].fill_areas[1].area),
              1e-6);
}

TEST(WallSection, RegionsWithOtherWallsGetTheirOwn) {
  std::vector<BeadingOptions> regions(2);
  regions[1].perimeters = 1;
  regions[1].wall_class = 1;
  const WalledSection walled = Walled(Halves(), regions);
  ASSERT_EQ(walled.islands.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(walled.islands[i].walls.size(), i == 0 ? 3u : 1u);
    for (const Path& wall : walled.islands[i].walls)
      EXPECT_EQ(wall.settings, static_cast<int32_t>(i));
    ASSERT_EQ(walled.islands[i].fill_areas.size(), 1u);
    EXPECT_EQ(walled.islands[i].fill_areas[0].settings, static_cast<int32_t>(i));
  }
}

TEST(WallSection, OneWallOnTheBed) {
  for (const WallGenerator generator : {WallGenerator::kArachne, WallGenerator::kClassic}) {
    BeadingOptions options;
    options.generator = generator;
    options.one_on_bed = true;
    const std::vector<BeadingOptions> regions(2, options);
    const WalledSection first = Walled(Halves(), regions, true);
    const WalledSection other = Walled(Halves(), regions, false);
    EXPECT_EQ(first.islands[0].walls.size(), 1u);
    EXPECT_EQ(other.islands[0].walls.size(), 3u);
    EXPECT_GT(Mm2(first.islands[0].fill_areas[0].area), Mm2(other.islands[0].fill_areas[0].area));

    options.perimeters = 0;
    EXPECT_TRUE(Walled(Halves(), {options, options}, true).islands[0].walls.empty());
  }
}

TEST(WallSection, OneMoreWallInEverySecondLayer) {
  BeadingOptions options;
  options.alternate_extra = true;
  for (const int32_t layer : {3, 4}) {
    ObjectSection section = Halves();
    section.layer = layer;
    const WalledSection walled = Walled(section, {options, options});
    EXPECT_EQ(walled.islands[0].walls.size(), layer % 2 != 0 ? 4u : 3u);
  }
}

// A strip of 1.2 mm has a line between its walls, 18 mm long.
TEST(WallSection, ShortLinesBetweenWallsAreLeftOut) {
  BeadingOptions options;
  const auto open_lines = [&](int32_t layer) {
    const ObjectSection strip{
        0,
        layer,
        9,
        200'000,
        {{Role::kPart, 0, 0, MakePolygonsOrDie("(0 0, 20 0, 20 1.2, 0 1.2)")}},
        {},
        0,
        {}};
    const WalledSection walled = Walled(strip, {options});
    return std::ranges::count(walled.islands[0].walls, false, &Path::closed);
  };
  ASSERT_GT(open_lines(4), 0);
  options.min_length_factor = 10;
  EXPECT_GT(open_lines(4), 0);
  options.min_length_factor = 90;
  EXPECT_EQ(open_lines(4), 0);
  EXPECT_GT(open_lines(0), 0) << "visible from below";
  EXPECT_GT(open_lines(8), 0) << "visible from above";
  options.generator = WallGenerator::kClassic;
  const auto classic = open_lines(4);
  options.min_length_factor = 0;
  EXPECT_EQ(open_lines(4), classic);
}

TEST(WallSection, LoopsHaveTheOutlineToTheirRight) {
  // The section is a frame with a thin side. So some loops are offsets and others are beads of
  // variable width.
  const MultiPolygon frame =
      MakePolygonsOrDie("(0 0, 30 0, 30 30, 0 30) (1.7 8, 1.7 22, 22 22, 22 8)");
  const ObjectSection section{0, 3, 9, 200'000, {{Role::kPart, 0, 0, frame}}, {}, 0, {}};
  for (const WallGenerator generator : {WallGenerator::kArachne, WallGenerator::kClassic}) {
    BeadingOptions options;
    options.generator = generator;
    int loops = 0;
    const WalledSection walled = Walled(section, {options});
    for (const Path& wall : walled.islands[0].walls) {
      if (!wall.closed || wall.feature == Feature::kGapFill) continue;
      ++loops;
      const Box box = Bounds(wall.points);
      const bool round_hole = box.max.x < FromMm(27);
      EXPECT_EQ(SignedArea(wall.points) < 0, round_hole)
          << wall.inset << " " << static_cast<int>(generator);
    }
    EXPECT_GE(loops, 4);
  }
}

/// Returns the walls of a step: a square of 20 mm with the left half covered by the layer above.
WalledSection WalledStep(const BeadingOptions& options, int32_t layer, int32_t layer_count) {
  ObjectSection section = Halves();
  section.layer = layer;
  section.layer_count = layer_count;
  const MultiPolygon above = MakePolygonsOrDie("(0 0, 10 0, 10 20, 0 20)");
  const NeighbourOutlines neighbours({&OutlineOf(section), &OutlineOf(section), &above});
  auto result = WallSection({section, false, neighbours, 1}, std::vector{options, options}, {});
  EXPECT_TRUE(result.ok()) << result.status();
  return result->walled;
}

double FilledMm2(const WalledSection& walled) {
  double area = 0;
  for (const FillArea& fill : walled.islands[0].fill_areas) area += Mm2(fill.area);
  return area;
}

TEST(WallSection, OneWallWhereNothingLiesAbove) {
  for (const WallGenerator generator : {WallGenerator::kArachne, WallGenerator::kClassic}) {
    BeadingOptions options;
    options.generator = generator;
    const double all = FilledMm2(WalledStep(options, 3, 9));
    options.one_on_top = OneWallOnTop::kSurfaces;
    const WalledSection step = WalledStep(options, 3, 9);
    Coord inner_to = 0;
    std::multiset<int32_t> insets;
    for (const Path& wall : step.islands[0].walls) {
      insets.insert(wall.inset);
      EXPECT_EQ(wall.feature, wall.inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter);
      if (wall.inset > 0)
        for (const Point& p : wall.points) inner_to = std::max(inner_to, p.x);
    }
    EXPECT_EQ(insets, (std::multiset<int32_t>{0, 1, 2}));
    EXPECT_LT(inner_to, 10'000'000) << "inner walls stay under the layer above";
    EXPECT_GT(inner_to, 9'000'000);
    // Three sides of the right half lose two walls, and the step gets two: 20 + 2 * 10 - 20 mm.
    EXPECT_NEAR(FilledMm2(step) - all, 20 * 2 * 0.407, 1.5);
    EXPECT_EQ(WalledStep(options, 8, 9).islands[0].walls.size(), 1u) << "the last layer";

    options.one_on_top = OneWallOnTop::kTopmost;
    EXPECT_NEAR(FilledMm2(WalledStep(options, 3, 9)), all, 1e-6);
    EXPECT_EQ(WalledStep(options, 8, 9).islands[0].walls.size(), 1u);
  }
}

TEST(WallSection, OutermostWallsNameTheirRing) {
  const ObjectSection section{
      0,
      3,
      9,
      200'000,
      {{Role::kPart, 0, 0,
        MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20) (8 8, 8 12, 12 12, 12 8)"
                          " ; (30 0, 40 0, 40 9, 30 9)")}},
      {},
      0,
      {}};
  std::set<int32_t> rings;
  for (const WalledIsland& island : Walled(section, {{}}).islands)
    for (const Path& wall : island.walls)
      if (wall.inset == 0 && wall.closed) rings.insert(wall.ring);
  EXPECT_EQ(rings, (std::set<int32_t>{0, 1, 2}));
}

TEST(WallSection, WhatIsNotThePartIsCalledByItsRole) {
  ObjectSection section = Halves();
  section.stack = Stack(1, kPlateObject, StackKind::kBrim);
  section.regions.resize(1);
  section.regions[0].role = Role::kBrim;
  section.whole = {};
  const auto walled = Walled(section, {{}});
  ASSERT_FALSE(walled.islands.empty());
  for (const Path& wall : walled.islands[0].walls) {
    EXPECT_EQ(wall.feature, Feature::kSkirt);
    EXPECT_EQ(wall.ring, -1);
  }
}

TEST(WallSection, AHollowSectionHasOneWallAndNothingInside) {
  ObjectSection section{0, 3, 9, 200'000, {}, {}, 0, {}};
  section.regions = {{Role::kPart, 0, 0, MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)")}};
  section.hollow = true;
  const WalledSection walled = Walled(section, {{}});
  ASSERT_EQ(walled.islands.size(), 1u);
  ASSERT_EQ(walled.islands[0].walls.size(), 1u);
  EXPECT_TRUE(walled.islands[0].fill_areas.empty());
  const Path& wall = walled.islands[0].walls[0];
  EXPECT_EQ(wall.feature, Feature::kExternalPerimeter);
  EXPECT_NEAR(PathLength(wall) / 1e6, 4 * (20 - .45), 1e-6);
  // If no single loop fits, the region has as many walls as usual, but still nothing inside.
  section.regions[0].outlines = MakePolygonsOrDie("(0 0, 20 0, 20 .6, 0 .6)");
  for (const WalledIsland& island : Walled(section, {{}}).islands)
    EXPECT_TRUE(island.fill_areas.empty());
}

/// Returns the distance of the first wall from the second along y = 10 mm, from the left.
double ApartMm(const BeadingOptions& options) {
  double first = 1e9, second = 1e9;
  const WalledSection walled = Walled(Halves(), {options, options});
  for (const Path& wall : walled.islands[0].walls) {
    const double x = ToMm(Bounds(wall.points).min.x);
    if (wall.inset == 0) first = std::min(first, x);
    if (wall.inset == 1) second = std::min(second, x);
  }
  return second - first;
}

TEST(WallSection, PreciseOuterWallsTouchTheNextWall) {
  for (const WallGenerator generator : {WallGenerator::kArachne, WallGenerator::kClassic}) {
    BeadingOptions options;
    options.generator = generator;
    EXPECT_NEAR(ApartMm(options), 0.4071, 1e-3) << "beads overlap by a tenth";
    options.precise_outer = true;
    EXPECT_NEAR(ApartMm(options), 0.45, 1e-3) << "full widths";
  }
}

/// Returns the number of beads of gap fill in a section with a strip 0.6 mm wide inside its walls.
/// `above`: outlines of the layer above; null: nothing.
int64_t GapBeads(GapFillTarget target, const MultiPolygon* above, const MultiPolygon* below) {
  const ObjectSection section{
      0,  3, 9, 200'000, {{Role::kPart, 0, 0, MakePolygonsOrDie("(0 0, 30 0, 30 2.3, 0 2.3)")}},
      {}, 0, {}};
  BeadingOptions options;
  options.generator = WallGenerator::kClassic;
  options.perimeters = 2;
  options.gap_target = target;
  const NeighbourOutlines neighbours({below, &OutlineOf(section), above});
  const auto result = WallSection({section, false, neighbours, 1}, {{options}}, {});
  EXPECT_TRUE(result.ok()) << result.status();
  int64_t beads = 0;
  for (const WalledIsland& island : result->walled.islands)
    beads += std::ranges::count(island.walls, Feature::kGapFill, &Path::feature);
  return beads;
}

TEST(WallSection, NarrowPartsAreFilledWhereAskedFor) {
  const MultiPolygon wide = MakePolygonsOrDie("(-9 -9, 39 -9, 39 9, -9 9)");
  EXPECT_GT(GapBeads(GapFillTarget::kEverywhere, &wide, &wide), 0);
  EXPECT_EQ(GapBeads(GapFillTarget::kNowhere, nullptr, &wide), 0);
  EXPECT_EQ(GapBeads(GapFillTarget::kTopBottom, &wide, &wide), 0);
  EXPECT_GT(GapBeads(GapFillTarget::kTopBottom, nullptr, &wide), 0);
  const MultiPolygon half = MakePolygonsOrDie("(-9 -9, 15 -9, 15 9, -9 9)");
  EXPECT_GT(GapBeads(GapFillTarget::kTopBottom, &half, &wide), 0);
}

}  // namespace
}  // namespace slicefarm::beading::section_walls_test
