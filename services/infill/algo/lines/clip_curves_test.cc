#include "services/infill/algo/lines/clip_curves.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill::clip_curves_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

double TotalLength(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces)
    length += piece.closed ? Perimeter(piece.points) : Length(piece.points);
  return length;
}

void ExpectEndsOnEdges(const std::vector<Piece>& pieces, const MultiPolygon& region) {
  const std::vector<Polygon> rings = Rings(region);
  for (const Piece& piece : pieces) {
    for (const auto& [place, point] :
         {std::pair{piece.from, piece.points.front()}, std::pair{piece.to, piece.points.back()}}) {
      if (place.ring < 0) continue;
      const Polygon& ring = rings[static_cast<size_t>(place.ring)];
      const auto edge = static_cast<size_t>(place.edge);
      EXPECT_LE(DistanceToSegment(point, ring[edge], ring[(edge + 1) % ring.size()]), 1.5);
    }
  }
}

struct Case {
  const char* name;
  const char* region;
  const char* curve;
  bool closed;
  size_t pieces;
  double length_mm;
};

TEST(ClipCurves, CutsAtTheEdge) {
  const Case cases[] = {
      {"Through", "(0 0, 10 0, 10 10, 0 10)", "(-5 5, 15 5)", false, 1, 10},
      {"BeginsInside", "(0 0, 10 0, 10 10, 0 10)", "(5 5, 15 5)", false, 1, 5},
      {"WhollyInside", "(0 0, 10 0, 10 10, 0 10)", "(5 5, 8 5, 8 8)", false, 1, 6},
      {"Outside", "(0 0, 10 0, 10 10, 0 10)", "(15 5, 18 5, 18 8)", false, 0, 0},
      {"AcrossAHole", "(0 0, 10 0, 10 10, 0 10) (4 4, 4 6, 6 6, 6 4)", "(-5 5, 15 5)", false, 2, 8},
      {"LoopInside", "(0 0, 10 0, 10 10, 0 10)", "(4 4, 6 4, 6 6, 4 6)", true, 1, 8},
      {"LoopBeginsInside", "(0 0, 10 0, 10 10, 0 10)", "(8 4, 12 4, 12 6, 8 6)", true, 1, 6},
      {"LoopBeginsOutside", "(0 0, 10 0, 10 10, 0 10)", "(12 4, 12 6, 8 6, 8 4)", true, 1, 6},
      {"LoopInAHole", "(0 0, 10 0, 10 10, 0 10) (3 3, 3 7, 7 7, 7 3)", "(4 4, 6 4, 6 6, 4 6)", true,
       0, 0},
      {"ThroughTwoCorners", "(0 0, 10 0, 10 10, 0 10)", "(-5 -5, 15 15)", false, 1, 14.1421356},
      {"ACornerOfItsOwnOnACorner", "(0 0, 10 0, 10 10, 0 10)", "(-5 -5, 0 0, 5 5)", false, 1,
       7.0710678},
      {"TwoIslands", "(0 0, 10 0, 10 10, 0 10) ; (20 0, 30 0, 30 10, 20 10)", "(-5 5, 35 5)", false,
       2, 20},
  };
  for (const Case& c : cases) {
    const MultiPolygon region = P(c.region);
    const Curve curve{MakeLineOrDie(c.curve), c.closed};
    const std::vector<Piece> pieces = ClipCurves(region, {&curve, 1});
    EXPECT_EQ(pieces.size(), c.pieces) << c.name;
    EXPECT_NEAR(TotalLength(pieces) / 1e6, c.length_mm, 1e-5) << c.name;
    ExpectEndsOnEdges(pieces, region);
  }
}

// The result agrees with scan_lines, which cuts straight lines by another algorithm.
TEST(ClipCurves, AgreesWithScanLines) {
  const MultiPolygon region =
      P("(0 0, 20 0, 20 10, 13 4, 9 10, 0 10) (3 3, 3 6, 6 6, 6 3) ; (30 0, 40 3, 31 9)");
  for (const double angle : {0.0, 0.4, std::numbers::pi / 4, 2.2}) {
    const LineFamily family{angle, 0, 1e6};
    const auto lines = CutLines(region, family);
    const LineAxes frame(angle);
    std::vector<Curve> curves;
    for (int i = -60; i <= 60; ++i)
      curves.push_back(
          {{frame.At(-90e6, i * 1e6), frame.At(3e6, i * 1e6), frame.At(90e6, i * 1e6)}});
    const auto pieces = ClipCurves(region, curves);
    EXPECT_NEAR(TotalLength(pieces), lines->TotalLength(), 1000) << angle;
    ExpectEndsOnEdges(pieces, region);
  }
}

// Curves are on the same coarse grid as the regions, so that corners and edges often coincide.
TEST(ClipCurves, NeverLeavesTheRegion) {
  int tested = 0;
  std::mt19937 random(3);
  std::uniform_int_distribution<Coord> grid(-3, 13);
  const MultiPolygon region =
      P("(0 0, 10 0, 10 10, 5 5, 0 10) (2 1, 2 3, 4 3, 4 1) (6 2, 7 4, 8 2)");
  const MultiPolygon grown = FastOffset(region, 10);
  for (int i = 0; i < 2000; ++i) {
    Curve curve;
    curve.closed = i % 2 == 0;
    for (int k = 0; k < 12; ++k) {
      const Point p{grid(random) * kNmPerMm, grid(random) * kNmPerMm};
      if (curve.points.empty() || curve.points.back() != p) curve.points.push_back(p);
    }
    const std::vector<Piece> pieces = ClipCurves(region, {&curve, 1});
    for (const Piece& piece : pieces) {
      for (size_t k = 1; k < piece.points.size(); ++k) {
        const Point a = piece.points[k - 1], b = piece.points[k];
        for (const Point p : {a, Point{(a.x + b.x) / 2, (a.y + b.y) / 2}}) {
          ++tested;
          bool inside = false;
          for (const PolygonWithHoles& island : grown) inside |= Locate(p, island) == Side::kInside;
          EXPECT_TRUE(inside) << ToText(p) << " of curve " << i;
        }
      }
    }
  }
  EXPECT_GT(tested, 1'000);
}

TEST(ClipCurves, NothingOfNothing) {
  const Curve curve{MakeLineOrDie("(0 0, 1 1)")};
  EXPECT_TRUE(ClipCurves({}, {&curve, 1}).empty());
  EXPECT_TRUE(ClipCurves(P("(0 0, 9 0, 9 9)"), {}).empty());
}

}  // namespace
}  // namespace slicefarm::infill::clip_curves_test
