#include "services/ordering/algo/loop_start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/text_format.h"
#include "common/model/paths_test.h"

namespace slicefarm::ordering {
namespace {

using ::testing::ElementsAre;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

Path Loop(std::string_view points) { return MakePathOrDie(points, true); }

constexpr std::string_view kSquare = "(0 0, 10 0, 10 10, 0 10)";

TEST(NearestVertex, IsTheLeastOfEquals) {
  const Path square = Loop(kSquare);
  EXPECT_EQ(NearestVertex(square.points, Mm(9, 8)).at, Mm(10, 10));
  EXPECT_EQ(NearestVertex(square.points, Mm(5, 5)).at, Mm(0, 0));
  EXPECT_EQ(NearestVertex(Loop("(10 10, 0 10, 0 0, 10 0)").points, Mm(5, 5)).at, Mm(0, 0));
}

TEST(SeamOf, IsTheNearestToTheLoop) {
  const Path square = Loop(kSquare);
  EXPECT_EQ(SeamOf(square.points, {{Mm(50, 50)}}), Mm(50, 50));
  EXPECT_EQ(SeamOf(square.points, {{Mm(50, 50), Mm(11, 11), Mm(-2, -2)}}), Mm(11, 11));
}

struct PlaceCase {
  std::string name;
  std::string loop;
  Point seam;
  LoopPlace want;
};

class NearestToSeamTest : public testing::TestWithParam<PlaceCase> {};

TEST_P(NearestToSeamTest, StartsThere) {
  const PlaceCase& c = GetParam();
  EXPECT_EQ(NearestToSeam(Loop(c.loop).points, c.seam), c.want);
}

INSTANTIATE_TEST_SUITE_P(
    Seams, NearestToSeamTest,
    testing::Values(
        PlaceCase{"AtACorner", std::string(kSquare), Mm(10.2, 10.2), {2, Mm(10, 10)}},
        PlaceCase{"FarFromCorners", std::string(kSquare), Mm(4, -0.2), {0, Mm(4, 0)}},
        PlaceCase{"OnTheClosingEdge", std::string(kSquare), Mm(0, 6), {3, Mm(0, 6)}},
        // The notch's corner is 1.41 times as far as its edges, but hides the seam.
        PlaceCase{"InnerCorner", "(0 0, 10 0, 10 10, 5 10, 5 5, 0 5)", Mm(4.7, 5.3), {4, Mm(5, 5)}},
        PlaceCase{
            "VertexIsNearEnough", "(0 0, 0.15 0, 10 0, 10 10)", Mm(0.08, 0), {1, Mm(0.15, 0)}}),
    [](const auto& info) { return info.param.name; });

TEST(StartAt, RotatesToAVertex) {
  Path loop = Loop(kSquare);
  loop.widths_nm = {1, 2, 3, 4};
  StartAt({2, Mm(10, 10)}, loop);
  EXPECT_EQ(loop.points, MakeLineOrDie("(10 10, 0 10, 0 0, 10 0)"));
  EXPECT_THAT(loop.widths_nm, ElementsAre(3, 4, 1, 2));
}

TEST(StartAt, CutsAnEdge) {
  Path loop = Loop(kSquare);
  loop.widths_nm = {400, 500, 400, 400};
  StartAt({0, Mm(5, 0)}, loop);
  EXPECT_EQ(loop.points, MakeLineOrDie("(5 0, 10 0, 10 10, 0 10, 0 0)"));
  EXPECT_THAT(loop.widths_nm, ElementsAre(450, 500, 400, 400, 400));
  EXPECT_EQ(PathLength(loop), 40.0 * kNmPerMm);
}

TEST(StartAt, CutsTheClosingEdge) {
  Path loop = Loop(kSquare);
  StartAt({3, Mm(0, 6)}, loop);
  EXPECT_EQ(loop.points, MakeLineOrDie("(0 6, 0 0, 10 0, 10 10, 0 10)"));
  EXPECT_THAT(loop.widths_nm, ElementsAre(450'000));
}

}  // namespace
}  // namespace slicefarm::ordering
