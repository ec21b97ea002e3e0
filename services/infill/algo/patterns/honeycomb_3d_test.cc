#include "services/infill/algo/patterns/honeycomb_3d.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::honeycomb_3d_test {
namespace {

TEST(Honeycomb3d, WavesGrowFromNothingAndTurn) {
  const PatternContext flat{.z_nm = 0, .pitch_nm = 2e6, .spacing_nm = 400'000};
  const auto rows = Honeycomb3d(SampleBox(), flat);
  for (const Piece& row : *rows) EXPECT_EQ(row.points.size(), 2u);
  PatternContext context = flat;
  double least = 1e18, most = 0;
  for (; context.z_nm < 1'700'000; context.z_nm += 100'000) {
    const double length = LengthOf(*Honeycomb3d(SampleBox(), context));
    least = std::min(least, length), most = std::max(most, length);
  }
  EXPECT_GT(most / least, 1.1);
  EXPECT_LT(most / least, 1.3);
}

}  // namespace
}  // namespace slicefarm::infill::honeycomb_3d_test
