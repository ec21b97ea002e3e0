#include "services/infill/algo/patterns/honeycomb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::honeycomb_test {
namespace {

// Beads without width give sides of 8 / (3 sqrt 3) and 2 / sqrt 3 pitches.
TEST(Honeycomb, SidesFollowFromTheLaw) {
  const PatternContext context{.pitch_nm = 2e6, .spacing_nm = 0};
  const auto longest = [](const std::vector<Piece>& pieces) {
    double most = 0;
    for (const Piece& piece : pieces)
      for (size_t i = 1; i < piece.points.size(); ++i)
        most = std::max(most, Distance(piece.points[i - 1], piece.points[i]));
    return most;
  };
  EXPECT_NEAR(longest(*Honeycomb(SampleBox(), context)), 8 / (3 * std::sqrt(3.0)) * 2e6, 5);
  EXPECT_NEAR(longest(*HoneycombCells(SampleBox(), context)), 2 / std::sqrt(3.0) * 2e6, 5);
}

TEST(Honeycomb, RowsLieASpacingApartWhereTheyMeet) {
  const auto rows = Honeycomb(SampleBox(), {.pitch_nm = 2e6, .spacing_nm = 400'000});
  Coord nearest = kNmPerMm;
  for (const Piece& a : *rows)
    for (const Piece& b : *rows)
      for (const Point p : a.points)
        for (const Point q : b.points)
          if (p.y > q.y && &a != &b) nearest = std::min(nearest, p.y - q.y);
  EXPECT_NEAR(static_cast<double>(nearest), 400'000, 3);
}

}  // namespace
}  // namespace slicefarm::infill::honeycomb_test
