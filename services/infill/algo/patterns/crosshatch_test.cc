#include "services/infill/algo/patterns/crosshatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::crosshatch_test {
namespace {

constexpr double kPitch = 2e6;

std::vector<Piece> At(double z_mm, Coord spacing_nm = 400'000) {
  const PatternContext place{.z_nm = FromMm(z_mm), .pitch_nm = kPitch, .spacing_nm = spacing_nm};
  return *Crosshatch(SampleBox(), place);
}

bool IsStraight(const Piece& piece) { return piece.points.size() == 2; }

/// Returns x for lines that mainly run along x, y for lines along y.
char DirectionOf(const std::vector<Piece>& pieces) {
  const Polyline& line = std::ranges::max_element(pieces, {}, [](const Piece& piece) {
                           return piece.points.size();
                         })->points;
  const Point from = line.front(), to = line.back();
  return std::abs(to.x - from.x) > std::abs(to.y - from.y) ? 'x' : 'y';
}

// Bands of straight lines in one direction, with waves between bands of different directions.
TEST(Crosshatch, TurnsAfterEachBand) {
  std::string bands;
  int waves = 0;
  for (int layer = 0; layer < 100; ++layer) {
    const auto pieces = At(0.1 * layer);
    ASSERT_FALSE(pieces.empty());
    if (!std::ranges::all_of(pieces, IsStraight)) {
      ++waves;
      if (!bands.empty() && bands.back() != ' ') bands += ' ';
      continue;
    }
    const char direction = DirectionOf(pieces);
    if (bands.empty() || bands.back() != direction) bands += direction;
  }
  EXPECT_TRUE(bands.starts_with("x y x y")) << bands;
  EXPECT_GT(waves, 20);
  EXPECT_LT(waves, 60);
}

// At a turn of the direction, lines of the upper layer lie on lines of the layer below for more
// than a third of their length. Straight lines at right angles only cross.
TEST(Crosshatch, DirectionsShareDiagonalsWhereTheyTurn) {
  const auto near = [](const std::vector<Piece>& pieces, Point place) {
    return std::ranges::any_of(pieces, [place](const Piece& piece) {
      for (size_t i = 1; i < piece.points.size(); ++i) {
        const Point a = piece.points[i - 1], b = piece.points[i];
        const double length = Distance(a, b);
        const double along = (static_cast<double>(b.x - a.x) * static_cast<double>(place.x - a.x) +
                              static_cast<double>(b.y - a.y) * static_cast<double>(place.y - a.y)) /
                             length;
        if (along < 0 || along > length) continue;
        const Point foot = a + Point{std::llround(static_cast<double>(b.x - a.x) * along / length),
                                     std::llround(static_cast<double>(b.y - a.y) * along / length)};
        if (Distance(foot, place) < 200'000) return true;
      }
      return false;
    });
  };
  char before = DirectionOf(At(0));
  for (int layer = 1; layer < 100; ++layer) {
    const auto below = At(0.1 * (layer - 1)), above = At(0.1 * layer);
    const char direction = DirectionOf(above);
    if (std::exchange(before, direction) == direction) continue;
    int touching = 0, all = 0;
    for (const Piece& piece : above) {
      for (size_t i = 1; i < piece.points.size(); ++i) {
        const Point a = piece.points[i - 1], b = piece.points[i];
        const auto steps = static_cast<Coord>(Distance(a, b) / 100'000);
        for (Coord s = 0; s < steps; ++s, ++all)
          touching += near(below, {a.x + (b.x - a.x) * s / steps, a.y + (b.y - a.y) * s / steps});
      }
    }
    ASSERT_GT(all, 0);
    EXPECT_GT(touching, all / 3) << layer;
  }
}

// Bands are as high as lines are apart from 30 % on, and lower below.
TEST(Crosshatch, SparseLinesAreJoinedMoreOften) {
  const auto share_of_waves = [](Coord spacing_nm) {
    int waves = 0;
    for (int layer = 0; layer < 400; ++layer)
      waves += !std::ranges::all_of(At(0.05 * layer, spacing_nm), IsStraight);
    return waves / 400.0;
  };
  EXPECT_NEAR(share_of_waves(800'000), 0.4 / 1.4, 0.02);
  EXPECT_NEAR(share_of_waves(200'000), 0.4 / (0.4 + 0.393), 0.03);
}

}  // namespace
}  // namespace slicefarm::infill::crosshatch_test
