#include "services/planning/algo/adhesion/brim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::planning::brim_test {
namespace {

constexpr double kPi = std::numbers::pi;

MultiPolygon P(const std::string& text) { return MakePolygonsOrDie(text); }
double Mm2(const MultiPolygon& region) { return Area(region) * 1e-12; }

BrimOptions Options(BrimType type, double width_mm, double separation_mm = 0) {
  return {.type = type, .width_nm = FromMm(width_mm), .separation_nm = FromMm(separation_mm)};
}
BrimOptions Outer(double width_mm, double separation_mm = 0) {
  return Options(BrimType::kOuterOnly, width_mm, separation_mm);
}
std::vector<MultiPolygon> Brims(const std::vector<BrimObject>& objects,
                                const MultiPolygon& bed = {}) {
  auto regions = BrimRegions(objects, bed);
  EXPECT_TRUE(regions.ok()) << regions.status();
  return *std::move(regions);
}

const char kBox[] = "(0 0, 20 0, 20 20, 0 20)";
const char kFrame[] = "(0 0, 40 0, 40 40, 0 40) (5 5, 35 5, 35 35, 5 35)";
const char kNest[] =
    "(0 0, 40 0, 40 40, 0 40) (5 5, 35 5, 35 35, 5 35) ; (16 16, 24 16, 24 24, 16 24)";

TEST(BrimRegions, AreCancelledWhileTheyAreWorkedOut) {
  const std::vector<BrimObject> objects(3, {P(kBox), Outer(4)});
  int polls = 0;
  const CancelToken token([&] { return ++polls > 4; });
  EXPECT_TRUE(absl::IsCancelled(BrimRegions(objects, {}, token).status()));
  EXPECT_EQ(polls, 5);
}

struct Case {
  std::string name;
  std::string outlines;
  BrimOptions options;
  double mm2;
};

/// Returns the area of a brim of width w and separation s around a square, in mm2.
double AroundMm2(double side, double s, double w) {
  return 4 * side * w + kPi * ((s + w) * (s + w) - s * s);
}
/// Returns the area of a brim inside a square hole, in mm2.
double InsideMm2(double side, double s, double w) {
  return (side - 2 * s) * (side - 2 * s) - (side - 2 * s - 2 * w) * (side - 2 * s - 2 * w);
}

TEST(BrimRegions, OfOneObject) {
  const double around = AroundMm2(40, 0, 2), inside = InsideMm2(30, 0, 2);
  const double pin = AroundMm2(8, 0, 2);
  using enum BrimType;
  const std::vector<Case> cases = {
      {"None", kBox, Options(kNone, 4), 0},
      {"NoWidth", kBox, Outer(0), 0},
      {"Negative", kBox, Outer(-1), 0},
      {"Outer", kBox, Outer(4), AroundMm2(20, 0, 4)},
      {"Apart", kBox, Outer(4, 0.3), AroundMm2(20, 0.3, 4)},
      {"Thin", kBox, Outer(0.19), 0},
      {"HalfALine", kBox, Outer(0.21), AroundMm2(20, 0, 0.21)},
      {"FrameOuter", kFrame, Outer(2), around},
      {"FrameInner", kFrame, Options(kInnerOnly, 2), inside},
      {"FrameInnerApart", kFrame, Options(kInnerOnly, 2, 0.5), InsideMm2(30, 0.5, 2)},
      {"FrameBoth", kFrame, Options(kOuterAndInner, 2), around + inside},
      {"BoxInner", kBox, Options(kInnerOnly, 2), 0},
      {"HoleFilledUp", kFrame, Options(kInnerOnly, 30), 900},
      {"NestOuter", kNest, Outer(2), around},
      {"NestInner", kNest, Options(kInnerOnly, 2), inside + pin},
      {"NestBoth", kNest, Options(kOuterAndInner, 2), around + inside + pin},
  };
  for (const Case& c : cases) {
    const std::vector<MultiPolygon> brims = Brims({{P(c.outlines), c.options}});
    ASSERT_EQ(brims.size(), 1u);
    EXPECT_NEAR(Mm2(brims[0]), c.mm2, 0.02 + c.mm2 * 2e-4) << c.name;
  }
}

TEST(BrimRegions, EdgesAreWhereTheSettingsSay) {
  const MultiPolygon box = P(kBox);
  const MultiPolygon brim = Brims({{box, Outer(4, 0.3)}})[0];
  ASSERT_EQ(brim.size(), 1u);
  ASSERT_EQ(brim[0].holes.size(), 1u);
  ForEachBoundaryPoint({{brim[0].outer, {}}}, 1e6,
                       [&](Point p) { EXPECT_NEAR(DistanceToRegion(p, box), 4.3e6, 6'000); });
  ForEachBoundaryPoint({{brim[0].holes[0], {}}}, 1e6,
                       [&](Point p) { EXPECT_NEAR(DistanceToRegion(p, box), 0.3e6, 6'000); });
}

TEST(BrimRegions, EarsAtSharpConvexCornersOnly) {
  const double ear = kPi * 9 * 3 / 4;
  BrimOptions ears = Options(BrimType::kEars, 3);
  ears.ear_detection_nm = 50'000;
  EXPECT_NEAR(Mm2(Brims({{P(kBox), ears}})[0]), 4 * ear, 0.15);
  // An L shape has five convex corners.
  const MultiPolygon bracket = P("(0 0, 30 0, 30 10, 10 10, 10 30, 0 30)");
  EXPECT_NEAR(Mm2(Brims({{bracket, ears}})[0]), 5 * ear, 0.15);
  ears.ear_max_angle_rad = 1.5;
  EXPECT_TRUE(Brims({{P(kBox), ears}})[0].empty());
  // There are no ears in the hole, and none where a fine outline turns slowly.
  ears.ear_max_angle_rad = 2.18;
  EXPECT_NEAR(Mm2(Brims({{P(kFrame), ears}})[0]), 4 * ear, 0.15);
  Polygon circle;
  for (int i = 0; i < 90; ++i)
    circle.push_back({FromMm(9 * std::cos(i * kPi / 45)), FromMm(9 * std::sin(i * kPi / 45))});
  EXPECT_TRUE(Brims({{{{circle, {}}}, ears}})[0].empty());
  ears.separation_nm = FromMm(0.2);
  const MultiPolygon apart = Brims({{P(kBox), ears}})[0];
  EXPECT_EQ(apart.size(), 4u);
  ForEachBoundaryPoint(apart, 5e5,
                       [](Point p) { EXPECT_GT(DistanceToRegion(p, P(kBox)), 0.19e6); });
}

// A tooth reaches into the hole of a frame: it has two sharp corners.
TEST(BrimRegions, EarsInHolesOnlyIfAskedFor) {
  const MultiPolygon toothed =
      P("(0 0, 60 0, 60 60, 0 60) (10 10, 10 50, 50 50, 50 10, 32 10, 32 25, 28 25, 28 10)");
  BrimOptions ears = Options(BrimType::kEars, 3);
  ears.ear_detection_nm = 50'000;
  const double outside = Mm2(Brims({{toothed, ears}})[0]);
  ears.ears_outside_only = false;
  const double both = Mm2(Brims({{toothed, ears}})[0]);
  EXPECT_GT(both, outside + kPi * 9 * 0.75);
  EXPECT_LT(both, outside + 2 * kPi * 9);
}

TEST(BrimRegions, NeighboursShareWhatLiesBetween) {
  const MultiPolygon left = P(kBox), right = P("(24 0, 44 0, 44 20, 24 20)");
  const auto brims = Brims({{left, Outer(4)}, {right, Outer(4)}});
  EXPECT_NEAR(Mm2(Intersection(brims[0], brims[1])), 0, 1e-6);
  const auto alone = Brims({{Union(left, right), Outer(4)}});
  EXPECT_NEAR(Mm2(Union(brims[0], brims[1])), Mm2(alone[0]), 0.02);
  // The first object gets the area.
  EXPECT_TRUE(Inside({FromMm(23), FromMm(10)}, brims[0]));
}

TEST(BrimRegions, KeepOffOthersByTheirSeparation) {
  const MultiPolygon left = P(kBox), right = P("(22 0, 44 0, 44 20, 22 20)");
  const auto brims = Brims({{left, Outer(4)}, {right, Options(BrimType::kNone, 4, 0.5)}});
  EXPECT_TRUE(brims[1].empty());
  EXPECT_TRUE(Inside({FromMm(21.49), FromMm(10)}, brims[0]));
  EXPECT_FALSE(Inside({FromMm(21.51), FromMm(10)}, brims[0]));
}

TEST(BrimRegions, AnObjectInAHoleHasItsOuterBrim) {
  const MultiPolygon frame = P(kFrame), pin = P("(16 16, 24 16, 24 24, 16 24)");
  for (const BrimType type : {BrimType::kOuterOnly, BrimType::kNone}) {
    const auto brims = Brims({{frame, Options(type, 2)}, {pin, Outer(3)}});
    EXPECT_NEAR(Mm2(brims[1]), AroundMm2(8, 0, 3), 0.05);
  }
}

TEST(BrimRegions, PiecesBehindAnotherPartAreLeftOut) {
  // The box's brim would reach through the frame's wall, 1 mm thick, into the frame's hole.
  const MultiPolygon box = P("(-21 0, -1 0, -1 20, -21 20)");
  const MultiPolygon frame = P("(0 0, 40 0, 40 40, 0 40) (1 1, 39 1, 39 39, 1 39)");
  const auto brims = Brims({{box, Outer(8)}, {frame, Options(BrimType::kNone, 0)}});
  EXPECT_FALSE(Inside({FromMm(3), FromMm(10)}, brims[0]));
  EXPECT_TRUE(Inside({FromMm(-0.5), FromMm(10)}, brims[0]));
}

TEST(BrimRegions, StayOnTheBed) {
  const MultiPolygon bed = P("(-1 -50, 100 -50, 100 100, -1 100)");
  const auto brims = Brims({{P(kBox), Outer(4)}}, bed);
  EXPECT_EQ(Bounds(brims[0]).min.x, FromMm(-1));
  EXPECT_EQ(Bounds(brims[0]).max.x, FromMm(24));
}

TEST(BrimRegions, StayOutOfExcludedAreas) {
  const MultiPolygon area = P("(-50 -50, 5 -50, 5 -1, -50 -1)");
  const MultiPolygon bed = Difference(P("(-50 -50, 100 -50, 100 100, -50 100)"), area);
  const auto brims = Brims({{P(kBox), Outer(4)}}, bed);
  EXPECT_TRUE(Intersection(brims[0], area).empty());
  EXPECT_EQ(Bounds(brims[0]).min.x, FromMm(-4));
  EXPECT_EQ(Bounds(brims[0]).min.y, FromMm(-4));
}

TEST(BrimRegions, SurviveHostileInput) {
  EXPECT_TRUE(Brims({}).empty());
  EXPECT_TRUE(Brims({{{}, Outer(4)}})[0].empty());
  const MultiPolygon crumb = {{{{0, 0}, {1, 0}, {1, 1}}, {}}};
  EXPECT_LT(Mm2(Brims({{crumb, Outer(4)}})[0]), kPi * 16 + 0.1);
  // Squares that touch along a side or at a corner, overlap, or are identical.
  for (const char* other : {"(20 0, 40 0, 40 20, 20 20)", "(20 20, 40 20, 40 40, 20 40)",
                            "(10 10, 30 10, 30 30, 10 30)", kBox}) {
    const auto brims = Brims({{P(kBox), Outer(3)}, {P(other), Outer(3)}});
    EXPECT_NEAR(Mm2(Intersection(brims[0], Union(P(kBox), P(other)))), 0, 1e-6) << other;
    EXPECT_NEAR(Mm2(Intersection(brims[0], brims[1])), 0, 1e-6) << other;
    EXPECT_NEAR(Mm2(brims[0]) + Mm2(brims[1]),
                Mm2(Brims({{Union(P(kBox), P(other)), Outer(3)}})[0]), 0.05)
        << other;
  }
  // A part that is only 10 nm thin.
  const auto thin = Brims({{P("(0 0, 20 0, 20 0.00001, 0 0.00001)"), Outer(3)}});
  EXPECT_NEAR(Mm2(thin[0]), 2 * 20 * 3 + kPi * 9, 0.05);
}

struct Plate {
  std::vector<BrimObject> objects;

  MultiPolygon Parts() const {
    MultiPolygon all;
    for (const BrimObject& object : objects) all = Union(all, object.outlines);
    return all;
  }
};

Plate RandomPlate(std::mt19937& random, bool only_outer) {
  Plate plate;
  MultiPolygon taken;
  for (int i = 1 + static_cast<int>(random() % 4); i > 0; --i) {
    const Point middle = RandomPoint(random, {{0, 0}, {40'000'000, 40'000'000}});
    BrimObject object{RandomIsland(random, middle, Uniform(random, 2, 15)), {}};
    object.outlines = Difference(object.outlines, taken);
    taken = Union(taken, object.outlines);
    object.options.type = only_outer ? BrimType::kOuterOnly : static_cast<BrimType>(random() % 5);
    object.options.width_nm = FromMm(Uniform(random, 0.5, 8));
    object.options.separation_nm = FromMm(random() % 2 ? Uniform(random, 0, 0.6) : 0);
    object.options.ear_detection_nm = 50'000;
    plate.objects.push_back(std::move(object));
  }
  return plate;
}

/// Checks a point of i's brim: it has the separation from all objects and is within the width of
/// its own object.
void ExpectInPlace(const Plate& plate, size_t i, Point p, int trial) {
  constexpr double kOff = 10'000;
  for (const BrimObject& other : plate.objects) {
    if (other.outlines.empty()) continue;
    ASSERT_GE(DistanceToBoundary(p, other.outlines),
              static_cast<double>(other.options.separation_nm) - kOff)
        << trial;
  }
  // A piece too thin for its own brim may belong to a neighbour's brim, so any object may reach
  // this point.
  bool reached = false;
  for (size_t k = i; k < plate.objects.size(); ++k) {
    const BrimObject& own = plate.objects[k];
    if (own.outlines.empty() || own.options.type == BrimType::kNone) continue;
    const Coord reach = own.options.type == BrimType::kEars
                            ? own.options.width_nm + own.options.ear_detection_nm
                            : own.options.separation_nm + own.options.width_nm;
    reached |= DistanceToRegion(p, own.outlines) <= static_cast<double>(reach) + kOff;
  }
  ASSERT_TRUE(reached) << trial << " " << ToText(p);
}

TEST(BrimRegions, KeepTheirDistancesOnRandomPlates) {
  std::mt19937 random(21);
  for (int trial = 0; trial < 1000; ++trial) {
    const Plate plate = RandomPlate(random, false);
    const auto brims = Brims(plate.objects);
    const MultiPolygon parts = plate.Parts();
    for (size_t i = 0; i < brims.size(); ++i) {
      ForEachBoundaryPoint(brims[i], 3e6, [&](Point p) { ExpectInPlace(plate, i, p, trial); });
      ASSERT_LT(Mm2(Intersection(brims[i], parts)), 1e-4) << trial;
      for (size_t k = 0; k < i; ++k)
        ASSERT_LT(Mm2(Intersection(brims[i], brims[k])), 1e-4) << trial;
    }
  }
}

MultiPolygon All(const std::vector<MultiPolygon>& brims) {
  MultiPolygon all;
  for (const MultiPolygon& brim : brims) all = Union(all, brim);
  return all;
}

/// Returns true if the nearest object's outer brim must be at p. The point p is at least `slack`
/// away from every limit.
bool MustBeCovered(const Plate& plate, Point p, double slack) {
  double nearest = INFINITY;
  const BrimObject* owner = nullptr;
  for (const BrimObject& object : plate.objects) {
    if (object.outlines.empty()) continue;
    const double distance = DistanceToRegion(p, object.outlines);
    if (distance < static_cast<double>(object.options.separation_nm) + slack) return false;
    if (distance < nearest) owner = &object;
    nearest = std::min(nearest, distance);
  }
  if (owner == nullptr) return false;
  for (const PolygonWithHoles& island : owner->outlines)
    if (Locate(p, island.outer) != Side::kOutside) return false;
  const BrimOptions& options = owner->options;
  return nearest < static_cast<double>(options.separation_nm + options.width_nm) - slack;
}

TEST(BrimRegions, CoverAllThatIsAskedForOnRandomPlates) {
  std::mt19937 random(22);
  int covered = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Plate plate = RandomPlate(random, true);
    const MultiPolygon brims = All(Brims(plate.objects));
    const Box box = Bounds(plate.Parts()).Grown(FromMm(8));
    for (int k = 0; k < 60; ++k) {
      const Point p = RandomPoint(random, box);
      // A quarter of a line, measured at a corner, is 0.16 mm.
      if (!MustBeCovered(plate, p, 0.16e6)) continue;
      ++covered;
      ASSERT_TRUE(Inside(p, brims)) << trial << " " << ToText(p);
    }
  }
  EXPECT_GT(covered, 10'000);
}

TEST(BrimRegions, OfOneObjectAreExactlyWideOnRandomParts) {
  std::mt19937 random(23);
  for (int trial = 0; trial < 1000; ++trial) {
    const MultiPolygon part = RandomIsland(random, {}, Uniform(random, 2, 15));
    const double width = Uniform(random, 0.3, 8), separation = Uniform(random, 0, 0.5);
    const MultiPolygon brim = Brims({{part, Outer(width, separation)}})[0];
    ASSERT_FALSE(brim.empty());
    // Takes the largest piece. The remaining pieces are in bays that are too narrow for a line.
    const auto around = std::max_element(brim.begin(), brim.end(),
                                         [](const PolygonWithHoles& a, const PolygonWithHoles& b) {
                                           return SignedArea(a.outer) < SignedArea(b.outer);
                                         });
    ForEachBoundaryPoint({{around->outer, {}}}, 2e6, [&](Point p) {
      ASSERT_NEAR(DistanceToRegion(p, part), FromMm(width + separation), 10'000) << trial;
    });
  }
}

TEST(BrimRegions, NothingIsThinnerThanHalfALine) {
  std::mt19937 random(24);
  int pieces = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Plate plate = RandomPlate(random, false);
    const std::vector<MultiPolygon> brims = Brims(plate.objects);
    for (const MultiPolygon& brim : brims) {
      for (const PolygonWithHoles& piece : brim) {
        ++pieces;
        // A disc with a diameter of half a line fits into the piece.
        bool fits = false;
        for (int k = 0; k < 4000 && !fits; ++k) {
          const Point p = RandomPoint(random, Bounds(piece.outer));
          fits = Locate(p, piece) == Side::kInside && DistanceToBoundary(p, {piece}) > 0.08e6;
        }
        ASSERT_TRUE(fits) << trial << " " << ToText(piece);
      }
    }
  }
  EXPECT_GT(pieces, 100);
}

TEST(BrimRegions, FollowThePlate) {
  std::mt19937 random(25);
  for (int trial = 0; trial < 100; ++trial) {
    Plate plate = RandomPlate(random, false);
    // A simplified outline may keep other corners when the object is moved.
    for (BrimObject& object : plate.objects) object.options.ear_detection_nm = 0;
    const auto brims = Brims(plate.objects);
    EXPECT_EQ(Brims(plate.objects), brims);
    Plate turned = plate, mirrored = plate, shuffled = plate;
    for (BrimObject& object : turned.objects) object.outlines = QuarterTurned(object.outlines);
    for (BrimObject& object : mirrored.objects) object.outlines = Mirrored(object.outlines);
    std::reverse(shuffled.objects.begin(), shuffled.objects.end());
    const double area = Mm2(All(brims));
    for (const Plate* other : {&turned, &mirrored, &shuffled})
      EXPECT_NEAR(Mm2(All(Brims(other->objects))), area, 0.05 + area * 1e-3) << trial;
  }
}

}  // namespace
}  // namespace slicefarm::planning::brim_test
