#include "services/infill/algo/patterns/medial_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/offset.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/patterns/pattern_samples_test.h"
#include "services/infill/algo/sparse.h"

namespace slicefarm::infill::medial_axis_test {
namespace {

constexpr Coord kSpacing = 400'000;
constexpr double kPitch = 2e6;
constexpr int kPhases = 50;

PatternContext At(int phase) {
  return {
      .z_nm = std::llround(kPitch * phase / kPhases), .pitch_nm = kPitch, .spacing_nm = kSpacing};
}

/// Returns the length of pieces within a part of their region.
double LengthWithin(const MultiPolygon& part, const std::vector<Piece>& pieces) {
  std::vector<Curve> curves;
  for (const Piece& piece : pieces) curves.push_back({piece.points, piece.closed});
  return LengthOf(ClipCurves(part, curves));
}

/// Returns the sorted positions, in nm, where lines cross a strip 10 mm wide, 50 mm from its end.
std::vector<double> PlacesAcross(const MultiPolygon& strip, const PatternContext& context) {
  std::vector<Curve> curves;
  const auto pieces = MedialAxis(strip, context);
  for (const Piece& piece : *pieces) curves.push_back({piece.points, piece.closed});
  std::vector<double> places;
  for (const Piece& piece : ClipCurves(MakePolygonsOrDie("(50 -1, 52 -1, 52 11, 50 11)"), curves))
    places.push_back(static_cast<double>(piece.points.front().y));
  std::ranges::sort(places);
  return places;
}

constexpr std::string_view kShapes[] = {
    "(-24 -24, 24 -24, 24 24, -24 24)",
    "(0 0, 60 0, 60 14, 0 14)",
    "(0 0, 60 0, 60 40, 40 40, 40 20, 25 20, 25 40, 0 40) (10 8, 8 14, 16 15, 17 9)",
    "(0 0, 50 3, 47 31, 20 40, 22 20, -4 18)",
};

// The coarea formula holds in any part of the region, on average over the phase.
TEST(MedialAxis, IsAsDenseAsAskedInEachPart) {
  for (const std::string_view text : kShapes) {
    const MultiPolygon region = MakePolygonsOrDie(text);
    const MultiPolygon part =
        Intersection(Offset(region, -1'000'000), MakePolygonsOrDie("(-3 -2, 29 1, 33 17, 12 23)"));
    double whole = 0, inside = 0;
    for (int i = 0; i < kPhases; ++i) {
      const auto pieces = MedialAxis(region, At(i));
      ASSERT_TRUE(pieces.ok());
      whole += LengthOf(*pieces) / kPhases;
      inside += LengthWithin(part, *pieces) / kPhases;
    }
    EXPECT_NEAR(whole * kPitch / Area(region), 1, 0.005) << text;
    EXPECT_NEAR(inside * kPitch / Area(part), 1, 0.01) << text;
  }
}

TEST(MedialAxis, LinesEndAtTheEdge) {
  const MultiPolygon region = MakePolygonsOrDie(kShapes[2]);
  int ends = 0;
  for (int i = 0; i < kPhases; i += 7) {
    const auto pieces = MedialAxis(region, At(i));
    for (const Piece& piece : *pieces) {
      if (piece.closed) continue;
      ends += (piece.from.ring >= 0) + (piece.to.ring >= 0);
    }
  }
  EXPECT_GT(ends, 100);
}

// Lines begin at walls, and move inwards by as much as the height increases.
TEST(MedialAxis, LinesLeanByTheHeight) {
  const MultiPolygon strip = MakePolygonsOrDie("(0 0, 100 0, 100 10, 0 10)");
  const auto heights = [&](Coord z_nm) {
    PatternContext context = At(0);
    context.z_nm = z_nm;
    return PlacesAcross(strip, context);
  };
  const auto low = heights(400'000), high = heights(600'000);
  ASSERT_EQ(low.size(), 4u);
  ASSERT_EQ(high.size(), 4u);
  for (const size_t i : {0, 1}) {
    EXPECT_NEAR(high[i] - low[i], 0.2e6, 1e4);
    EXPECT_NEAR(high[3 - i] - low[3 - i], -0.2e6, 1e4);
  }
}

// No two lines overlap where a pair meets on the axis.
TEST(MedialAxis, PairsOnTheAxisAreOneLine) {
  const MultiPolygon strip = MakePolygonsOrDie("(0 0, 100 0, 100 10, 0 10)");
  for (int i = 0; i < kPhases; ++i) {
    const std::vector<double> at = PlacesAcross(strip, At(i));
    for (size_t k = 1; k < at.size(); ++k) EXPECT_GE(at[k] - at[k - 1], 0.99 * kSpacing) << i;
  }
}

TEST(MedialAxis, LoopsAreLinked) {
  Polygon disc;
  for (int i = 0; i < 120; ++i) {
    const double turn = 2 * std::numbers::pi * i / 120;
    disc.push_back({FromMm(20 * Cos(turn)), FromMm(20 * Sin(turn))});
  }
  for (int i = 0; i < kPhases; ++i) {
    SparseFill fill{.pattern = FillPattern::kMedialAxis, .z_nm = At(i).z_nm};
    fill.anchor_max_nm = 50'000'000;
    // Short parts of the outermost line are along the edge, because it meets the outline's chords.
    EXPECT_LE(FillSparse({{disc, {}}}, fill)->size(), 4u) << i;
  }
}

TEST(MedialAxis, SmoothLinesTurnLessAndAreAsDense) {
  const auto turning = [](const std::vector<Piece>& pieces) {
    double sharpest = 1;
    for (const Piece& piece : pieces) {
      for (size_t k = 2; k < piece.points.size(); ++k) {
        const Point a = piece.points[k - 1] - piece.points[k - 2];
        const Point b = piece.points[k] - piece.points[k - 1];
        const double dot = static_cast<double>(a.x) * static_cast<double>(b.x) +
                           static_cast<double>(a.y) * static_cast<double>(b.y);
        sharpest = std::min(sharpest, dot / (Norm(a) * Norm(b)));
      }
    }
    return sharpest;
  };
  const MultiPolygon region = MakePolygonsOrDie(kShapes[2]);
  double length = 0;
  for (int i = 0; i < kPhases; ++i) {
    PatternContext context = At(i);
    context.smoothing_nm = 1'000'000;
    const auto pieces = MedialAxis(region, context);
    ASSERT_TRUE(pieces.ok());
    length += LengthOf(*pieces) / kPhases;
    if (i != 7) continue;
    EXPECT_GT(turning(*pieces), turning(*MedialAxis(region, At(i))));
  }
  EXPECT_NEAR(length * kPitch / Area(region), 1, 0.01);
}

TEST(MedialAxis, FillsWhatHasNoDiagram) {
  // Two squares that touch in a corner, as one ring.
  const MultiPolygon touching = {{{{0, 0},
                                   {20'000'000, 0},
                                   {20'000'000, 20'000'000},
                                   {40'000'000, 20'000'000},
                                   {40'000'000, 40'000'000},
                                   {20'000'000, 40'000'000},
                                   {20'000'000, 20'000'000},
                                   {0, 20'000'000}},
                                  {}}};
  double length = 0;
  for (int i = 0; i < kPhases; ++i) length += LengthOf(*MedialAxis(touching, At(i))) / kPhases;
  EXPECT_NEAR(length * kPitch / Area(touching), 1, 0.02);
}

}  // namespace
}  // namespace slicefarm::infill::medial_axis_test
