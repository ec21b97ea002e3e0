#include "services/beading/algo/arachne/node_beading.h"

#include <gtest/gtest.h>

#include <string>

#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::beading::node_beading_test {
namespace {

constexpr double kRatios[] = {0, 0.25, 0.5, 1};

/// Checks that the side beads touch each other from the boundary on, with the middle bead between
/// them and nothing left over.
void ExpectTiles(const NodeBeading& beading, double radius, double error_nm) {
  double edge = 0, sum = beading.has_middle ? beading.middle_width : 0;
  for (const SideBead& bead : beading.sides) {
    EXPECT_NEAR(bead.location - bead.width / 2, edge, error_nm);
    edge = bead.location + bead.width / 2;
    sum += 2 * bead.width;
  }
  EXPECT_NEAR(sum, 2 * radius, error_nm);
  EXPECT_NEAR(edge + beading.middle_width / 2, radius, error_nm);
}

TEST(NodeBeading, OfAnEvenBeadingAreItsFirstHalf) {
  const NodeBeading beading = FromBeading({1'600, {300, 500, 500, 300}, {150, 550, 1'050, 1'450}});
  EXPECT_EQ(beading, (NodeBeading{{{300, 150}, {500, 550}}, false, 0}));
}

TEST(NodeBeading, OfAnOddBeadingIsTheHalfAndTheMiddle) {
  const NodeBeading beading = FromBeading({1'000, {300, 400, 300}, {150, 500, 850}});
  EXPECT_EQ(beading, (NodeBeading{{{300, 150}}, true, 400}));
}

TEST(NodeBeading, OfNoBeadIsNothing) { EXPECT_EQ(FromBeading({500, {}, {}}), NodeBeading{}); }

TEST(NodeBeading, OfAMarkerInTheMiddleIsAMarker) {
  const NodeBeading beading = FromBeading({600, {300, 0, 300}, {150, 300, 450}});
  EXPECT_EQ(beading, (NodeBeading{{{300, 150}}, true, 0}));
}

TEST(NodeBeading, BetweenOddAndEvenTheMiddleSplits) {
  const NodeBeading odd = {{{400, 200}}, true, 600}, even = {{{400, 200}, {300, 550}}, false, 0};
  const NodeBeading other = {{{300, 150}, {400, 500}}, false, 0};
  EXPECT_EQ(Between(odd, even, 0, 700), even);
  EXPECT_EQ(Between(odd, other, 0, 700), even);
  EXPECT_EQ(Between(odd, other, 0.25, 700), (NodeBeading{{{375, 187.5}, {325, 537.5}}, false, 0}));
  EXPECT_EQ(Between(odd, other, 1, 700), other);
}

TEST(NodeBeading, BetweenEvenAndOddTheMiddleGrows) {
  const NodeBeading even = {{{400, 200}, {300, 550}}, false, 0};
  const NodeBeading odd = {{{400, 200}, {200, 500}}, true, 200};
  EXPECT_EQ(Between(even, odd, 0, 700), (NodeBeading{{{400, 200}, {300, 550}}, true, 0}));
  EXPECT_EQ(Between(even, odd, 0.5, 700), (NodeBeading{{{400, 200}, {250, 525}}, true, 100}));
  EXPECT_EQ(Between(even, odd, 1, 700), odd);
}

// The thicknesses are ones at which both layouts fill the node.
class BetweenCounts : public testing::TestWithParam<int> {};

TEST_P(BetweenCounts, BeadsTileTheThickness) {
  const int lower = GetParam();
  const auto strategy = MakeStrategy({});
  const Coord thickness = strategy->TransitionThickness(lower);
  const double radius = static_cast<double>(thickness) / 2;
  const NodeBeading a = FromBeading(strategy->Compute(thickness, lower));
  const NodeBeading b = FromBeading(strategy->Compute(thickness, lower + 1));
  ExpectTiles(a, radius, 2);
  ExpectTiles(b, radius, 2);
  for (const double ratio : kRatios) {
    SCOPED_TRACE(ratio);
    const NodeBeading mixed = Between(a, b, ratio, radius);
    EXPECT_EQ(mixed.sides.size(), static_cast<size_t>(lower + 1) / 2);
    EXPECT_EQ(mixed.has_middle, lower % 2 == 0);
    ExpectTiles(mixed, radius, 2);
  }
  EXPECT_EQ(Between(a, b, 1, radius), b);
}

INSTANTIATE_TEST_SUITE_P(NodeBeading, BetweenCounts, testing::Values(1, 2, 3, 4, 5, 6, 7),
                         testing::PrintToStringParamName());

TEST(NodeBeading, ABlendEndsInTheSecond) {
  const NodeBeading a = {{{500, 250}}, false, 0};
  const NodeBeading b = {{{400, 200}, {340, 570}, {0, 740}}, true, 50};
  EXPECT_EQ(Blend(a, b, 1, 500), b);
  EXPECT_EQ(Blend({}, b, 0.3, 0), b);
}

// Beads that only the second layout has keep their inner edge there, unless a bead that was wider
// before needs the space.
TEST(NodeBeading, ABlendKeepsBeadsTouching) {
  const NodeBeading wide = {{{500, 250}}, false, 0}, narrow = {{{200, 100}}, false, 0};
  const NodeBeading huge = {{{1'000, 500}}, false, 0}, odd = {{{400, 200}}, true, 500};
  const NodeBeading b = {{{400, 200}, {300, 550}, {400, 900}}, false, 0};
  for (const NodeBeading& a : {wide, narrow, huge, odd}) {
    for (const double ratio : kRatios) {
      SCOPED_TRACE(ratio);
      const NodeBeading mixed = Blend(a, b, ratio, 650);
      ASSERT_EQ(mixed.sides.size(), 3u);
      double edge = 0;
      for (const SideBead& bead : mixed.sides) {
        EXPECT_NEAR(bead.location - bead.width / 2, edge, 1e-6);
        EXPECT_GE(bead.width, 0);
        edge = bead.location + bead.width / 2;
      }
      EXPECT_NEAR(edge, 1'100, 1e-6);
    }
  }
}

// A marker stretched to its position in the second layout had become a bead.
TEST(NodeBeading, ABlendKeepsMarkersMarkers) {
  const NodeBeading narrow = {{{300, 150}}, false, 0}, wide = {{{600, 300}}, false, 0};
  const NodeBeading one = {{{400, 200}, {0, 400}}, false, 0};
  const NodeBeading two = {{{400, 200}, {400, 600}, {0, 800}}, false, 0};
  for (const NodeBeading& a : {narrow, wide}) {
    for (const NodeBeading& b : {one, two}) {
      for (const double ratio : kRatios) {
        SCOPED_TRACE(ratio);
        const NodeBeading mixed = Blend(a, b, ratio, 300);
        ASSERT_EQ(mixed.sides.size(), b.sides.size());
        const SideBead &marker = mixed.sides.back(), &last = mixed.sides[b.sides.size() - 2];
        EXPECT_EQ(marker.width, 0);
        EXPECT_NEAR(marker.location, last.location + last.width / 2, 1e-6);
        EXPECT_GT(last.width, 0);
      }
    }
  }
}

TEST(NodeBeading, ABlendOfMarkersIsAMarker) {
  const NodeBeading a = {{{400, 200}, {0, 400}}, false, 0}, b = {{{500, 250}, {0, 500}}, false, 0};
  EXPECT_EQ(Blend(a, b, 0.5, 700), (NodeBeading{{{450, 225}, {0, 450}}, false, 0}));
}

}  // namespace
}  // namespace slicefarm::beading::node_beading_test
