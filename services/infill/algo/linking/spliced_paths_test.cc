#include "services/infill/algo/linking/spliced_paths.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::spliced_paths_test {
namespace {

constexpr double kMargin = 0.5e6;
/// Length lost at two square corners that are cut off by 0.45 margins.
constexpr double kCutOff = 2 * (2 - std::numbers::sqrt2) * 0.45 * kMargin;

Path Make(std::string_view line, bool closed) {
  Path path;
  path.feature = Feature::kInternalInfill;
  path.closed = closed;
  path.points = MakeLineOrDie(line);
  path.widths_nm = {450'000};
  return path;
}

double LengthOf(const std::vector<Path>& paths) {
  double length = 0;
  for (const Path& path : paths) length += PathLength(path);
  return length;
}

TEST(SplicedPaths, RingIsTakenInWhereItIsCrossedFirst) {
  const auto paths =
      SplicedPaths({Make("(0 5, 20 5)", false), Make("(4 0, 8 0, 8 10, 4 10)", true)}, kMargin);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_FALSE(paths[0].closed);
  EXPECT_EQ(paths[0].points,
            MakeLineOrDie("(0 5, 7.775 5, 8 5.225, 8 10, 4 10, 4 0, 8 0, 8 4.775, 8.225 5, 20 5)"));
  EXPECT_EQ(paths[0].widths_nm.size(), 1u);
  EXPECT_NEAR(PathLength(paths[0]), 48e6 - kCutOff, 1);
}

TEST(SplicedPaths, RingsBecomeOneRing) {
  const std::vector<Path> rings = {Make("(0 0, 6 0, 6 6, 0 6)", true),
                                   Make("(3 3, 9 3, 9 9, 3 9)", true),
                                   Make("(7 7, 12 7, 12 12, 7 12)", true)};
  const auto paths = SplicedPaths(rings, kMargin);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_TRUE(paths[0].closed);
  EXPECT_NEAR(LengthOf(paths), LengthOf(rings) - 2 * kCutOff, 2);
}

TEST(SplicedPaths, WhatDoesNotCrossStays) {
  const std::vector<Path> apart = {Make("(0 0, 6 0, 6 6, 0 6)", true),
                                   Make("(8 0, 9 0, 9 9, 8 9)", true), Make("(0 8, 20 20)", false)};
  EXPECT_EQ(SplicedPaths(apart, kMargin), apart);
  // One path crosses at the corner of a ring, and two open lines cross without returning.
  const std::vector<Path> others = {Make("(0 0.3, 20 0.3)", false),
                                    Make("(4 0, 8 0, 8 10, 4 10)", true),
                                    Make("(15 -5, 15 5)", false)};
  EXPECT_EQ(SplicedPaths(others, kMargin), others);
}

// A comparison of all pairs of rings would be quadratic.
TEST(SplicedPaths, ManyRingsAreFast) {
  constexpr Coord kInRow = 450;
  const Path pair[] = {Make("(0 0, 2 0, 2 2, 0 2)", true), Make("(1 1, 3 1, 3 3, 1 3)", true)};
  std::vector<Path> rings;
  for (Coord i = 0; i < kInRow * kInRow; ++i) {
    for (Path ring : pair) {
      for (Point& p : ring.points)
        p = p + Point{FromMm(4) * (i % kInRow), FromMm(4) * (i / kInRow)};
      rings.push_back(std::move(ring));
    }
  }
  EXPECT_EQ(SplicedPaths(rings, kMargin).size(), rings.size() / 2);
}

}  // namespace
}  // namespace slicefarm::infill::spliced_paths_test
