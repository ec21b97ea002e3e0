#include "services/motion/algo/toolpath/divided_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/model/bead_section.h"
#include "services/motion/algo/toolpath/path_segment.h"

namespace slicefarm::motion::divided_path_test {
namespace {

constexpr Coord kHeight = 200'000;

Path Taper(Coord length_nm, Coord from_nm, Coord to_nm) {
  Path path;
  path.points = {{0, 0}, {length_nm, 0}};
  path.widths_nm = {from_nm, to_nm};
  return path;
}

double Plastic(const Path& path) {
  double plastic = 0;
  for (size_t i = 0; i < SegmentsOf(path); ++i) {
    const PathSegment segment = SegmentOf(path, i);
    plastic += SectionMm2(segment.width_nm, kHeight) * ToMm(Distance(segment.from, segment.to));
  }
  return plastic;
}

TEST(DividedByWidth, OneWidthStays) {
  Path path = Taper(FromMm(60), 450'000, 450'000);
  EXPECT_EQ(DividedByWidth(path, kHeight), path);
  path.widths_nm = {450'000};
  EXPECT_EQ(DividedByWidth(path, kHeight), path);
}

struct TaperCase {
  std::string name;
  double length_mm;
  double from_mm, to_mm;
  size_t pieces;
};

TEST(DividedByWidth, Pieces) {
  const std::vector<TaperCase> cases = {
      {"within the tolerance", 0.9, 0.44, 0.46, 1},
      {"long", 60, 0.35, 0.55, 20},
      {"narrowing", 60, 0.55, 0.35, 20},
      {"not below 0.4 mm for the tolerance alone", 2, 0.35, 0.55, 5},
      {"below 0.4 mm for the step", 0.4, 0.3, 0.45, 2},
      {"shorter where it is narrow", 0.4, 0.2, 0.6, 6},
      {"narrower than high", 0.4, 0.1, 0.15, 4},
      {"not below 0.0125 mm", 0.03, 0.2, 0.8, 2},
      {"shorter than two pieces", 0.024, 0.2, 0.8, 1},
  };
  for (const TaperCase& c : cases) {
    const Path path = Taper(FromMm(c.length_mm), FromMm(c.from_mm), FromMm(c.to_mm));
    const Path divided = DividedByWidth(path, kHeight);
    EXPECT_EQ(SegmentsOf(divided), c.pieces) << c.name;
    EXPECT_EQ(divided.points.front(), path.points.front()) << c.name;
    EXPECT_EQ(divided.points.back(), path.points.back()) << c.name;
    EXPECT_EQ(divided.widths_nm.front(), path.widths_nm.front()) << c.name;
    EXPECT_EQ(divided.widths_nm.back(), path.widths_nm.back()) << c.name;
    // The section of a disc's mean width is not its mean section.
    const double tolerance = FromMm(c.from_mm) < kHeight ? 0.02 : 1e-5;
    EXPECT_NEAR(Plastic(divided), Plastic(path), tolerance * Plastic(path)) << c.name;
  }
}

TEST(DividedByWidth, EveryBeadIsAsWideAsItsPlace) {
  const Path path = Taper(FromMm(60), FromMm(0.3), FromMm(0.9));
  const Path divided = DividedByWidth(path, kHeight);
  for (size_t i = 0; i < SegmentsOf(divided); ++i) {
    const PathSegment segment = SegmentOf(divided, i);
    for (const Point at : {segment.from, segment.to}) {
      const double due = FromMm(0.3) + 0.01 * static_cast<double>(at.x);
      EXPECT_NEAR(static_cast<double>(segment.width_nm), due, kLongWidthToleranceNm + 2);
    }
  }
}

// Tests the closing edge, and steps of the width at one place.
TEST(DividedByWidth, Rings) {
  Path ring;
  ring.closed = true;
  ring.points = {{0, 0}, {FromMm(4), 0}, {FromMm(4), 0}, {0, FromMm(3)}};
  ring.widths_nm = {400'000, 400'000, 500'000, 500'000};
  const Path divided = DividedByWidth(ring, kHeight);
  EXPECT_EQ(divided.points.size(), ring.points.size() + 4);
  EXPECT_TRUE(divided.closed);
  EXPECT_EQ(divided.points[2], ring.points[2]);
  EXPECT_NEAR(Plastic(divided), Plastic(ring), 1e-6 * Plastic(ring));
}

}  // namespace
}  // namespace slicefarm::motion::divided_path_test
