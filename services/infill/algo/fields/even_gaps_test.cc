#include "services/infill/algo/fields/even_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slicefarm::infill::even_gaps_test {
namespace {

/// Returns a line along x at height y, with points 0.4 mm apart.
StreamLine Along(double y, double from_x, double to_x) {
  StreamLine line;
  for (double x = from_x; x <= to_x + 1e-9; x += 0.4) line.points.push_back({x, y});
  return line;
}

double HeightAt(const StreamLine& line, double x) {
  return std::ranges::min_element(line.points, {}, [&](Vector2 p) { return std::abs(p.x() - x); })
      ->y();
}

void Even(double separation_mm, std::vector<StreamLine>& lines) {
  EvenGaps([=](Vector2) { return separation_mm; }, lines);
}

TEST(EvenGaps, LeaveEvenLinesAlone) {
  std::vector<StreamLine> lines;
  for (int i = 0; i < 8; ++i) lines.push_back(Along(2 * i, 0, 60));
  Even(2, lines);
  ASSERT_EQ(lines.size(), 8u);
  for (int i = 0; i < 8; ++i) {
    const StreamLine& line = lines[static_cast<size_t>(i)];
    ASSERT_FALSE(line.points.empty()) << i;
    for (const Vector2& p : line.points) EXPECT_NEAR(p.y(), 2 * i, 1e-9);
  }
}

TEST(EvenGaps, ShareOutAGapThatIsTooWide) {
  std::vector<StreamLine> lines;
  for (const double y : {0.0, 2.0, 4.0, 7.2, 9.2, 11.2}) lines.push_back(Along(y, 0, 80));
  Even(2, lines);
  for (size_t i = 1; i < lines.size(); ++i) {
    const double gap = HeightAt(lines[i], 40) - HeightAt(lines[i - 1], 40);
    EXPECT_GT(gap, 1.8) << i;
    EXPECT_LT(gap, 2.6) << i;
  }
}

// Two lines with the end of another line between them approach each other behind this end. Neither
// turns by more than some degrees.
TEST(EvenGaps, CloseBehindTheEndOfALine) {
  std::vector<StreamLine> lines;
  for (const double y : {0.0, 2.0, 4.0}) lines.push_back(Along(y, 0, 80));
  lines.push_back(Along(5.6, 0, 40));
  for (const double y : {7.2, 9.2, 11.2}) lines.push_back(Along(y, 0, 80));
  const auto gap = [&] { return HeightAt(lines[4], 60) - HeightAt(lines[2], 60); };
  ASSERT_NEAR(gap(), 3.2, 1e-9);
  Even(2, lines);
  EXPECT_LT(gap(), 3.0);
  for (const StreamLine& line : lines) {
    for (size_t i = 1; i < line.points.size(); ++i) {
      const Vector2 along = line.points[i] - line.points[i - 1];
      EXPECT_LT(std::abs(along.y() / along.x()), 0.12) << "7 degrees";
    }
  }
}

TEST(EvenGaps, KeepRingsClosedAndRound) {
  std::vector<StreamLine> rings;
  for (const double radius : {6.0, 8.0, 10.8, 12.8}) {
    StreamLine ring{{}, true};
    const int count = static_cast<int>(radius * 16);
    for (int i = 0; i < count; ++i) {
      const double turn = 2 * M_PI * i / count;
      ring.points.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    }
    rings.push_back(std::move(ring));
  }
  Even(2, rings);
  std::vector<double> radii;
  for (const StreamLine& ring : rings) {
    double least = 1e9, most = 0;
    for (const Vector2& p : ring.points)
      least = std::min(least, Norm(p)), most = std::max(most, Norm(p));
    EXPECT_LT(most - least, 0.1);
    radii.push_back(least);
  }
  EXPECT_LT(radii[2] - radii[1], 2.6);
  EXPECT_NEAR(radii[0], 6, 0.05) << "it has a neighbour on one side only";
}

TEST(EvenGaps, FollowASeparationThatGrows) {
  std::vector<StreamLine> lines;
  for (const double y : {0.0, 2.2, 4.6, 7.0, 9.8}) lines.push_back(Along(y, 0, 60));
  EvenGaps([](Vector2 at) { return 2 + 0.1 * at.y(); }, lines);
  for (size_t i = 1; i < lines.size(); ++i) {
    const double low = HeightAt(lines[i - 1], 30), high = HeightAt(lines[i], 30);
    EXPECT_NEAR((high - low) / (2 + 0.05 * (low + high)), 1, 0.1) << i;
  }
}

TEST(EvenGaps, TakeLinesOfOnePointAndNone) {
  std::vector<StreamLine> none;
  Even(2, none);
  std::vector<StreamLine> lines = {{{{1, 1}}, false}, {{}, false}, Along(0, 0, 10)};
  Even(2, lines);
  EXPECT_EQ(lines[0].points.front().x(), 1);
}

}  // namespace
}  // namespace slicefarm::infill::even_gaps_test
