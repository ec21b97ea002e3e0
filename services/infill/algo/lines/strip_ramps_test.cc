#include "services/infill/algo/lines/strip_ramps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/model/bead_section.h"

namespace slicefarm::infill::strip_ramps_test {
namespace {

constexpr double kPitch = 400'000;
constexpr Coord kHeight = 200'000;

using Bead = std::vector<StripPoint>;

/// Returns the greatest ratio of the mean strips of neighbouring edges.
double GreatestStep(const Bead& bead) {
  double greatest = 1;
  for (size_t i = 2; i < bead.size(); ++i) {
    const double before = bead[i - 2].strip_nm + bead[i - 1].strip_nm;
    const double after = bead[i - 1].strip_nm + bead[i].strip_nm;
    greatest = std::max({greatest, before / after, after / before});
  }
  return greatest;
}

TEST(EvenRamps, OneWidthStaysAsItIs) {
  const Bead bead = {{{0, 0}, kPitch}, {{5'000'000, 0}, kPitch}, {{5'000'000, 400'000}, kPitch}};
  EXPECT_EQ(EvenRamps(bead, kPitch), bead);
}

// The width doubles and returns within half a pitch, and at one point.
TEST(EvenRamps, NoStepIsGreaterThanAFifth) {
  const Bead steep = {{{0, 0}, kPitch},
                      {{3'000'000, 0}, kPitch},
                      {{3'200'000, 0}, 2 * kPitch},
                      {{3'400'000, 0}, kPitch},
                      {{6'000'000, 0}, kPitch}};
  const Bead step = {{{0, 0}, kPitch},
                     {{3'000'000, 0}, kPitch},
                     {{3'000'000, 0}, 0.6 * kPitch},
                     {{6'000'000, 0}, 0.6 * kPitch}};
  for (const Bead& bead : {steep, step}) {
    EXPECT_GT(GreatestStep(bead), 1.25);
    const Bead even = EvenRamps(bead, kPitch);
    EXPECT_LE(GreatestStep(even), 1.21);
    EXPECT_EQ(even.front().at, bead.front().at);
    EXPECT_EQ(even.back().at, bead.back().at);
    // No point becomes narrower, and narrow parts far from a wide part stay narrow.
    for (const StripPoint& p : bead)
      EXPECT_TRUE(std::ranges::any_of(
          even, [&](const StripPoint& q) { return q.at == p.at && q.strip_nm >= p.strip_nm; }));
  }
  EXPECT_NEAR(EvenRamps(step, kPitch).back().strip_nm, 0.6 * kPitch, 1);
}

TEST(EvenRamps, BackwardsIsTheSame) {
  Bead bead = {{{0, 0}, kPitch}, {{900'000, 0}, 0.6 * kPitch}, {{900'000, 300'000}, 1.3 * kPitch}};
  Bead even = EvenRamps(bead, kPitch);
  std::ranges::reverse(bead);
  Bead back = EvenRamps(bead, kPitch);
  std::ranges::reverse(back);
  ASSERT_EQ(even.size(), back.size());
  for (size_t i = 0; i < even.size(); ++i) {
    EXPECT_EQ(even[i].at, back[i].at);
    EXPECT_NEAR(even[i].strip_nm, back[i].strip_nm, 1);
  }
}

TEST(PathOfStrip, SectionsAreTheStrips) {
  const Bead bead = {{{0, 0}, kPitch}, {{1'000'000, 0}, kPitch}, {{2'000'000, 0}, 0.7 * kPitch}};
  const Path path = PathOfStrip(bead, kHeight);
  ASSERT_EQ(path.widths_nm.size(), 3u);
  for (size_t i = 0; i < bead.size(); ++i)
    EXPECT_NEAR(SectionMm2(path.WidthAt(i), kHeight), bead[i].strip_nm * kHeight / 1e12, 1e-6);
  EXPECT_EQ(PathOfStrip({bead[0], bead[1]}, kHeight).widths_nm.size(), 1u);
}

// Two equal points with different widths are a step of the width. With the same width they are one
// point.
TEST(PathOfStrip, StepsStay) {
  const Bead bead = {{{0, 0}, kPitch},
                     {{1'000'000, 0}, kPitch},
                     {{1'000'000, 0}, kPitch},
                     {{1'000'000, 0}, 0.2 * kPitch},
                     {{1'000'000, 400'000}, 0.2 * kPitch}};
  const Path path = PathOfStrip(bead, kHeight);
  ASSERT_EQ(path.points.size(), 4u);
  EXPECT_EQ(path.points[1], path.points[2]);
  EXPECT_NE(path.WidthAt(1), path.WidthAt(2));
}

}  // namespace
}  // namespace slicefarm::infill::strip_ramps_test
