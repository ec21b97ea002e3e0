#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/bead_checks_test.h"
#include "services/infill/algo/inside_checks_test.h"
#include "services/infill/algo/patterns/registry.h"
#include "services/infill/algo/sparse.h"

/// Tests of properties that all patterns of the registry have.
namespace slicefarm::infill::patterns_test {
namespace {

constexpr Coord kWidth = 450'000;
constexpr Coord kHeight = 200'000;
constexpr Coord kOverlap = 112'500;
/// Distance of lines from the edge of their region.
const auto kInset = static_cast<double>(Spacing(kWidth, kHeight) / 2 - kOverlap);

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

/// Returns the length of a line within a box.
double LengthIn(const Path& path, const Box& box) {
  double sum = 0;
  const size_t count = path.points.size();
  for (size_t i = 1; i < count + (path.closed ? 1 : 0); ++i) {
    const Point a = path.points[i - 1], b = path.points[i % count];
    double from = 0, to = 1;
    const auto clip = [&](Coord start, Coord route, Coord low, Coord high) {
      if (route == 0) {
        if (start < low || start > high) to = from;
        return;
      }
      double in = static_cast<double>(low - start) / static_cast<double>(route);
      double out = static_cast<double>(high - start) / static_cast<double>(route);
      if (in > out) std::swap(in, out);
      from = std::max(from, in), to = std::min(to, out);
    };
    clip(a.x, b.x - a.x, box.min.x, box.max.x);
    clip(a.y, b.y - a.y, box.min.y, box.max.y);
    sum += std::max(0.0, to - from) * Distance(a, b);
  }
  return sum;
}

/// Returns an example of a plan for a layer: crossing lines, lines that end inside, forks.
std::span<const Polyline> SamplePlan() {
  static const auto& lines = *new std::vector<Polyline>([] {
    std::vector<Polyline> made;
    const Coord far = FromMm(60);
    for (Coord at = -far; at <= far; at += FromMm(3.7)) {
      made.push_back({{-far, at}, {far, at + FromMm(9)}});
      made.push_back({{at, -far}, {at + FromMm(2), FromMm(3)}, {at - FromMm(5), FromMm(7)}});
      made.push_back({{at + FromMm(2), FromMm(3)}, {at + FromMm(9), FromMm(5)}});
    }
    return made;
  }());
  return lines;
}

SparseFill Fill(FillPattern pattern, double density) {
  return {.pattern = pattern,
          .density = density,
          .angle_rad = std::numbers::pi / 4,
          .width_nm = kWidth,
          .height_nm = kHeight,
          .overlap_nm = kOverlap,
          .anchor_nm = 2'700'000,
          .anchor_max_nm = 50'000'000,
          .planned = SamplePlan()};
}

std::string NameOf(const testing::TestParamInfo<FillPattern>& info) {
  return "P" + std::string(InfoOf(info.param).name);
}

std::vector<FillPattern> AllPatterns() {
  std::vector<FillPattern> all;
  for (const FillPatternInfo& info : kFillPatterns)
    if (info.sparse) all.push_back(info.pattern);
  return all;
}

std::vector<FillPattern> PatternsWithLaw() {
  std::vector<FillPattern> all = AllPatterns();
  std::erase_if(all, [](FillPattern pattern) { return !InfoOf(pattern).has_law; });
  return all;
}

class PatternsWithALaw : public testing::TestWithParam<FillPattern> {};
INSTANTIATE_TEST_SUITE_P(All, PatternsWithALaw, testing::ValuesIn(PatternsWithLaw()), NameOf);

class Patterns : public testing::TestWithParam<FillPattern> {};
INSTANTIATE_TEST_SUITE_P(All, Patterns, testing::ValuesIn(AllPatterns()), NameOf);

/// Returns all patterns except patterns with planned lines.
std::vector<FillPattern> PatternsWithoutPlan() {
  std::vector<FillPattern> all = AllPatterns();
  std::erase_if(all, [](FillPattern pattern) { return InfoOf(pattern).planned; });
  return all;
}

class PatternsLaidOutHere : public testing::TestWithParam<FillPattern> {};
INSTANTIATE_TEST_SUITE_P(All, PatternsLaidOutHere, testing::ValuesIn(PatternsWithoutPlan()),
                         NameOf);

// The density two widths inside is correct within 1 %, from 5 to 80 %. It is the mean over heights
// and positions on the pattern.
TEST_P(PatternsWithALaw, DensityIsAsAsked) {
  const auto spacing = static_cast<double>(Spacing(kWidth, kHeight));
  for (const double density : {0.05, 0.1, 0.15, 0.2, 0.4, 0.6, 0.8}) {
    // Because so many positions are averaged, the box need not contain a whole number of periods.
    constexpr int kPlaces = 48;
    SparseFill fill = Fill(GetParam(), density);
    double length = 0, area = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const double pitch = spacing / density;
      const auto aside = [&](double share) {
        return std::llround((share - std::floor(share)) * 12 * pitch);
      };
      MultiPolygon box = P("(-40 -40, 40 -40, 40 40, -40 40)");
      for (Point& p : box[0].outer) p = p + Point{aside(0.6180339887 * i), aside(0.7548776662 * i)};
      fill.layer = i;
      // Heights are spread evenly, by a step that is no simple part of a pattern's period.
      const double step =
          GetParam() == FillPattern::kMedialAxis ? std::numbers::phi : std::numbers::sqrt2;
      fill.z_nm = std::llround(i * pitch / step);
      const auto paths = FillSparse(box, fill);
      ASSERT_TRUE(paths.ok()) << paths.status();
      // Loops keep their distance from the edge, so that a whole number of loops is counted.
      const double loops = std::ceil(2 * kWidth / pitch - 0.5) + 0.5;
      const double band =
          GetParam() == FillPattern::kConcentric ? loops * pitch + kInset : 2 * kWidth;
      const Box inner = Bounds(FastOffset(box, -std::llround(band)));
      for (const Path& path : *paths) length += LengthIn(path, inner);
      area += static_cast<double>(inner.max.x - inner.min.x) *
              static_cast<double>(inner.max.y - inner.min.y);
    }
    EXPECT_NEAR(length * spacing / area / density, 1, 0.01) << density;
  }
}

double EdgeOf(const MultiPolygon& region) {
  double length = 0;
  ForEachRing(region, [&length](const Polygon& ring) { length += Perimeter(ring); });
  return length;
}

// Beads of the requested width touch a large part of the edge and overlap the walls by
// infill_overlap. Patterns along the edge touch nearly all of it. Links and anchors hardly overlap
// other beads.
TEST_P(PatternsLaidOutHere, HoldToTheEdgeByEvenBeads) {
  const MultiPolygon region = P("(0 0, 40 0, 46 21, 40 40, 20 34, 0 40) (9 9, 9 14, 16 13, 14 7)");
  const bool along_edge = InfoOf(GetParam()).solid == SolidFillStyle::kAlongEdge;
  for (const double density : {0.1, 0.2, 0.4}) {
    SparseFill fill = Fill(GetParam(), density);
    fill.z_nm = 5'300'000;
    const auto paths = FillSparse(region, fill);
    ASSERT_TRUE(paths.ok());
    for (const Path& path : *paths) EXPECT_EQ(path.widths_nm, std::vector<Coord>{kWidth});
    const double depth = kInset + 10'000;
    EXPECT_GE(LengthAlongEdge(*paths, region, depth), (along_edge ? 0.9 : 0.2) * EdgeOf(region))
        << density;
    fill.anchor_max_nm = 0;
    const auto lines = FillSparse(region, fill);
    EXPECT_LE(DoubledLength(*paths, kWidth), DoubledLength(*lines, kWidth) + 0.05 * EdgeOf(region))
        << density;
  }
}

// If a line along the edge has no space for another line beside it, the first line is still
// printed.
TEST_P(PatternsLaidOutHere, NarrowPlacesAreNotLeftEmpty) {
  if (InfoOf(GetParam()).solid != SolidFillStyle::kAlongEdge) return;
  const MultiPolygon narrow = P("(0 0, 20 0, 20 0.6, 0 0.6) ; (0 3, 20 3, 20 5, 0 5)");
  const auto paths = FillSparse(narrow, Fill(GetParam(), 0.1));
  ASSERT_TRUE(paths.ok());
  EXPECT_GE(LengthAlongEdge(*paths, narrow, kInset + 10'000), 0.85 * EdgeOf(narrow));
}

TEST_P(Patterns, StayInside) {
  const char* const regions[] = {
      "(0 0, 30 0, 30 30, 15 5, 0 30) (3 2, 3 4, 5 4, 5 2)",
      "(0 0, 20 0, 20 10, 13 4, 9 10, 0 10) (3 3, 3 6, 6 6, 6 3) ; (30 0, 40 3, 31 9)",
      "(-9 -7, 11 -7.01, 10 9, 3 8.5, 2.9 -6, 2.5 -6, 2.4 8, -8 9)",
  };
  for (const char* text : regions) {
    for (const double density : {0.1, 0.3, 0.7}) {
      for (const double angle : {0.0, 0.4, std::numbers::pi / 4}) {
        SparseFill fill = Fill(GetParam(), density);
        fill.angle_rad = angle;
        fill.z_nm = 3'300'000;
        const auto paths = FillSparse(P(text), fill);
        ASSERT_TRUE(paths.ok());
        SCOPED_TRACE(text);
        EXPECT_FALSE(paths->empty());
        ExpectInside(*paths, P(text));
      }
    }
  }
}

TEST_P(Patterns, AreTheSameEachTime) {
  const MultiPolygon region = P("(0 0, 30 0, 30 30, 15 5, 0 30) (3 2, 3 4, 5 4, 5 2)");
  EXPECT_EQ(*FillSparse(region, Fill(GetParam(), 0.2)), *FillSparse(region, Fill(GetParam(), 0.2)));
}

// A pattern at an angle is the rotated pattern, so that its length is the same.
TEST_P(PatternsLaidOutHere, TurnWithTheAngle) {
  const MultiPolygon box = P("(-20 -15, 20 -15, 20 15, -20 15)");
  const MultiPolygon turned = P("(15 -20, 15 20, -15 20, -15 -20)");
  const auto length = [&](const MultiPolygon& region, double angle) {
    SparseFill fill = Fill(GetParam(), 0.25);
    fill.angle_rad = angle;
    fill.anchor_max_nm = 0;
    double sum = 0;
    const auto paths = FillSparse(region, fill);
    for (const Path& path : *paths) sum += PathLength(path);
    return sum;
  };
  EXPECT_NEAR(length(box, 0.3) / length(turned, 0.3 + std::numbers::pi / 2), 1, 1e-4);
}

TEST_P(PatternsLaidOutHere, TooManyLinesAreRefused) {
  const MultiPolygon huge = P("(0 0, 2000 0, 2000 2000, 0 2000)");
  SparseFill fill = Fill(GetParam(), 0.8);
  fill.width_nm = 50'000;
  fill.height_nm = 10'000;
  const auto paths = FillSparse(huge, fill);
  // The number of straight lines and loops across two metres is below the limit.
  const FillPattern few[] = {FillPattern::kRectilinear,    FillPattern::kAlignedRectilinear,
                             FillPattern::kLine,           FillPattern::kZigzag,
                             FillPattern::kGrid,           FillPattern::kTriangles,
                             FillPattern::kStars,          FillPattern::kCubic,
                             FillPattern::kMonotonic,      FillPattern::kConcentric,
                             FillPattern::kMonotonicLines, FillPattern::kQuarterCubic,
                             FillPattern::kCrossZag,       FillPattern::kLockedZag,
                             FillPattern::kLateralLattice, FillPattern::kLateralHoneycomb};
  if (std::ranges::find(few, GetParam()) != std::end(few)) {
    EXPECT_TRUE(paths.ok()) << paths.status();
    return;
  }
  ASSERT_FALSE(paths.ok());
  EXPECT_EQ(DetailOf(paths.status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::infill::patterns_test
