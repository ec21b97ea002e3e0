#include "services/motion/algo/toolpath/simplified_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/rings/simplify.h"
#include "common/model/bead_section.h"
#include "common/model/paths_test.h"
#include "services/motion/algo/toolpath/divided_path.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion::simplified_path_test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

constexpr Coord kTolerance = 12'500;
constexpr Coord kHeight = 200'000;
constexpr double kPi = std::numbers::pi;

SimplifiedPath Simple(const Path& path, bool keep_arcs = false) {
  return Simplified(path, {kTolerance, kHeight, keep_arcs});
}

Point Written(Point p) { return {FromUm(ToUm(p.x)), FromUm(ToUm(p.y))}; }

/// Returns the points as written. A closed path has its start again at the end.
std::vector<Point> Chain(const Path& path) {
  std::vector<Point> chain;
  for (const Point p : path.points) chain.push_back(Written(p));
  if (path.closed) chain.push_back(chain.front());
  return chain;
}

/// Counts the beads that have a length.
size_t BeadCount(const Path& path) {
  const std::vector<Point> chain = Chain(path);
  size_t count = 0;
  for (size_t i = 1; i < chain.size(); ++i) count += chain[i] != chain[i - 1];
  return count;
}

double Plastic(const Path& path) {
  double plastic = 0;
  for (size_t i = path.closed ? 0 : 1; i < path.points.size(); ++i) {
    const size_t before = i == 0 ? path.points.size() - 1 : i - 1;
    plastic += SectionMm2((path.WidthAt(before) + path.WidthAt(i)) / 2, kHeight) *
               ToMm(Distance(path.points[before], path.points[i]));
  }
  return plastic;
}

/// Returns the largest distance of one chain from another, sampled at eight places of each edge.
double Farthest(const std::vector<Point>& chain, const std::vector<Point>& other) {
  double farthest = 0;
  for (size_t i = 1; i < chain.size(); ++i) {
    for (int k = 0; k <= 8; ++k) {
      const Point step = chain[i] - chain[i - 1];
      const Point p = chain[i - 1] + Point{step.x * k / 8, step.y * k / 8};
      double nearest = 1e18;
      for (size_t j = 1; j < other.size(); ++j)
        nearest = std::min(nearest, DistanceToSegment(p, other[j - 1], other[j]));
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

/// Checks the conditions that hold for any path.
void ExpectKept(const Path& path, const std::string& name) {
  const SimplifiedPath simple = Simple(path);
  const std::vector<Point> before = Chain(path), after = Chain(simple.path);
  EXPECT_TRUE(WellFormed(simple.path)) << name;
  EXPECT_EQ(simple.path.closed, path.closed) << name;
  EXPECT_EQ(after.front(), before.front()) << name;
  EXPECT_EQ(after.back(), before.back()) << name;
  EXPECT_LE(BeadCount(simple.path), BeadCount(path)) << name;
  if (path.closed && BeadCount(path) > 2) {
    EXPECT_GE(BeadCount(simple.path), 3) << name;
  }
  constexpr double kRoundingNm = 2;
  EXPECT_LE(Farthest(before, after), kTolerance + kRoundingNm) << name;
  EXPECT_LE(Farthest(after, before), kTolerance + kRoundingNm) << name;
  EXPECT_NEAR(Plastic(simple.path) * simple.flow, Plastic(path), 1e-9 * Plastic(path)) << name;
  EXPECT_EQ(simple.on_arc.size(), simple.path.points.size() - (path.closed ? 0 : 1)) << name;
}

Path OpenPath(std::vector<Point> points, std::vector<Coord> widths = {450'000}) {
  Path path;
  path.points = std::move(points);
  path.widths_nm = std::move(widths);
  return path;
}

Path Circle(double radius_mm, int count, double start = 0) {
  Path path = OpenPath({});
  path.closed = true;
  for (int i = 0; i < count; ++i) {
    const double angle = start + 2 * kPi * i / count;
    path.points.push_back(
        {FromMm(7 + radius_mm * std::cos(angle)), FromMm(9 + radius_mm * std::sin(angle))});
  }
  return path;
}

Coord Below(Coord most, std::mt19937& random) { return static_cast<Coord>(random()) % most; }

/// Returns a smooth curve with noise, with or without varying widths.
Path Curve(uint32_t seed, int count, double noise_nm, bool wanders) {
  std::mt19937 random(seed);
  const auto uniform = [&](double most) {
    return most * (2 * static_cast<double>(random()) / 4294967295.0 - 1);
  };
  Path path = OpenPath({}, {});
  double angle = 0, bend = 0, x = 0, y = 0, width = 450'000;
  for (int i = 0; i < count; ++i) {
    bend = 0.9 * bend + uniform(0.05);
    angle += bend;
    const double step = 20'000 + std::abs(uniform(150'000));
    x += step * std::cos(angle);
    y += step * std::sin(angle);
    if (wanders) width = std::clamp(width + uniform(12'000), 250'000.0, 800'000.0);
    path.points.push_back(
        {std::llround(x + uniform(noise_nm)), std::llround(y + uniform(noise_nm))});
    path.widths_nm.push_back(std::llround(width));
  }
  if (!wanders) path.widths_nm = {450'000};
  return path;
}

struct LineCase {
  std::string name, points, simple;
};

TEST(Simplified, Lines) {
  const std::vector<LineCase> cases = {
      {"two points", "(0 0, 5 0)", "(0 0, 5 0)"},
      {"on a line", "(0 0, 1 0, 2 0, 5 0)", "(0 0, 5 0)"},
      {"nearly", "(0 0, 1 0.012, 2 -0.012, 5 0)", "(0 0, 5 0)"},
      {"too far", "(0 0, 1 0.013, 2 0, 5 0)", "(0 0, 1 0.013, 5 0)"},
      {"corner", "(0 0, 1 0, 2 0, 2 1, 2 2)", "(0 0, 2 0, 2 2)"},
      {"point twice", "(0 0, 1 0, 1 0, 1 1)", "(0 0, 1 0, 1 1)"},
      {"no length", "(1 1, 1 1, 1 1)", "(1 1, 1 1, 1 1)"},
      {"there and back", "(0 0, 5 0, 0 0)", "(0 0, 5 0, 0 0)"},
      {"spike", "(0 0, 2 0, 2 0.5, 2 0, 5 0)", "(0 0, 2 0, 2 0.5, 2 0, 5 0)"},
      {"spike along the line", "(0 0, 4 0, 3 0, 5 0)", "(0 0, 4 0, 3 0, 5 0)"},
      {"beyond the end and back", "(0 0, 5 0, 4.94 0)", "(0 0, 5 0, 4.94 0)"},
      {"small spike", "(0 0, 2 0, 2 0.01, 2 0, 5 0)", "(0 0, 5 0)"},
  };
  for (const LineCase& c : cases) {
    const Path path = MakePathOrDie(c.points);
    EXPECT_EQ(Simple(path).path, MakePathOrDie(c.simple)) << c.name;
    ExpectKept(path, c.name);
  }
}

TEST(Simplified, ToleranceOfZeroKeepsAll) {
  const Path path = Curve(1, 50, 100, true);
  const SimplifiedPath simple = Simplified(path, {0, kHeight, true});
  EXPECT_EQ(simple.path, path);
  EXPECT_EQ(simple.flow, 1);
  EXPECT_THAT(simple.on_arc, Each(true));
}

TEST(Simplified, KeepsWhatAPathIs) {
  Path path = MakePathOrDie("(0 0, 1 0, 2 0, 2 2, 0 2)", true);
  path.feature = Feature::kExternalPerimeter;
  path.settings = 3;
  path.inset = 2;
  path.ring = 4;
  path.reversible = false;
  Path expected = path;
  expected.points = MakeLineOrDie("(0 0, 2 0, 2 2, 0 2)");
  EXPECT_EQ(Simple(path).path, expected);
}

// Beads of a circle run on both sides of it, so there are fewer of them than chords of the same
// tolerance.
TEST(Simplified, CirclesTakeFewBeads) {
  for (const double radius_mm : {0.5, 2.0, 10.0, 50.0}) {
    const Path circle = Circle(radius_mm, 720);
    ExpectKept(circle, std::to_string(radius_mm));
    const double chords = kPi / std::acos(1 - ToMm(double{kTolerance}) / radius_mm);
    EXPECT_LE(static_cast<double>(BeadCount(Simple(circle).path)), 0.8 * chords + 1) << radius_mm;
  }
}

// The start of a loop stays at any position, and no position needs more beads than another.
TEST(Simplified, LoopsHaveNoBetterStart) {
  const Path circle = Circle(5, 300);
  const size_t count = BeadCount(Simple(circle).path);
  for (int by = 0; by < 300; by += 23) {
    Path turned = circle;
    std::rotate(turned.points.begin(), turned.points.begin() + by, turned.points.end());
    ExpectKept(turned, std::to_string(by));
    EXPECT_NEAR(static_cast<double>(BeadCount(Simple(turned).path)), static_cast<double>(count), 1);
  }
}

TEST(Simplified, BoundsHoldOnCurves) {
  for (uint32_t seed = 0; seed < 60; ++seed) {
    const double noise_nm = seed % 3 == 0 ? 0 : seed % 3 == 1 ? 3'000 : 30'000;
    Path path = Curve(seed, 120, noise_nm, seed % 2 == 0);
    ExpectKept(path, "open " + std::to_string(seed));
    path.closed = true;
    ExpectKept(path, "closed " + std::to_string(seed));
  }
}

// A second algorithm with the same tolerance that may not end beads beside points.
TEST(Simplified, IsNotLongerThanDouglasPeucker) {
  size_t here = 0, there = 0;
  for (uint32_t seed = 0; seed < 40; ++seed) {
    const Path path = Curve(seed, 400, seed % 2 * 3'000.0, false);
    const size_t count = BeadCount(Simple(path).path);
    const size_t peucker = SimplifyLine(path.points, kTolerance - 1'500).size() - 1;
    EXPECT_LE(count, peucker) << seed;
    here += count;
    there += peucker;
  }
  EXPECT_LT(static_cast<double>(here), 0.75 * static_cast<double>(there));
}

/// Expects one width for each bead of a straight path along x. For beads of more than one edge it
/// must be within `tolerance_of(bead length in nm)` of the path's width at every place.
void ExpectWidthsWithin(
    const Path& path, const Path& simple,
    const std::function<double(double length_nm, double width_nm)>& tolerance_of) {
  size_t bead = 1;
  for (size_t i = 1; i < path.points.size(); ++i) {
    const Coord middle = (path.points[i - 1].x + path.points[i].x) / 2;
    while (simple.points[bead].x < middle) ++bead;
    EXPECT_EQ(simple.widths_nm[bead - 1], simple.widths_nm[bead]) << "one width a bead";
    const double length = Distance(simple.points[bead - 1], simple.points[bead]);
    if (length < Distance(path.points[i - 1], path.points[i]) + 2'000) continue;
    for (const size_t end : {i - 1, i}) {
      const auto width = static_cast<double>(path.widths_nm[end]);
      EXPECT_NEAR(static_cast<double>(simple.widths_nm[bead]), width,
                  tolerance_of(length, width) + 1);
    }
  }
}

TEST(Simplified, WidthsStayWithinTheirTolerance) {
  std::mt19937 random(5);
  Path path = OpenPath({{0, 0}}, {400'000});
  while (path.points.size() < 800) {
    path.points.push_back(path.points.back() + Point{20'000 + Below(80'000, random), 0});
    const Coord step = Below(50, random) == 0 ? 150'000 : 6'000;
    const Coord by = Below(2 * step, random) - step;
    path.widths_nm.push_back(std::clamp<Coord>(path.widths_nm.back() + by, 250'000, 700'000));
  }
  ExpectKept(path, "widths");
  for (const bool inside : {false, true}) {
    const Path simple =
        Simplified(path, {.tolerance_nm = kTolerance, .bead_height_nm = kHeight, .inside = inside})
            .path;
    EXPECT_LT(BeadCount(simple), BeadCount(path) * 0.5);
    ExpectWidthsWithin(path, simple, [&](double length_nm, double width_nm) {
      const double share = inside ? 0.1 : 0.05;
      return std::max(double{kWidthToleranceNm}, length_nm < kShortBeadNm ? share * width_nm : 0);
    });
  }
}

// A share of the width is used if it is larger than the tolerance: wide beads that change slowly
// become fewer.
TEST(Simplified, WideBeadsMayHaveAShareOfTheirWidth) {
  Path path = OpenPath({{0, 0}}, {300'000});
  while (path.points.size() < 31) {
    path.points.push_back(path.points.back() + Point{100'000, 0});
    path.widths_nm.push_back(path.widths_nm.back() + 20'000);
  }
  const auto with_share = [&](double share) {
    return Simplified(path, {kTolerance, kHeight, false, share}).path;
  };
  const Path shared = with_share(0.1);
  EXPECT_EQ(BeadCount(with_share(0.01)), BeadCount(Simple(path).path));
  EXPECT_LT(BeadCount(shared), 0.8 * BeadCount(Simple(path).path));
  ExpectWidthsWithin(path, shared, [](double, double width_nm) {
    return std::max(double{kWidthToleranceNm}, 0.1 * width_nm);
  });
}

// A step of the width at a point stays a step there.
TEST(Simplified, StepsOfWidthStay) {
  const Path path =
      OpenPath({{0, 0}, {FromMm(1), 0}, {FromMm(2), 0}, {FromMm(2), 0}, {FromMm(5), 0}},
               {450'000, 450'000, 450'000, 600'000, 600'000});
  const Path simple = Simple(path).path;
  EXPECT_THAT(simple.points, ElementsAre(Point{0, 0}, Point{FromMm(2), 0}, Point{FromMm(2), 0},
                                         Point{FromMm(5), 0}));
  EXPECT_THAT(simple.widths_nm, ElementsAre(450'000, 450'000, 600'000, 600'000));
  Path ring = OpenPath({{0, 0}, {FromMm(9), 0}, {FromMm(9), FromMm(9)}, {FromMm(9), FromMm(9)}},
                       {400'000, 400'000, 400'000, 700'000});
  ring.closed = true;
  ExpectKept(ring, "ring");
  EXPECT_EQ(BeadCount(Simple(ring).path), 3);
}

TEST(Simplified, MirroredTurnedAndBackwardsAreAlike) {
  const std::vector<std::pair<std::string, std::function<void(Path&)>>> changes = {
      {"mirror",
       [](Path& p) {
         for (Point& q : p.points) q.x = -q.x;
       }},
      {"turn",
       [](Path& p) {
         for (Point& q : p.points) q = {-q.y, q.x};
       }},
      {"move",
       [](Path& p) {
         for (Point& q : p.points) q = q + Point{FromMm(123), FromMm(-45)};
       }},
      {"back", [](Path& p) {
         std::ranges::reverse(p.points);
         if (p.widths_nm.size() > 1) std::ranges::reverse(p.widths_nm);
       }}};
  for (uint32_t seed = 0; seed < 12; ++seed) {
    const Path path = Curve(seed, 200, 2'000, seed % 2 == 0);
    const SimplifiedPath simple = Simple(path);
    for (const auto& [name, change] : changes) {
      Path changed = path;
      change(changed);
      const SimplifiedPath other = Simple(changed);
      // A bead for only a part of a replaceable run may have another mean width, and so be refused.
      const double slack = seed % 2 == 0 ? 1 : 0;
      EXPECT_NEAR(static_cast<double>(BeadCount(other.path)),
                  static_cast<double>(BeadCount(simple.path)), slack)
          << name << " " << seed;
      EXPECT_NEAR(PathLength(other.path), PathLength(simple.path), 1e-4 * PathLength(path));
      EXPECT_NEAR(other.flow, simple.flow, 1e-4) << name;
    }
  }
}

Path ZigZag(Coord pitch, Coord amplitude, int count) {
  Path path = OpenPath({});
  for (int i = 0; i < count; ++i) path.points.push_back({pitch * i, i % 2 * amplitude});
  return path;
}

TEST(Simplified, HostilePaths) {
  ExpectKept(ZigZag(1'000, 1'000, 3'000), "1 um to and fro");
  ExpectKept(ZigZag(0, 1'000, 500), "in one place");
  ExpectKept(ZigZag(100, 300, 3'000), "below the digits");
  ExpectKept(ZigZag(20'000, 30'000, 500), "saw");
  ExpectKept(OpenPath({{-2'100'000'000, -2'100'000'000}, {0, 40}, {2'100'000'000, 2'100'000'000}}),
             "over all the plane");
  ExpectKept(Circle(0.004, 50), "speck");
  ExpectKept(Circle(0.02, 50), "dot");
  Path ribbon = OpenPath({{0, 0}, {FromMm(5), 0}, {FromMm(5), 8'000}, {0, 8'000}});
  ribbon.closed = true;
  ExpectKept(ribbon, "ring without an inside");
  Path noise = OpenPath({});
  std::mt19937 random(7);
  for (int i = 0; i < 800; ++i)
    noise.points.push_back({Below(60'000, random), Below(60'000, random)});
  ExpectKept(noise, "noise within five tolerances");
}

// Moves to and fro within the tolerance contain plastic too. They must not shrink to a line.
TEST(Simplified, DoesNotEatWhatGoesToAndFro) {
  const Path saw = ZigZag(10'000, 11'000, 1'000);
  EXPECT_GE(PathLength(Simple(saw).path), 0.94 * PathLength(saw));
}

// A straight line of many points becomes a few beads, in time proportional to the points.
TEST(Simplified, LongPaths) {
  Path path = ZigZag(10'000, 10, 200'000);
  EXPECT_LE(BeadCount(Simple(path).path), 200'000 / 256 + 1);
}

TEST(Simplified, KeepsThePointsOfArcs) {
  Path path = OpenPath({});
  for (int i = 0; i <= 40; ++i) path.points.push_back({FromMm(i * 0.1), 0});
  for (int i = 1; i <= 60; ++i) {
    const double angle = kPi * i / 60 - kPi / 2;
    path.points.push_back({FromMm(4 + 3 * std::cos(angle)), FromMm(3 + 3 * std::sin(angle))});
  }
  const SimplifiedPath simple = Simple(path, true);
  const auto arcs = std::ranges::count(simple.on_arc, true);
  EXPECT_GE(arcs, 58);
  EXPECT_LE(std::ssize(simple.on_arc), arcs + 3);
  EXPECT_FALSE(simple.on_arc.front());
  EXPECT_LE(Simple(path).on_arc.size(), 25);
  EXPECT_THAT(Simple(path).on_arc, Each(false));
}

}  // namespace
}  // namespace slicefarm::motion::simplified_path_test
