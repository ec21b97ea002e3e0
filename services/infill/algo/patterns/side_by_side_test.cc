#include "services/infill/algo/patterns/side_by_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::side_by_side_test {
namespace {

constexpr Coord kSpacing = 400'000;

std::vector<FillPattern> PatternsOfSeveralLines() {
  std::vector<FillPattern> all;
  for (const FillPatternInfo& info : kFillPatterns)
    if (TakesSeveralLines(info.pattern)) all.push_back(info.pattern);
  return all;
}

std::vector<Piece> Lines(FillPattern pattern, int32_t lines, double pitch_nm, Coord z_nm,
                         int32_t layer = 0) {
  PatternContext context{
      .z_nm = z_nm, .layer = layer, .pitch_nm = pitch_nm, .spacing_nm = kSpacing};
  context.shape.lines = lines;
  return *PiecesOfPattern(pattern, SampleBox(), context);
}

class SideBySide : public testing::TestWithParam<FillPattern> {};
INSTANTIATE_TEST_SUITE_P(All, SideBySide, testing::ValuesIn(PatternsOfSeveralLines()),
                         [](const auto& info) {
                           return "P" + std::string(InfoOf(info.param).name);
                         });

// Groups of lines have the same density as single lines, on average over heights and positions.
TEST_P(SideBySide, KeepTheDensity) {
  constexpr int kPlaces = 60;
  constexpr double kPitch = 1.6e6;
  for (const int32_t lines : {2, 3}) {
    double length = 0, area = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const auto part = [&](double share) {
        return std::llround((i * share - std::floor(i * share)) * 12 * lines * kPitch);
      };
      MultiPolygon box = SampleBox();
      const Coord wider = part(0.3819660113) / 12;
      for (Point& p : box[0].outer) {
        const Point outwards{p.x > 0 ? wider : -wider, p.y > 0 ? wider : -wider};
        p = p + outwards + Point{part(0.6180339887), part(0.7548776662)};
      }
      PatternContext context{.z_nm = std::llround(i * kPitch * lines / std::numbers::sqrt2),
                             .layer = i,
                             .pitch_nm = kPitch,
                             .angle_rad = 0.5,
                             .spacing_nm = kSpacing};
      context.shape.lines = lines;
      length += LengthOf(*PiecesOfPattern(GetParam(), box, context));
      area += Area(box);
    }
    EXPECT_NEAR(length * kPitch / area, 1, 0.015) << lines;
  }
}

// In the middle of a straight line of a group, the next line is a spacing away.
TEST_P(SideBySide, LinesOfAGroupAreASpacingApart) {
  const std::vector<Piece> pieces = Lines(GetParam(), 2, 2e6, 1'100'000);
  ASSERT_FALSE(pieces.empty());
  int tested = 0, beside = 0;
  for (const Piece& piece : pieces) {
    const size_t middle = piece.points.size() / 2;
    const Point a = piece.points[middle - 1], b = piece.points[middle];
    const Point at{(a.x + b.x) / 2, (a.y + b.y) / 2};
    if (std::max(std::abs(at.x), std::abs(at.y)) > FromMm(20)) continue;
    double nearest = 1e12;
    for (const Piece& other : pieces)
      for (size_t i = 1; i < other.points.size(); ++i) {
        if (&other == &piece && i == middle) continue;
        const double distance = DistanceToSegment(at, other.points[i - 1], other.points[i]);
        if (distance > 0.3 * kSpacing) nearest = std::min(nearest, distance);
      }
    ++tested;
    if (nearest < 1.05 * kSpacing) ++beside;
  }
  ASSERT_GT(tested, 4);
  EXPECT_GE(beside, 0.75 * tested);
}

TEST(PiecesOfPattern, OneLineIsThePatternItself) {
  PatternContext context{.z_nm = 700'000, .pitch_nm = 2e6, .spacing_nm = kSpacing};
  for (const FillPattern pattern : {FillPattern::kGyroid, FillPattern::kGrid}) {
    const auto plain = PiecesOfPattern(pattern, SampleBox(), context);
    ASSERT_TRUE(plain.ok());
    EXPECT_EQ(plain->size(), Lines(pattern, 1, 2e6, 700'000).size());
  }
}

// Patterns with junctions of three lines keep single lines.
TEST(PiecesOfPattern, OtherPatternsKeepSingleLines) {
  for (const FillPattern pattern : {FillPattern::kHoneycombCells, FillPattern::kFermat}) {
    EXPECT_FALSE(TakesSeveralLines(pattern));
    EXPECT_EQ(LengthOf(Lines(pattern, 3, 2e6, 0)), LengthOf(Lines(pattern, 1, 2e6, 0)));
  }
}

}  // namespace
}  // namespace slicefarm::infill::side_by_side_test
