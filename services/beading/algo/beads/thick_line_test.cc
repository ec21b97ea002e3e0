#include "services/beading/algo/beads/thick_line.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::thick_line_test {
namespace {

ThickLine Line(std::string_view text, std::vector<double> thickness_mm) {
  ThickLine line{false, MakeLineOrDie(text), {}};
  for (const double t : thickness_mm) line.thickness_nm.push_back(FromMm(t));
  return line;
}

TEST(ThickLine, LengthAndAreaCountTheClosingEdge) {
  ThickLine line = Line("(0 0, 3 0, 3 4)", {1, 1, 1});
  EXPECT_DOUBLE_EQ(Length(line), 7e6);
  EXPECT_DOUBLE_EQ(Area(line), 7e12);
  line.closed = true;
  EXPECT_DOUBLE_EQ(Length(line), 12e6);
  EXPECT_DOUBLE_EQ(Area(line), 12e12);
}

TEST(ThickLine, MergeShortEdgesLeavesLongOnes) {
  const std::vector<double> even(7, 0.4);
  const ThickLine line = Line("(0 0, 1 0, 1.1 0.02, 1.2 0, 1.3 0.02, 1.4 0, 3 0)", even);
  EXPECT_EQ(MergeShortEdges(line, FromMm(0.5), FromMm(0.025)),
            Line("(0 0, 1 0, 1.4 0, 3 0)", {0.4, 0.4, 0.4, 0.4}));
  EXPECT_EQ(MergeShortEdges(line, FromMm(0.5), FromMm(0.01)), line) << "it would move too far";
  EXPECT_EQ(MergeShortEdges(line, FromMm(0.05), FromMm(0.025)), line) << "no edge is short";
  const ThickLine bulge = Line("(0 0, 0.1 0, 0.2 0)", {0.4, 0.5, 0.4});
  EXPECT_EQ(MergeShortEdges(bulge, FromMm(0.5), FromMm(0.025)), bulge) << "its width matters";
  ThickLine loop = Line("(0 0, 0.01 0, 0.01 0.01)", {0.4, 0.4, 0.4});
  loop.closed = true;
  EXPECT_EQ(MergeShortEdges(loop, FromMm(0.5), FromMm(0.1)), loop);
}

TEST(ThickLine, CutEndInterpolatesThickness) {
  ThickLine line = Line("(0 0, 4 0, 8 0)", {1, 1, 3});
  CutEnd(line, 1e6);
  EXPECT_EQ(line, Line("(0 0, 4 0, 7 0)", {1, 1, 2.5}));
  CutEnd(line, 5e6);
  EXPECT_EQ(line, Line("(0 0, 2 0)", {1, 1}));
  CutEnd(line, 2e6);
  EXPECT_TRUE(line.points.empty());
}

TEST(ThickLine, ExtendEndLooksPastATinyLastEdge) {
  ThickLine line = Line("(0 0, 4 0, 4 0.001)", {1, 1, 2});
  ExtendEnd(line, 1e6);
  ASSERT_EQ(line.points.size(), 4u);
  EXPECT_NEAR(line.points.back().x, 5e6, 2e3);
  EXPECT_NEAR(line.points.back().y, 0, 2e3);
  EXPECT_EQ(line.thickness_nm.back(), FromMm(2));
}

TEST(ThickLine, SimplifyKeepsBendsInPlaceAndInThickness) {
  EXPECT_EQ(SimplifyThickLine(Line("(0 0, 1 0, 2 0, 3 0)", {1, 1.1, 1.2, 1.3}), 1000),
            Line("(0 0, 3 0)", {1, 1.3}));
  const ThickLine swelling = Line("(0 0, 1 0, 2 0)", {1, 1.5, 1});
  EXPECT_EQ(SimplifyThickLine(swelling, 1000), swelling);
  const ThickLine bend = Line("(0 0, 1 0.5, 2 0)", {1, 1, 1});
  EXPECT_EQ(SimplifyThickLine(bend, 1000), bend);
}

TEST(ThickLine, ReverseTwiceIsTheSame) {
  const ThickLine line = Line("(0 0, 1 2, 2 0)", {1, 2, 3});
  ThickLine turned = line;
  Reverse(turned);
  EXPECT_EQ(turned, Line("(2 0, 1 2, 0 0)", {3, 2, 1}));
  Reverse(turned);
  EXPECT_EQ(turned, line);
}

}  // namespace
}  // namespace slicefarm::beading::thick_line_test
