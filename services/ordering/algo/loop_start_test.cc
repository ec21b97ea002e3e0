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
