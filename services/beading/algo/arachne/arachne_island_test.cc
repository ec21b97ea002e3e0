#include "services/beading/algo/arachne/arachne_island.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"
#include "common/model/options/beading_options.h"

namespace slicefarm::beading::arachne_island_test {
namespace {

constexpr Coord kHeight = 200'000;
/// Difference between the width of beads side by side and their distance.
constexpr double kOverlapMm = 0.2 * (1 - 3.14159265358979 / 4);

using DecidingRadius = std::function<double(double, double, double)>;

ArachneIslands Islands(int perimeters, bool gap_fill = true, DecidingRadius radius = nullptr) {
  WallPlan plan = WallPlan::Make(perimeters, 450'000, 450'000, kHeight);
  plan.gap_fill = gap_fill;
  return ArachneIslands({}, plan, {}, std::move(radius));
}

IslandBeads IslandOf(std::string_view outline, const ArachneIslands& islands) {
  const auto island = islands.Make(MakePolygonsOrDie(outline)[0], {});
  EXPECT_TRUE(island.ok() && island->has_value());
  return island.ok() && *island ? **island : IslandBeads{};
}

std::string Strip(double thickness_mm) {
  const std::string y = std::to_string(thickness_mm);
  return "(0 0, 20 0, 20 " + y + ", 0 " + y + ")";
}

double Mm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }

struct StripCase {
  std::string name;
  double thickness_mm;
  std::vector<double> rings_mm;  ///< bead widths of rings
  std::vector<double> lines_mm;
};
class ThinStrip : public testing::TestWithParam<StripCase> {};

// Beads of width w side by side cover w each, minus the overlap of neighbours.
TEST_P(ThinStrip, HasBeadsThatFillIt) {
  const StripCase& strip = GetParam();
  const IslandBeads island = IslandOf(Strip(strip.thickness_mm), Islands(3));
  std::vector<double> rings_mm, lines_mm;
  for (const Path& wall : island.walls) {
    ASSERT_EQ(wall.widths_nm.size(), 1u);
    (wall.closed ? rings_mm : lines_mm).push_back(ToMm(static_cast<double>(wall.widths_nm[0])));
    EXPECT_EQ(wall.feature, wall.inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter);
  }
  const auto expect_near = [](const std::vector<double>& got, const std::vector<double>& want) {
    ASSERT_EQ(got.size(), want.size());
    for (size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], want[i], 5e-6);
  };
  expect_near(rings_mm, strip.rings_mm);
  expect_near(lines_mm, strip.lines_mm);
  EXPECT_TRUE(island.fill_area.empty());
}

INSTANTIATE_TEST_SUITE_P(
    ArachneIslands, ThinStrip,
    testing::Values(StripCase{"TooThin", 0.095, {}, {}}, StripCase{"Widened", 0.105, {}, {0.34}},
                    StripCase{"OneBead", 0.4, {}, {0.4}},
                    // Two beads of at least 0.34 mm need 0.68 mm minus an overlap.
                    StripCase{"OneWideBead", 0.63, {}, {0.63}},
                    StripCase{"TwoNarrowBeads", 0.64, {(0.64 + kOverlapMm) / 2}, {}},
                    StripCase{"TwoBeads", 0.8, {(0.8 + kOverlapMm) / 2}, {}},
                    StripCase{"ThreeBeads", 1.2, {0.45}, {1.2 - 2 * 0.45 + 2 * kOverlapMm}},
                    StripCase{"FourBeads", 1.6, {0.45, (1.6 - 2 * 0.45 + 3 * kOverlapMm) / 2}, {}}),
    [](const auto& info) { return info.param.name; });

TEST(ArachneIslands, AWallLiesHalfItsWidthInsideTheOutline) {
  const IslandBeads island = IslandOf(Strip(0.8), Islands(3));
  ASSERT_EQ(island.walls.size(), 1u);
  const Box box = Bounds(island.walls[0].points);
  const double inset = FromMm((0.8 + kOverlapMm) / 4);
  EXPECT_NEAR(box.min.x, inset, 2);
  EXPECT_NEAR(box.min.y, inset, 2);
  EXPECT_NEAR(box.max.x, 20'000'000 - inset, 2);
  EXPECT_NEAR(box.max.y, 800'000 - inset, 2);
}

TEST(ArachneIslands, AWideSquareHasWallsOfConstantWidth) {
  const IslandBeads island = IslandOf("(0 0, 20 0, 20 20, 0 20)", Islands(3));
  ASSERT_EQ(island.walls.size(), 3u);
  for (int inset = 0; inset < 3; ++inset) {
    const Path& wall = island.walls[inset];
    EXPECT_EQ(wall.inset, inset);
    EXPECT_EQ(wall.feature, inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter);
    EXPECT_TRUE(wall.closed);
    ASSERT_EQ(wall.widths_nm, std::vector<Coord>{450'000});
    const double side = 20 - 0.45 - 2 * inset * (0.45 - kOverlapMm);
    EXPECT_NEAR(SignedArea(wall.points) / 1e12, side * side, 1e-3);
  }
  const double side = 20 - 2 * (3 * 0.45 - 2.5 * kOverlapMm);
  EXPECT_NEAR(Mm2(island.fill_area), side * side, 1e-3);
}

TEST(ArachneIslands, WidthsVaryAlongAWedge) {
  const IslandBeads island = IslandOf("(0 0, 20 -0.1, 20 0.5, 0 0.4)", Islands(3));
  ASSERT_EQ(island.walls.size(), 1u);
  const Path& wall = island.walls[0];
  ASSERT_EQ(wall.widths_nm.size(), wall.points.size());
  for (size_t i = 0; i < wall.points.size(); ++i)
    EXPECT_NEAR(ToMm(wall.widths_nm[i]), 0.4 + 0.01 * ToMm(wall.points[i].x), 0.005);
}

// The remaining width is 1.4 mm minus the walls: too little for infill.
TEST(ArachneIslands, ANarrowFillAreaIsAGap) {
  const double gap_mm = 1.4 - 2 * 0.45 + kOverlapMm;
  const IslandBeads filled = IslandOf(Strip(1.4), Islands(1));
  ASSERT_EQ(filled.walls.size(), 2u);
  EXPECT_EQ(filled.walls[1].feature, Feature::kGapFill);
  ASSERT_EQ(filled.walls[1].widths_nm.size(), 1u);
  EXPECT_NEAR(ToMm(filled.walls[1].widths_nm[0]), gap_mm + kOverlapMm, 1e-3);
  EXPECT_TRUE(filled.fill_area.empty());

  const IslandBeads open = IslandOf(Strip(1.4), Islands(1, false));
  EXPECT_EQ(open.walls.size(), 1u);
  EXPECT_NEAR(Mm2(open.fill_area), gap_mm * (20 - 1.4 + gap_mm), 1e-3);
}

// At 0.63 mm, the decision for one bead is very close (see TwoNarrowBeads).
TEST(ArachneIslands, CloseCallsAreTheCallers) {
  constexpr std::string_view kStrip = "(100 50, 120 50, 120 50.63, 100 50.63)";
  int asked = 0;
  const DecidingRadius radius = [&](double x, double y, double radius_nm) {
    ++asked;
    EXPECT_GE(x, 100e6);
    EXPECT_LE(x, 120e6);
    EXPECT_NEAR(y, 50.315e6, 1'000);
    EXPECT_NEAR(radius_nm, 315'000, 1'000);
    return 320'000;
  };
  const IslandBeads island = IslandOf(kStrip, Islands(3, true, radius));
  EXPECT_GT(asked, 0);
  ASSERT_EQ(island.walls.size(), 1u);
  EXPECT_TRUE(island.walls[0].closed);
  EXPECT_NEAR(ToMm(island.walls[0].WidthAt(0)), (0.63 + kOverlapMm) / 2, 1e-5);
}

// The outline is wider than 32 bits of the coarsest grid.
TEST(ArachneIslands, AnIslandWithoutATrustedDiagramIsLeftToOthers) {
  constexpr Coord kLength = 2'200'000 * kNmPerMm;
  const PolygonWithHoles strip = {{{0, 0}, {kLength, 0}, {kLength, 400'000}, {0, 400'000}}, {}};
  const auto island = Islands(3).Make(strip, {});
  ASSERT_TRUE(island.ok()) << island.status();
  EXPECT_FALSE(island->has_value());
}

TEST(ArachneIslands, StopsWhenCancelled) {
  const auto island =
      Islands(1).Make(MakePolygonsOrDie(Strip(1.4))[0], CancelToken([] { return true; }));
  EXPECT_TRUE(absl::IsCancelled(island.status()));
}

double VolumeMm3(const Path& path) {
  double volume = 0;
  const size_t count = path.points.size();
  for (size_t i = 0; i < (path.closed ? count : count - 1); ++i) {
    const size_t next = (i + 1) % count;
    volume += SectionMm2((path.WidthAt(i) + path.WidthAt(next)) / 2, kHeight) *
              ToMm(Distance(path.points[i], path.points[next]));
  }
  return volume;
}

// Beads and infill have the island's volume, except for the stripe along the outline that the round
// sides of the outer beads leave. Around reflex corners beads are arcs; lines end before the end of
// a strip.
TEST(ArachneIslands, VolumeIsConserved) {
  for (const std::string_view text :
       {"(0 0, 20 0, 20 20, 0 20)", "(0 0, 20 0, 20 0.8, 0 0.8)", "(0 0, 20 0, 20 1.6, 0 1.6)",
        "(0 0, 30 0, 30 3, 0 0.5)", "(0 0, 20 0, 20 12, 0 12) (6 2, 14 2, 14 10, 6 10)",
        "(0 0, 12 0, 12 2.2, 7 2.2, 7 14, 5 14, 5 2.2, 0 2.2)"}) {
    const PolygonWithHoles outline = MakePolygonsOrDie(text)[0];
    const IslandBeads island = IslandOf(text, Islands(3));
    double mm2 = Mm2(island.fill_area), stripe_mm2 = 0;
    for (const Path& path : island.walls) mm2 += VolumeMm3(path) / 0.2;
    ForEachRing({outline},
                [&](const Polygon& ring) { stripe_mm2 += Perimeter(ring) / 1e6 * kOverlapMm / 2; });
    const double area_mm2 = Area(outline) / 1e12;
    EXPECT_NEAR(mm2, area_mm2 - stripe_mm2, 0.005 * area_mm2) << text;
  }
}

// Five beads would be a dot within two rings, and the dot has a quarter of the hole's volume.
TEST(ArachneIslands, ARoundPinIsRingsOfItsVolume) {
  constexpr int kCorners = 48;
  PolygonWithHoles pin;
  for (int i = 0; i < kCorners; ++i) {
    const double turn = 2 * std::numbers::pi * i / kCorners;
    pin.outer.push_back({FromMm(1.01 * std::cos(turn)), FromMm(1.01 * std::sin(turn))});
  }
  const auto island = Islands(3).Make(pin, {});
  ASSERT_TRUE(island.ok() && island->has_value());
  double mm2 = 0;
  for (const Path& wall : (*island)->walls) {
    EXPECT_TRUE(wall.closed);
    mm2 += VolumeMm3(wall) / 0.2;
  }
  EXPECT_EQ((*island)->walls.size(), 2u);
  EXPECT_TRUE((*island)->fill_area.empty());
  EXPECT_NEAR(mm2, Area(pin) / 1e12 - Perimeter(pin.outer) / 1e6 * kOverlapMm / 2, 0.01);
}

}  // namespace
}  // namespace slicefarm::beading::arachne_island_test
