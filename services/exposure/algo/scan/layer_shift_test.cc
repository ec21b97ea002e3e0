#include "services/exposure/algo/scan/layer_shift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure::layer_shift_test {
namespace {

TEST(GridShift, AllPlacesOfAPeriodComeInTurn) {
  ExposureOptions options;
  options.strategy = ScanStrategy::kIslands;
  const Coord period = 2 * options.island_width_nm;
  std::array<int, 25> seen{};
  for (int32_t layer = 0; layer < 100; ++layer) {
    const Point shift = GridShift(layer, 0, options);
    ASSERT_TRUE(shift.x >= 0 && shift.x <= period && shift.y >= 0 && shift.y <= period);
    const auto fifth = [&](Coord at) {
      return static_cast<size_t>(std::min<Coord>(4, 5 * at / period));
    };
    ++seen[5 * fifth(shift.y) + fifth(shift.x)];
  }
  // A perfectly even distribution would have four in each class.
  EXPECT_GE(*std::ranges::min_element(seen), 2);
  EXPECT_LE(*std::ranges::max_element(seen), 6);
}

TEST(GridShift, TurnsWithTheLines) {
  const ExposureOptions options;
  const Point along = GridShift(7, 0, options), turned = GridShift(7, 90, options);
  EXPECT_EQ(turned, (Point{-along.y, along.x}));
}

TEST(GridShift, NoneIfNotAskedFor) {
  ExposureOptions options;
  EXPECT_EQ(GridShift(0, 45, options), Point{});
  EXPECT_NE(GridShift(1, 45, options), Point{});
  options.shift_grids = false;
  EXPECT_EQ(GridShift(1, 45, options), Point{});
}

TEST(BorderLines, AllCountsComeInTurn) {
  ExposureOptions options;
  std::array<int, kBorderTurns> seen{};
  for (int32_t layer = 0; layer < 10 * kBorderTurns; ++layer) {
    const int32_t lines = BorderLines(layer, options);
    ASSERT_TRUE(lines >= 0 && lines < kBorderTurns);
    ++seen[static_cast<size_t>(lines)];
    EXPECT_NE(lines, BorderLines(layer + 1, options));
  }
  for (const int count : seen) EXPECT_EQ(count, 10);
}

TEST(BorderLines, NoneWhereHatchDoesNotOverlapTheContour) {
  const auto lines = [](auto change) {
    ExposureOptions options;
    change(options);
    return BorderLines(1, options);
  };
  EXPECT_GT(lines([](ExposureOptions&) {}), 0);
  EXPECT_EQ(lines([](ExposureOptions& o) { o.shift_grids = false; }), 0);
  EXPECT_EQ(lines([](ExposureOptions& o) { o.contours = 0; }), 0);
  EXPECT_EQ(lines([](ExposureOptions& o) { o.hatch_offset_nm = 41'000; }), 0);
  EXPECT_EQ(lines([](ExposureOptions& o) { o.strategy = ScanStrategy::kRings; }), 0);
}

TEST(RingTurnOf, EachRingHasItsTurn) {
  std::array<int, kCornerTurns> seen{};
  for (int32_t layer = 0; layer < 100; ++layer) {
    const RingTurn turn = RingTurnOf(layer);
    ASSERT_TRUE(turn.nearer >= 0 && turn.nearer < 1);
    ++seen[static_cast<size_t>(turn.corner)];
  }
  for (const int count : seen) EXPECT_EQ(count, 100 / kCornerTurns);
}

TEST(RingStart, AllSharesComeInTurn) {
  std::array<int, 10> seen{};
  for (int32_t layer = 0; layer < 100; ++layer) ++seen[static_cast<size_t>(10 * RingStart(layer))];
  EXPECT_GE(*std::ranges::min_element(seen), 9);
}

TEST(CutVariant, OfLayersAboveEachOtherDiffer) {
  ExposureOptions options;
  EXPECT_EQ(CutVariant(0, options), 0);
  for (int32_t layer = 0; layer < 9; ++layer)
    EXPECT_NE(CutVariant(layer, options), CutVariant(layer + 1, options));
  options.turn_rings = false;
  EXPECT_EQ(CutVariant(1, options), 0);
}

}  // namespace
}  // namespace slicefarm::exposure::layer_shift_test
