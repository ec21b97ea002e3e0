#include "services/exposure/algo/decompose/decompose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>
#include <string>

#include "common/base/error.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/predicates.h"
#include "common/geometry/text_format_test.h"
#include "services/exposure/algo/decompose/piece_quality.h"

namespace slicefarm::exposure::decompose_test {
namespace {

using Wide = __int128;

/// Returns twice the signed area, without rounding.
Wide TwiceArea(const Polygon& ring) {
  Wide area = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    area += static_cast<Wide>(a.x) * b.y - static_cast<Wide>(b.x) * a.y;
  }
  return area;
}

Wide TwiceArea(const MultiPolygon& islands) {
  Wide area = 0;
  ForEachRing(islands, [&](const Polygon& ring) { area += TwiceArea(ring); });
  return area;
}

bool IsStrictlyConvex(const Polygon& ring) {
  if (ring.size() < 3) return false;
  for (size_t i = 0, n = ring.size(); i < n; ++i) {
    if (Orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) <= 0) return false;
    // The ring turns once: all corners are to the left of all edges.
    for (size_t k = 0; k < n; ++k)
      if (Orientation(ring[i], ring[(i + 1) % n], ring[k]) < 0) return false;
  }
  return true;
}

MultiPolygon Scaled(MultiPolygon islands, Coord scale) {
  for (PolygonWithHoles& island : islands) {
    for (Point& p : island.outer) p = {p.x * scale, p.y * scale};
    for (Polygon& hole : island.holes)
      for (Point& p : hole) p = {p.x * scale, p.y * scale};
  }
  return islands;
}

/// Checks exactly that all pieces are convex, and that their total area is the area of the islands.
/// No two pieces overlap: either their boxes are disjoint, or one piece has an edge with the whole
/// other piece on its right.
void ExpectPartition(const MultiPolygon& islands, const ConvexPieces& result,
                     const std::string& what, bool exact = true) {
  Wide area = 0;
  for (const Polygon& piece : result.pieces) {
    EXPECT_TRUE(IsStrictlyConvex(piece)) << what;
    area += TwiceArea(piece);
  }
  const Wide whole = TwiceArea(Scaled(islands, result.scale));
  const Wide difference = area > whole ? area - whole : whole - area;
  EXPECT_LE(static_cast<double>(difference), exact ? 0 : 1e-9 * static_cast<double>(whole)) << what;
  const auto apart = [](const Polygon& a, const Polygon& b) {
    for (size_t i = 0; i < a.size(); ++i) {
      const Point from = a[i], to = a[(i + 1) % a.size()];
      if (std::all_of(b.begin(), b.end(), [&](Point p) { return Orientation(from, to, p) <= 0; }))
        return true;
    }
    return false;
  };
  for (size_t i = 0; i < result.pieces.size(); ++i)
    for (size_t k = i + 1; k < result.pieces.size(); ++k)
      EXPECT_TRUE(!Bounds(result.pieces[i]).Intersects(Bounds(result.pieces[k])) ||
                  apart(result.pieces[i], result.pieces[k]) ||
                  apart(result.pieces[k], result.pieces[i]))
          << what << ": pieces " << i << " and " << k << " overlap";
}

ConvexPieces DecomposeOrDie(const MultiPolygon& islands, DecomposeOptions options = {}) {
  auto result = Decompose(islands, options);
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? *std::move(result) : ConvexPieces{};
}

struct Case {
  const char* name;
  const char* islands;
  int64_t pieces;
  int64_t reflex;
};

TEST(Decompose, NamedShapes) {
  const Case cases[] = {
      {"nothing", "", 0, 0},
      {"square", "(0 0, 10 0, 10 10, 0 10)", 1, 0},
      {"L", "(0 0, 20 0, 20 10, 10 10, 10 20, 0 20)", 2, 1},
      {"plus", "(10 0, 20 0, 20 10, 30 10, 30 20, 20 20, 20 30, 10 30, 10 20, 0 20, 0 10, 10 10)",
       3, 4},
      {"frame", "(0 0, 30 0, 30 30, 0 30) (10 10, 20 10, 20 20, 10 20)", 4, 4},
      {"two squares", "(0 0, 1 0, 1 1, 0 1) ; (2 0, 3 0, 3 1, 2 1)", 2, 0},
      {"hole in a hole's island",
       "(0 0, 90 0, 90 90, 0 90) (10 10, 80 10, 80 80, 10 80) ; (20 20, 70 20, 70 70, 20 70)", 5,
       4},
      {"collinear points", "(0 0, 5 0, 10 0, 10 5, 10 10, 0 10, 0 5)", 1, 0},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const MultiPolygon islands = c.islands[0] == 0 ? MultiPolygon{} : MakePolygonsOrDie(c.islands);
    const ConvexPieces result = DecomposeOrDie(islands);
    EXPECT_EQ(result.counts.pieces, c.pieces);
    EXPECT_EQ(result.counts.reflex, c.reflex);
    ExpectPartition(islands, result, c.name);
  }
}

TEST(Decompose, DropsACornerOfAHairsWidth) {
  // A short side with a dent of one nanometre in its middle gives no cut and no sliver.
  MultiPolygon islands = MakePolygonsOrDie("(49.5 0, 50.5 0, 100 50, 100 100, 0 100, 0 50)");
  islands[0].outer.insert(islands[0].outer.begin() + 1, Point{50 * kNmPerMm, 1});
  const ConvexPieces result = DecomposeOrDie(islands);
  EXPECT_EQ(result.pieces.size(), 1u);
  ExpectPartition(islands, result, "dent", false);
}

TEST(Decompose, KeepsADentThatIsMoreThanArea) {
  MultiPolygon islands = MakePolygonsOrDie("(0 0, 100 0, 100 100, 0 100)");
  islands[0].outer.insert(islands[0].outer.begin() + 1, Point{50 * kNmPerMm, 900});
  const ConvexPieces result = DecomposeOrDie(islands);
  EXPECT_EQ(result.pieces.size(), 2u);
  ExpectPartition(islands, result, "dent");
}

TEST(Decompose, TheCutAvoidsSharpAnglesByABisector) {
  // The dent sees only corners at very flat angles, so that the cut is vertical.
  const ConvexPieces result = DecomposeOrDie(MakePolygonsOrDie("(0 0, 50 1, 100 0, 100 10, 0 10)"));
  EXPECT_EQ(result.pieces.size(), 2u);
  EXPECT_EQ(result.counts.extra_points, 1);
  EXPECT_EQ(result.counts.sharp_cuts, 0);
  EXPECT_GT(result.min_cut_angle_deg, 80);
}

TEST(Decompose, RingsThatTouchThemselves) {
  // Two lobes of a hole that meet in a corner; a hole that touches the outer ring; islands that
  // touch.
  for (const char* text :
       {"(0 0, 20 0, 20 20, 0 20) (5 5, 10 5, 10 10, 15 10, 15 15, 10 15, 10 10, 5 10)",
        "(0 0, 20 0, 20 20, 0 20) (0 0, 10 5, 5 10)",
        "(0 0, 20 0, 20 20, 0 20) (10 0, 12 10, 8 10)",
        "(0 0, 10 0, 10 10, 0 10) ; (10 10, 20 10, 20 20, 10 20)",
        "(0 0, 20 0, 20 20, 0 20) (5 5, 10 5, 10 10, 5 10) (10 10, 15 10, 15 15, 10 15)"}) {
    const MultiPolygon islands = MakePolygonsOrDie(text);
    ExpectPartition(islands, DecomposeOrDie(islands), text);
  }
}

TEST(Decompose, AThousandHoles) {
  MultiPolygon islands = MakePolygonsOrDie("(0 0, 340 0, 340 340, 0 340)");
  std::mt19937 random(5);
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 32; ++column) {
      Polygon hole = ConvexHull(RandomStar(random, 4, 0.6));
      for (Point& p : hole)
        p = p + Point{(row * 10 + 10) * kNmPerMm, (column * 10 + 10) * kNmPerMm};
      std::reverse(hole.begin(), hole.end());
      islands[0].holes.push_back(hole);
    }
  }
  const ConvexPieces result = DecomposeOrDie(islands);
  Wide area = 0;
  for (const Polygon& piece : result.pieces) {
    EXPECT_TRUE(IsStrictlyConvex(piece));
    area += TwiceArea(piece);
  }
  const Wide whole = TwiceArea(Scaled(islands, result.scale));
  EXPECT_NEAR(static_cast<double>(area - whole) / static_cast<double>(whole), 0, 1e-11);
  // A cut from a hole to another ring does not divide the region.
  EXPECT_LE(result.counts.pieces, result.counts.reflex - 1024 + 1);
}

TEST(Decompose, RandomIslandsAreCutExactly) {
  std::mt19937 random(20);
  for (int i = 0; i < 1500; ++i) {
    const MultiPolygon islands =
        RandomIsland(random, {i * 1'000'003, -i * 777'777}, Uniform(random, 0.5, 80));
    const ConvexPieces result = DecomposeOrDie(islands);
    ExpectPartition(islands, result, ToText(islands), false);
    EXPECT_GE(result.min_ruled_angle_deg, 29.999999);
    // Each cut removes at least one reflex corner.
    EXPECT_LE(result.counts.pieces, result.counts.reflex + static_cast<int64_t>(islands.size()));
    if (::testing::Test::HasFailure()) break;
  }
}

TEST(Decompose, CgalsPartitionsPassTheSameTests) {
  std::mt19937 random(21);
  for (int i = 0; i < 150; ++i) {
    const MultiPolygon islands = RandomIsland(random, {}, 30);
    for (const DecomposeMethod method :
         {DecomposeMethod::kOptimal, DecomposeMethod::kApproximate, DecomposeMethod::kYMonotone}) {
      ExpectPartition(islands, DecomposeOrDie(islands, {.method = method}), ToText(islands), false);
    }
  }
}

TEST(Decompose, OptimalHasNoMorePiecesThanApproximate) {
  std::mt19937 random(22);
  for (int i = 0; i < 50; ++i) {
    const Polygon star = RandomStar(random, 20, 0.3);
    const MultiPolygon islands = Union(std::vector<Polygon>{star}, FillRule::kNonZero);
    const auto optimal = Decompose(islands, {.method = DecomposeMethod::kOptimal});
    const auto approximate = Decompose(islands, {.method = DecomposeMethod::kApproximate});
    ASSERT_TRUE(optimal.ok() && approximate.ok());
    if (optimal->counts.replaced > 0 || approximate->counts.replaced > 0) continue;
    EXPECT_LE(optimal->counts.pieces, approximate->counts.pieces);
  }
}

/// A shift by whole units or a rotation by right angles changes only positions, not the number of
/// pieces.
TEST(Decompose, MovedAndTurned) {
  std::mt19937 random(23);
  for (int i = 0; i < 200; ++i) {
    const MultiPolygon islands = RandomIsland(random, {}, 20);
    const ConvexPieces here = DecomposeOrDie(islands);
    const ConvexPieces there = DecomposeOrDie(Moved(islands, {12'345'678, -87'654'321}));
    EXPECT_EQ(here.counts.pieces, there.counts.pieces);
    EXPECT_EQ(here.counts.extra_points, there.counts.extra_points);
    MultiPolygon turned = islands;
    for (PolygonWithHoles& island : turned) {
      for (Point& p : island.outer) p = {-p.y, p.x};
      for (Polygon& hole : island.holes)
        for (Point& p : hole) p = {-p.y, p.x};
    }
    EXPECT_EQ(here.counts.pieces, DecomposeOrDie(turned).counts.pieces);
  }
}

TEST(Decompose, RefusesRingsThatCross) {
  for (const char* text :
       {"(0 0, 10 0, 10 10, 5 -5)", "(0 0, 20 0, 20 20, 0 20) (10 10, 30 10, 30 15, 10 15)",
        "(0 0, 10 0, 10 10, 0 10) ; (5 5, 15 5, 15 15, 5 15)",
        "(0 0, 30 0, 30 30, 0 30) ; (5 5, 15 5, 15 15, 5 15)",
        "(0 0, 30 0, 30 30, 0 30) (10 10, 20 10, 20 20, 10 20) ; (1 1, 5 1, 5 5, 1 5)"}) {
    const auto result = Decompose(MakePolygonsOrDie(text), {});
    ASSERT_FALSE(result.ok()) << text;
    EXPECT_EQ(DetailOf(result.status()).reason, Reason::kRequestMalformed) << text;
  }
  MultiPolygon clockwise = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  std::reverse(clockwise[0].outer.begin(), clockwise[0].outer.end());
  EXPECT_EQ(DetailOf(Decompose(clockwise, {}).status()).reason, Reason::kRequestMalformed);
}

TEST(Decompose, BiansMethodDoesWhatOthersCannot) {
  Polygon ring;
  for (int i = 0; i < 400; ++i) {
    const double t = 2 * std::numbers::pi * i / 400, r = i % 2 == 0 ? 50 : 40;
    ring.push_back({FromMm(r * std::cos(t)), FromMm(r * std::sin(t))});
  }
  const MultiPolygon star = {{ring, {}}};
  const ConvexPieces result = DecomposeOrDie(star, {.method = DecomposeMethod::kOptimal});
  EXPECT_EQ(result.counts.replaced, 1);
  EXPECT_EQ(result.pieces, DecomposeOrDie(star).pieces);
  EXPECT_EQ(DecomposeOrDie(star, {.method = DecomposeMethod::kApproximate}).counts.replaced, 0);
}

TEST(Decompose, StopsWhenCancelled) {
  const auto result = Decompose(MakePolygonsOrDie("(0 0, 20 0, 20 10, 10 10, 10 20, 0 20)"), {},
                                CancelToken([] { return true; }));
  EXPECT_EQ(DetailOf(result.status()).reason, Reason::kCancelled);
}

/// Returns rectangles with edges on few lines: corners touch corners and edges, and many are on the
/// same line.
MultiPolygon OnAFewLines(std::mt19937& random) {
  const auto at = [&] { return FromMm(std::floor(Uniform(random, 0, 9))); };
  std::vector<Polygon> rings;
  for (int k = 0; k < 8; ++k) {
    const Coord x = at(), y = at(), width = at() / 2, height = at() / 2;
    rings.push_back({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
  }
  return Union(rings, FillRule::kNonZero);
}

/// Returns a plate with square holes in rows. Some holes are missing.
MultiPolygon PlateWithHoles(std::mt19937& random) {
  MultiPolygon plate = MakePolygonsOrDie("(0 0, 50 0, 50 50, 0 50)");
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (random() % 3 == 0) continue;
      const Coord x = (4 + column * 11) * kNmPerMm, y = (4 + row * 11) * kNmPerMm;
      const Coord side = (3 + static_cast<Coord>(random() % 3)) * kNmPerMm;
      plate[0].holes.push_back({{x, y}, {x, y + side}, {x + side, y + side}, {x + side, y}});
    }
  }
  return plate;
}

int HostileOutlines() {
  const char* given = std::getenv("SLICEFARM_DECOMPOSE_OUTLINES");
  return given == nullptr ? 900 : std::atoi(given);
}

/// The nightly run sets SLICEFARM_DECOMPOSE_OUTLINES=100000: ctest -C nightly -L slow.
TEST(Decompose, NoMethodGivesUp) {
  std::mt19937 random(25);
  int64_t replaced = 0;
  for (int i = 0; i < HostileOutlines(); ++i) {
    const MultiPolygon islands = i % 3 == 0   ? RandomIsland(random, {}, Uniform(random, 0.5, 40))
                                 : i % 3 == 1 ? OnAFewLines(random)
                                              : PlateWithHoles(random);
    for (const DecomposeMethod method :
         {DecomposeMethod::kBian, DecomposeMethod::kOptimal, DecomposeMethod::kApproximate,
          DecomposeMethod::kYMonotone}) {
      if (method == DecomposeMethod::kOptimal && PointCount(islands) > 40) continue;  // slow
      const ConvexPieces result = DecomposeOrDie(islands, {.method = method});
      ExpectPartition(islands, result, ToText(islands), false);
      replaced += result.counts.replaced;
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_GT(replaced, 0);
}

}  // namespace
}  // namespace slicefarm::exposure::decompose_test
