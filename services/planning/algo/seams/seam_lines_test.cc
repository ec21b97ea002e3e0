#include "services/planning/algo/seams/seam_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::seam_lines_test {
namespace {

/// Returns a choice on a long straight wall, with neighbours a millimetre to either side.
SeamChoice OnAWall(int32_t parent, double x_mm) {
  return {parent, Mm(x_mm, 0), Mm(x_mm - 1, 0), Mm(x_mm + 1, 0)};
}

SeamChoice Fixed(int32_t parent, double x_mm) {
  return {parent, Mm(x_mm, 0), Mm(x_mm, 0), Mm(x_mm, 0)};
}

/// Returns one line of seams at the given positions.
std::vector<SeamChoice> LineOf(const std::vector<double>& x_mm) {
  std::vector<SeamChoice> line;
  for (const double x : x_mm) line.push_back(OnAWall(static_cast<int32_t>(line.size()) - 1, x));
  return line;
}

double LongestStepMm(const std::vector<Point>& seams) {
  double longest = 0;
  for (size_t i = 1; i < seams.size(); ++i)
    longest = std::max(longest, ToMm(Distance(seams[i - 1], seams[i])));
  return longest;
}

TEST(SeamLines, UprightAndLeaningLinesStay) {
  for (const double step : {0.0, 0.1, 0.8}) {
    std::vector<double> x;
    for (int i = 0; i < 40; ++i) x.push_back(step * i);
    const std::vector<SeamChoice> line = LineOf(x);
    const std::vector<Point> seams = SmoothSeams(line);
    for (size_t i = 0; i < line.size(); ++i) EXPECT_LT(Distance(seams[i], line[i].at), 2) << i;
  }
}

TEST(SeamLines, AStepIsSpreadOverTheLayersAround) {
  std::vector<double> x(40, 0);
  std::fill(x.begin() + 20, x.end(), 0.8);
  const std::vector<Point> seams = SmoothSeams(LineOf(x));
  EXPECT_LE(LongestStepMm(seams), 0.8 / 9 + 1e-5);
  EXPECT_EQ(seams.front(), Mm(0, 0));
  EXPECT_EQ(seams.back(), Mm(0.8, 0));
  EXPECT_TRUE(std::ranges::is_sorted(seams));
}

TEST(SeamLines, FixedOnesStayAndNothingReachesBeyondThem) {
  std::vector<SeamChoice> line = LineOf(std::vector<double>(20, 0));
  line[10] = Fixed(9, 0.8);
  std::vector<SeamChoice> other = line;
  for (size_t i = 11; i < 20; ++i) other[i].at = Mm(1, 0);
  const std::vector<Point> seams = SmoothSeams(line), others = SmoothSeams(other);
  EXPECT_EQ(seams[10], Mm(0.8, 0));
  EXPECT_GT(seams[9].x, 0) << "drawn to the fixed one";
  for (size_t i = 0; i <= 10; ++i) EXPECT_EQ(seams[i], others[i]) << i;
}

TEST(SeamLines, SeamsStayOnTheirWalls) {
  std::vector<SeamChoice> line = LineOf(std::vector<double>(20, 0));
  line[10] = {9, Mm(0, 3), Mm(-1, 3), Mm(1, 4)};
  const std::vector<Point> seams = SmoothSeams(line);
  EXPECT_EQ(seams[10].y, Mm(0, 3).y);
  EXPECT_EQ(seams[9].y, 0);
}

TEST(SeamLines, LinesEndWhereNothingFollowsAndPartAtSplits) {
  std::vector<SeamChoice> choices = LineOf(std::vector<double>(10, 0));
  choices.push_back(OnAWall(9, 0.5));   // continues the line
  choices.push_back(OnAWall(9, -0.5));  // starts its own line
  choices.push_back(OnAWall(-1, 7));    // starts after a jump
  const std::vector<Point> seams = SmoothSeams(choices);
  EXPECT_GT(seams[9].x, 0) << "drawn to the first alone";
  EXPECT_EQ(seams[10], Mm(0.5, 0));
  EXPECT_EQ(seams[11], Mm(-0.5, 0));
  EXPECT_EQ(seams[12], Mm(7, 0));
  EXPECT_TRUE(SmoothSeams({}).empty());
}

}  // namespace
}  // namespace slicefarm::planning::seam_lines_test
