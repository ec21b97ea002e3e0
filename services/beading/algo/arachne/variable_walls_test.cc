#include "services/beading/algo/arachne/variable_walls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/text_format_test.h"
#include "services/beading/algo/bead_raster_test.h"
#include "services/beading/algo/strategy/strategy_factory.h"
#include "tests/corpus_slice.h"

namespace slicefarm::beading::variable_walls_test {
namespace {

constexpr Coord kWidth = 500'000;
/// Pixel size that is not a divisor of any width; otherwise edges that meet along a column of
/// pixels would count twice.
constexpr double kPixelNm = 19'937;

/// Returns the settings of Kuipers et al. 2020, section 6.
StrategyOptions Paper(int walls = 0) {
  StrategyOptions options;
  options.outer_width_nm = options.inner_width_nm = kWidth;
  options.min_width_nm = options.min_split_width_nm = options.min_feature_nm = 300'000;
  options.max_width_nm = 2 * kWidth;
  options.distribution_count = 3;
  options.transition_length_nm = 650'000;
  options.max_walls = walls;
  return options;
}

VariableWallOptions WallOptions() {
  VariableWallOptions options;
  options.transition_angle = std::numbers::pi / 4;
  options.transition_length_nm = 650'000;
  options.tolerance_nm = 1'000;
  return options;
}

VariableWalls WallsOrDie(const PolygonWithHoles& island, int max_walls = 0) {
  const auto strategy = MakeStrategy(Paper(max_walls));
  auto walls = MakeVariableWalls(island, *strategy, WallOptions());
  EXPECT_TRUE(walls.has_value());
  return walls ? *std::move(walls) : VariableWalls{};
}

Coverage CoverageOf(const PolygonWithHoles& island, const VariableWalls& walls) {
  BeadRaster raster(island, kPixelNm);
  for (const WallLine& wall : walls.lines) raster.Add(wall.line);
  raster.Add(walls.fill_area);
  return raster.Measure();
}

// Tests of shapes.

struct ShapeCase {
  std::string name;
  std::string outline;
  double underfill;  ///< upper limit, with as many walls as fit
  double overfill;
};

class Shape : public testing::TestWithParam<ShapeCase> {
 protected:
  PolygonWithHoles Island() const { return MakePolygonsOrDie(GetParam().outline).front(); }
};

// The uncovered area is in convex corners, because beads turn with round outer sides there.
TEST_P(Shape, IsFilled) {
  const Coverage coverage = CoverageOf(Island(), WallsOrDie(Island()));
  EXPECT_LE(coverage.underfill, GetParam().underfill);
  EXPECT_LE(coverage.overfill, GetParam().overfill);
  EXPECT_LE(coverage.outside, 0.0002);
}

TEST_P(Shape, IsFilledByWallsAndInfillTogether) {
  const Coverage coverage = CoverageOf(Island(), WallsOrDie(Island(), 2));
  EXPECT_LE(coverage.underfill, GetParam().underfill);
  EXPECT_LE(coverage.overfill, GetParam().overfill);
}

TEST_P(Shape, HasBeadsOfTheWidthsAskedFor) {
  const VariableWalls walls = WallsOrDie(Island());
  ASSERT_FALSE(walls.lines.empty());
  for (const WallLine& wall : walls.lines) {
    ASSERT_EQ(wall.line.points.size(), wall.line.thickness_nm.size());
    ASSERT_GE(wall.line.points.size(), wall.line.closed ? 3u : 2u);
    for (const Coord width : wall.line.thickness_nm) {
      EXPECT_GE(width, 90'000);
      EXPECT_LE(width, 2 * kWidth);
    }
  }
}

TEST_P(Shape, ComesOutTheSameTwice) {
  const VariableWalls once = WallsOrDie(Island(), 2), twice = WallsOrDie(Island(), 2);
  ASSERT_EQ(once.lines.size(), twice.lines.size());
  for (size_t i = 0; i < once.lines.size(); ++i) EXPECT_EQ(once.lines[i].line, twice.lines[i].line);
  EXPECT_EQ(once.fill_area, twice.fill_area);
}

INSTANTIATE_TEST_SUITE_P(
    VariableWalls, Shape,
    testing::Values(
        ShapeCase{"Square", "(0 0, 10 0, 10 10, 0 10)", 0.008, 0.008},
        ShapeCase{"Plate", "(0 0, 20 0, 20 12, 0 12) (6 4, 14 4, 14 8, 6 8)", 0.006, 0.006},
        ShapeCase{"Strip", "(0 0, 30 0, 30 1.7, 0 1.7)", 0.006, 0.006},
        ShapeCase{"Blade", "(0 0, 30 0, 30 0.6, 0 0.6)", 0.004, 0.004},
        ShapeCase{"Wedge", "(0 0, 30 1, 30 5, 0 0.4)", 0.01, 0.01},
        ShapeCase{"Letter", "(0 0, 12 0, 12 2.2, 7 2.2, 7 14, 5 14, 5 2.2, 0 2.2)", 0.012, 0.016},
        ShapeCase{"Stairs", "(0 0, 24 0, 24 3, 18 3, 18 2.4, 12 2.4, 12 1.8, 6 1.8, 6 1.2, 0 1.2)",
                  0.012, 0.016}),
    [](const auto& info) { return info.param.name; });

TEST(VariableWalls, AStripHasTheBeadsOfItsThickness) {
  const struct {
    std::string thickness_mm;
    int closed, open;
  } cases[] = {{"0.5", 0, 1}, {"1", 1, 0}, {"1.5", 1, 1}, {"2", 2, 0}, {"2.5", 2, 1}};
  for (const auto& [thickness, closed, open] : cases) {
    const VariableWalls walls = WallsOrDie(
        MakePolygonsOrDie("(0 0, 30 0, 30 " + thickness + ", 0 " + thickness + ")").front());
    const auto count = [&](bool is_closed) {
      return std::ranges::count_if(
          walls.lines, [&](const WallLine& wall) { return wall.line.closed == is_closed; });
    };
    EXPECT_EQ(count(true), closed) << thickness;
    EXPECT_EQ(count(false), open) << thickness;
    for (const WallLine& wall : walls.lines)
      EXPECT_THAT(wall.line.thickness_nm,
                  testing::Each(testing::AllOf(testing::Ge(kWidth - 2), testing::Le(kWidth + 2))))
          << thickness;
  }
}

// A fill area had vanished with its markers when beads of a wide part were blended with ones of a
// narrow part.
TEST(VariableWalls, ARoomBehindANarrowDoorKeepsItsFillArea) {
  const PolygonWithHoles island =
      MakePolygonsOrDie(
          "(0 0, 20 0, 20 9, 27 9, 27 0, 40 0, 40 20, 27 20, 27 11.4, 20 11.4, 20 20, 0 20)")
          .front();
  const VariableWalls walls = WallsOrDie(island, 2);
  EXPECT_NEAR(Area(walls.fill_area) / 1e12, 18 * 18 + 11 * 18, 6);
}

// Tests of slices of real parts.

struct Totals {
  double underfill = 0, overfill = 0, outside = 0;  ///< areas in mm2
  double area = 0;
  double lines = 0;
};

Totals Measure(const MultiPolygon& slice) {
  Totals totals;
  for (const PolygonWithHoles& island : slice) {
    const VariableWalls walls = WallsOrDie(island);
    const Coverage coverage = CoverageOf(island, walls);
    const double area = Area(island) / 1e12;
    totals.underfill += coverage.underfill * area;
    totals.overfill += coverage.overfill * area;
    totals.outside += coverage.outside * area;
    totals.area += area;
    totals.lines += static_cast<double>(walls.lines.size());
  }
  return totals;
}

constexpr std::string_view kSlices[] = {"ACAM-Base--scaled_outline_mesh0_z1100",
                                        "OpenRC-motor-cover_outline_mesh0_z56700",
                                        "Spec-House-1st-Floor_outline_mesh0_z4900",
                                        "cableChain-XendCover_outline_mesh0_z7700",
                                        "david-scaled_outline_mesh0_z14100",
                                        "gripper-2-controles-independentes_outline_mesh0_z100"};

class OnSlices : public testing::TestWithParam<std::string_view> {
 protected:
  MultiPolygon Read() const { return CorpusSlice(std::string(GetParam()) + ".txt"); }

  void ExpectLike(const Totals& want, const MultiPolygon& changed, const std::string& how) const {
    const Totals got = Measure(changed);
    EXPECT_NEAR(got.underfill / got.area, want.underfill / want.area, 0.0005) << how;
    EXPECT_NEAR(got.overfill / got.area, want.overfill / want.area, 0.0005) << how;
    EXPECT_NEAR(got.lines, want.lines, std::max(1.0, want.lines * 0.02)) << how;
  }
};

template <typename Change>
MultiPolygon Changed(MultiPolygon slice, const Change& change) {
  for (PolygonWithHoles& island : slice) {
    change(island.outer);
    for (Polygon& hole : island.holes) change(hole);
  }
  return slice;
}

Polygon Turned(const Polygon& ring, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  Polygon turned;
  for (const Point p : ring) {
    const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
    turned.push_back({std::llround(c * x - s * y), std::llround(s * x + c * y)});
  }
  return turned;
}

// Small parts are mostly corners; over all 300 slices the shares are 0.0018 and 0.0023
// (tests/bench).
TEST_P(OnSlices, NearlyAllIsCoveredOnce) {
  const Totals totals = Measure(Read());
  EXPECT_LE(totals.underfill, 0.006 * totals.area);
  EXPECT_LE(totals.overfill, 0.008 * totals.area);
  EXPECT_LE(totals.outside, 0.0005 * totals.area);
}

TEST_P(OnSlices, ChangesThatDoNotMatterDoNotMatter) {
  const MultiPolygon slice = Read();
  const Totals want = Measure(slice);
  ExpectLike(want, Changed(slice, [](Polygon& ring) { ring = Turned(ring, 90); }), "turned by 90");
  ExpectLike(want, Changed(slice, [](Polygon& ring) { ring = Turned(ring, 30); }), "turned by 30");
  ExpectLike(want,
             Changed(slice,
                     [](Polygon& ring) {
                       for (Point& p : ring) p.x = -p.x;
                       std::reverse(ring.begin(), ring.end());
                     }),
             "mirrored");
  ExpectLike(want,
             Changed(slice,
                     [](Polygon& ring) {
                       for (Point& p : ring) p = p + Point{1'234'567, -7'654'321};
                     }),
             "moved");
  ExpectLike(want,
             Changed(slice,
                     [](Polygon& ring) {
                       std::rotate(ring.begin(), ring.begin() + std::ssize(ring) / 3, ring.end());
                     }),
             "begun elsewhere");
  ExpectLike(want,
             Changed(slice,
                     [](Polygon& ring) {
                       Polygon more;
                       for (size_t i = 0; i < ring.size(); ++i) {
                         const Point a = ring[i], b = ring[(i + 1) % ring.size()];
                         more.push_back(a);
                         more.push_back({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2});
                       }
                       ring = more;
                     }),
             "with points between");
}

TEST_P(OnSlices, AMicrometreOfNoiseDoesNotMatter) {
  const MultiPolygon slice = Read();
  std::mt19937 random(1);
  const auto jitter = [&](Polygon& ring) {
    for (Point& p : ring)
      p = p + Point{static_cast<Coord>(random() % 2'001) - 1'000,
                    static_cast<Coord>(random() % 2'001) - 1'000};
  };
  ExpectLike(Measure(slice), Changed(slice, jitter), "jittered");
}

INSTANTIATE_TEST_SUITE_P(VariableWalls, OnSlices, testing::ValuesIn(kSlices), [](const auto& info) {
  return std::string(info.param.substr(0, info.param.find_first_of("-_")));
});

}  // namespace
}  // namespace slicefarm::beading::variable_walls_test
