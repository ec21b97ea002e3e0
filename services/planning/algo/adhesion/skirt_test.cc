#include "services/planning/algo/adhesion/skirt.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"

namespace slicefarm::planning::skirt_test {
namespace {

constexpr SkirtOptions kOne{.loops = 1};

constexpr double kPi = std::numbers::pi;

MultiPolygon P(const std::string& text) { return MakePolygonsOrDie(text); }

const MultiPolygon& Box20() {
  static const auto* box = new MultiPolygon(P("(0 0, 20 0, 20 20, 0 20)"));
  return *box;
}

/// Returns the loops of all skirts, one skirt after the other.
std::vector<Path> LoopsOf(const MultiPolygon& parts, const MultiPolygon& brims,
                          const SkirtOptions& options) {
  std::vector<Path> all;
  for (const std::vector<Path>& loops : SkirtLoops(parts, brims, options))
    all.insert(all.end(), loops.begin(), loops.end());
  return all;
}

double Mm(const Path& path) { return ToMm(PathLength(path)); }

struct Case {
  std::string name;
  SkirtOptions options;
  MultiPolygon parts, brims;
  /// Distances of the centre lines from the 20 mm box, as printed.
  std::vector<double> distances_mm;
};

TEST(SkirtLoops, BeginInTheDirectionOfTheSetting) {
  for (const double degrees : {-135.0, -90.0, 0.0, 30.0, 180.0, 225.0}) {
    SkirtOptions options{.loops = 2};
    options.start_angle_rad = degrees * kPi / 180;
    const std::vector<Path> plain = LoopsOf(Box20(), {}, {.loops = 2});
    const std::vector<Path> loops = LoopsOf(Box20(), {}, options);
    ASSERT_EQ(loops.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
      const Point start = loops[i].points.front() - Point{FromMm(10), FromMm(10)};
      const double angle = std::atan2(static_cast<double>(start.y), static_cast<double>(start.x));
      EXPECT_NEAR(std::remainder(angle - options.start_angle_rad, 2 * kPi), 0, 1e-6) << degrees;
      EXPECT_NEAR(PathLength(loops[i]), PathLength(plain[i]), 10);
    }
  }
}

TEST(SkirtLoops, StandWhereTheSettingsSay) {
  const double s = 0.4 - 0.2 * (1 - kPi / 4);
  const MultiPolygon brim = P("(-4 -4, 24 -4, 24 24, -4 24) (0 0, 20 0, 20 20, 0 20)");
  const std::vector<Case> cases = {
      {"Default", {.loops = 1}, Box20(), {}, {6.2}},
      {"Three", {.loops = 3}, Box20(), {}, {6.2 + 2 * s, 6.2 + s, 6.2}},
      {"OutsideOfTheBrim", {.loops = 2}, Box20(), brim, {10.2 + s, 10.2}},
      {"Close", {.loops = 1, .distance_nm = 0}, Box20(), {}, {0.2}},
      {"Wide", {.loops = 2, .width_nm = 600'000}, Box20(), {}, {6.3 + s + 0.2, 6.3}},
      {"ShieldBesideTheBrim",
       {.loops = 1, .distance_nm = 2'000'000, .draft_shield = DraftShield::kLimited},
       Box20(),
       brim,
       {2.2}},
      {"None", {.loops = 0, .min_length_nm = 1'000'000}, Box20(), {}, {}},
      {"NoneForAShield", {.loops = 0, .draft_shield = DraftShield::kEnabled}, Box20(), {}, {}},
      {"NothingToGoRound", {.loops = 1}, {}, {}, {}},
      {"NoSpacing", {.loops = 1, .width_nm = 100'000, .height_nm = 600'000}, Box20(), {}, {}},
  };
  for (const Case& c : cases) {
    const std::vector<Path> loops = LoopsOf(c.parts, c.brims, c.options);
    ASSERT_EQ(loops.size(), c.distances_mm.size()) << c.name;
    for (size_t i = 0; i < loops.size(); ++i) {
      const Box box = Bounds(loops[i].points);
      EXPECT_NEAR(ToMm(static_cast<double>(box.max.x)), 20 + c.distances_mm[i], 1e-3) << c.name;
      EXPECT_NEAR(ToMm(static_cast<double>(box.min.y)), -c.distances_mm[i], 1e-3) << c.name;
    }
  }
}

TEST(SkirtLoops, CornersAreRound) {
  const std::vector<Path> loops = LoopsOf(Box20(), {}, {.loops = 1});
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(Mm(loops[0]), 80 + 2 * kPi * 6.2, 0.05);
  EXPECT_TRUE(loops[0].closed);
  EXPECT_EQ(loops[0].feature, Feature::kSkirt);
  EXPECT_TRUE(WellFormed(loops[0]));
  EXPECT_GT(SignedArea(loops[0].points), 0);
}

TEST(SkirtLoops, GoRoundTheHullOfAll) {
  const MultiPolygon apart = P("(0 0, 5 0, 5 5, 0 5) ; (15 15, 20 15, 20 20, 15 20)");
  const MultiPolygon hull = P("(0 0, 5 0, 20 15, 20 20, 15 20, 0 5)");
  EXPECT_EQ(LoopsOf(apart, {}, kOne), LoopsOf(hull, {}, kOne));
  EXPECT_EQ(LoopsOf(Union(Box20(), apart), {}, kOne), LoopsOf(Box20(), {}, kOne));
}

// PrusaSlicer prints 6 loops for a minimum length of 20 mm of filament.
TEST(SkirtLoops, AreAddedUntilTheLengthIsReached) {
  const SkirtOptions options{.loops = 1, .min_length_nm = 20'000'000};
  const std::vector<Path> loops = LoopsOf(Box20(), {}, options);
  EXPECT_EQ(loops.size(), 6u);
  double filament_mm = 0;
  for (const Path& loop : loops)
    filament_mm += Mm(loop) * SectionMm2(400'000, 200'000) / options.filament_area_mm2;
  EXPECT_GE(filament_mm, 20);
  EXPECT_LT(filament_mm - Mm(loops.front()) * 0.0297, 20);
  EXPECT_EQ(LoopsOf(Box20(), {}, {.loops = 1, .min_length_nm = INT64_MAX / 2}).size(), 500u);
}

TEST(SkirtLoops, SurroundEachObjectUnlessTheyMeet) {
  const SkirtOptions each{.loops = 2, .distance_nm = 2'000'000, .per_object = true};
  const MultiPolygon far = P("(0 0, 10 0, 10 10, 0 10) ; (20 0, 30 0, 30 10, 20 10)");
  const MultiPolygon near = P("(0 0, 10 0, 10 10, 0 10) ; (14 0, 24 0, 24 10, 14 10)");
  const MultiPolygon inside =
      P("(0 0, 30 0, 30 30, 0 30) (1 1, 29 1, 29 29, 1 29) ; (14 14, 16 14, 16 16, 14 16)");
  SkirtOptions one = each;
  one.per_object = false;
  EXPECT_EQ(SkirtLoops(far, {}, one).size(), 1u);
  const auto skirts = SkirtLoops(far, {}, each);
  ASSERT_EQ(skirts.size(), 2u);
  for (size_t i = 0; i < 2; ++i) EXPECT_EQ(skirts[i], SkirtLoops({far[i]}, {}, one).front());
  EXPECT_EQ(SkirtLoops(near, {}, each), SkirtLoops(near, {}, one)) << "they share a skirt";
  EXPECT_EQ(SkirtLoops(inside, {}, each), SkirtLoops(inside, {}, one));
  const MultiPolygon row =
      P("(0 0, 9 0, 9 9, 0 9) ; (10 0, 19 0, 19 9, 10 9) ; (20 0, 29 0, 29 9, 20 9) ; (90 0, 99 0, "
        "99 9, 90 9)");
  EXPECT_EQ(SkirtLoops(row, {}, each).size(), 2u) << "a chain of three, and one";
}

/// Returns islands of 1 mm in rows of 100, 10 mm apart.
MultiPolygon ManyIslands(Coord count) {
  MultiPolygon islands;
  for (Coord i = 0; i < count; ++i) {
    const Point at{FromMm(10) * (i % 100), FromMm(10) * (i / 100)};
    const Coord far = FromMm(1);
    islands.push_back({{at, {at.x + far, at.y}, {at.x + far, at.y + far}, {at.x, at.y + far}}, {}});
  }
  return islands;
}

// A comparison of all pairs would need the boxes of 2 * 10^8 pairs of loops.
TEST(SkirtLoops, SurroundManyObjects) {
  const SkirtOptions each{.loops = 1, .distance_nm = 1'000'000, .per_object = true};
  EXPECT_EQ(SkirtLoops(ManyIslands(20'000), {}, each).size(), 20'000u);
  const SkirtOptions wide{.loops = 1, .distance_nm = 5'000'000, .per_object = true};
  EXPECT_EQ(SkirtLoops(ManyIslands(20'000), {}, wide).size(), 1u);
}

TEST(SkirtLoops, AreCancelled) {
  const SkirtOptions each{.loops = 1, .distance_nm = 1'000'000, .per_object = true};
  for (const int most : {0, 3, 12}) {
    int polls = 0;
    const CancelToken token([&] { return ++polls > most; });
    SkirtLoops(ManyIslands(10), {}, each, token);
    EXPECT_EQ(polls, most + 1);
  }
}

TEST(SkirtLoops, OfAnObjectSurroundItsBrim) {
  const SkirtOptions each{.loops = 1, .per_object = true};
  const MultiPolygon brim = P("(-4 -4, 24 -4, 24 24, -4 24) (0 0, 20 0, 20 20, 0 20)");
  EXPECT_EQ(SkirtLoops(Box20(), brim, each), SkirtLoops(brim, {}, each));
}

TEST(SkirtLayers, AreAllWithAShieldOnly) {
  EXPECT_EQ(SkirtLayers({.loops = 1, .height_layers = 3}, 10), 3);
  EXPECT_EQ(SkirtLayers({.loops = 1, .height_layers = 30}, 10), 10);
  EXPECT_EQ(SkirtLayers({.loops = 1, .height_layers = 0}, 10), 0);
  const auto limited = DraftShield::kLimited, enabled = DraftShield::kEnabled;
  EXPECT_EQ(SkirtLayers({.loops = 1, .height_layers = 3, .draft_shield = limited}, 10), 3);
  EXPECT_EQ(SkirtLayers({.loops = 1, .height_layers = 3, .draft_shield = enabled}, 10), 10);
  EXPECT_EQ(SkirtLayers({.loops = 0, .draft_shield = DraftShield::kEnabled}, 10), 0);
}

TEST(SkirtReach, StepsOverLayersOfSupportsAlone) {
  const auto layer_of = [](std::vector<StackKind> kinds) {
    SlicedLayer layer;
    for (const StackKind kind : kinds) {
      ObjectSection& section = layer.sections.emplace_back();
      section.stack = Stack(0, 0, kind);
      section.regions.resize(1);
    }
    return layer;
  };
  const SkirtOptions options{.loops = 1, .height_layers = 2};
  SkirtReach reach(options);
  EXPECT_TRUE(reach.Next(layer_of({StackKind::kSupport, StackKind::kPart})));
  EXPECT_TRUE(reach.Next(layer_of({StackKind::kSupport})));
  EXPECT_TRUE(reach.Next(layer_of({StackKind::kPart})));
  EXPECT_FALSE(reach.Next(layer_of({StackKind::kSupport})));
  EXPECT_FALSE(reach.Next(layer_of({StackKind::kPart})));
  EXPECT_EQ(reach.layers(), 3);
}

TEST(WithinBed, CutsWhatLeavesTheBed) {
  const MultiPolygon bed = P("(-3 -20, 40 -20, 40 40, -3 40)");
  const std::vector<Path> loops = LoopsOf(Box20(), {}, {.loops = 2, .distance_nm = 2'500'000});
  // Half of the inner loop's line, at 2.7 mm, is inside the bed. The largest allowed distance is
  // 2.8 mm.
  const std::vector<Path> lines = WithinBed(loops, bed);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_EQ(Bounds(lines[0].points).min.x, -2'800'000);
  EXPECT_EQ(lines[1], loops[1]) << "stays as it was";
  for (const Point p : lines[0].points)
    EXPECT_NEAR(DistanceToRegion(p, Box20()), 2.7e6 + 0.357e6, 1e4);
  // A bed with two opposite sides inside the loop cuts it into two pieces. A bed that contains the
  // loop changes nothing.
  EXPECT_EQ(WithinBed(loops, P("(-2.95 -20, 22.95 -20, 22.95 40, -2.95 40)")).size(), 3u);
  EXPECT_EQ(WithinBed(loops, P("(-30 -30, 50 -30, 50 50, -30 50)")), loops);
  EXPECT_TRUE(WithinBed(loops, P("(2 2, 18 2, 18 18, 2 18)")).empty());
}

TEST(WithinBed, KeepsLinesOutOfAnExcludedCorner) {
  const std::vector<Path> loops = LoopsOf(Box20(), {}, {.loops = 2, .distance_nm = 2'500'000});
  const MultiPolygon corner = P("(-30 -30, 5 -30, 5 -1, -30 -1)");
  const MultiPolygon bed = Difference(P("(-30 -30, 50 -30, 50 50, -30 50)"), corner);
  const std::vector<Path> lines = WithinBed(loops, bed);
  ASSERT_EQ(lines.size(), 2u);
  for (const Path& line : lines) {
    EXPECT_FALSE(line.closed);
    for (const Point p : line.points)
      EXPECT_GE(DistanceToRegion(p, corner), line.widths_nm.front() / 2 - 10.0);
  }
}

TEST(ShieldKeepOut, IsTheBandOfItsLoops) {
  const SkirtOptions options{.loops = 2, .draft_shield = DraftShield::kEnabled};
  const std::vector<Path> loops = LoopsOf(Box20(), {}, options);
  const MultiPolygon band = ShieldKeepOut({loops}, options);
  const double s = 0.4 - 0.2 * (1 - kPi / 4), outer = 6.4 + s, inner = 6;
  EXPECT_NEAR(Area(band) * 1e-12, 80 * (outer - inner) + kPi * (outer * outer - inner * inner),
              0.2);
  EXPECT_TRUE(ShieldKeepOut({loops}, {}).empty());
  EXPECT_TRUE(ShieldKeepOut({}, options).empty());
}

TEST(SkirtLoops, SurviveCrumbs) {
  EXPECT_TRUE(LoopsOf({{{{0, 0}, {5, 5}}, {}}}, {}, kOne).empty());
  EXPECT_TRUE(LoopsOf({{{}, {}}}, {}, kOne).empty());
  EXPECT_LE(LoopsOf({{{{0, 0}, {1, 0}, {1, 1}}, {}}}, {}, kOne).size(), 1u);
  EXPECT_EQ(LoopsOf(P("(0 0, 50 0.000001, 100 0)"), {}, kOne).size(), 1u);
}

double Reach(const std::vector<Point>& points, double x, double y) {
  double reach = -INFINITY;
  for (const Point p : points)
    reach = std::max(reach, static_cast<double>(p.x) * x + static_cast<double>(p.y) * y);
  return reach;
}

/// Checks the distance of the loop from the parts in every direction.
void ExpectStandsOut(const Path& loop, const MultiPolygon& parts, double by_nm, int trial) {
  std::vector<Point> points;
  ForEachRing(parts,
              [&](const Polygon& ring) { points.insert(points.end(), ring.begin(), ring.end()); });
  for (int k = 0; k < 48; ++k) {
    const double x = std::cos(2 * kPi * k / 48), y = std::sin(2 * kPi * k / 48);
    ASSERT_NEAR(Reach(loop.points, x, y) - Reach(points, x, y), by_nm, 8'000) << trial;
  }
}

MultiPolygon RandomPlate(std::mt19937& random) {
  MultiPolygon plate;
  for (int i = 1 + static_cast<int>(random() % 4); i > 0; --i) {
    const Point middle = RandomPoint(random, {{0, 0}, {80'000'000, 80'000'000}});
    const MultiPolygon island = RandomIsland(random, middle, Uniform(random, 1, 15));
    plate.insert(plate.end(), island.begin(), island.end());
  }
  return plate;
}

TEST(SkirtLoops, KeepTheirDistanceOnRandomPlates) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 1000; ++trial) {
    const MultiPolygon parts = RandomPlate(random);
    const SkirtOptions options{.loops = 1 + trial % 3,
                               .distance_nm = std::llround(Uniform(random, 0, 9e6)),
                               .width_nm = std::llround(Uniform(random, 3e5, 8e5))};
    const std::vector<Path> loops = LoopsOf(parts, {}, options);
    ASSERT_EQ(loops.size(), static_cast<size_t>(options.loops));
    for (size_t i = 0; i < loops.size(); ++i) {
      const auto turn = static_cast<Coord>(loops.size() - 1 - i);
      const Coord by_nm = options.distance_nm + options.width_nm / 2 +
                          turn * Spacing(options.width_nm, options.height_nm);
      ExpectStandsOut(loops[i], parts, static_cast<double>(by_nm), trial);
    }
  }
}

TEST(SkirtLoops, DoNotDependOnOrderAndFollowTheParts) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    MultiPolygon parts = RandomPlate(random);
    const std::vector<Path> loops = LoopsOf(parts, {}, kOne);
    std::reverse(parts.begin(), parts.end());
    EXPECT_EQ(LoopsOf(parts, {}, kOne), loops);
    EXPECT_NEAR(Mm(LoopsOf(QuarterTurned(parts), {}, kOne)[0]), Mm(loops[0]), 0.01);
    EXPECT_NEAR(Mm(LoopsOf(Mirrored(parts), {}, kOne)[0]), Mm(loops[0]), 0.01);
  }
}

}  // namespace
}  // namespace slicefarm::planning::skirt_test
