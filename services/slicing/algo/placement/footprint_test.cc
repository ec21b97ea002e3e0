#include "services/slicing/algo/placement/footprint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/text_format.h"

namespace slicefarm::slicing {
namespace {

Polygon HullOf(const IndexedMesh& mesh) {
  const IndexedMesh* const meshes[] = {&mesh};
  return Footprint(meshes);
}

using testing::ElementsAre;

Point At(double x_mm, double y_mm) { return {FromMm(x_mm), FromMm(y_mm)}; }

const Polygon kSquare = MakePolygonsOrDie("(-5 -5, 5 -5, 5 5, -5 5)")[0].outer;
const Polygon kDiamond = MakePolygonsOrDie("(-5 0, 0 -5, 5 0, 0 5)")[0].outer;

TEST(CountOverlapping, CountsCopiesThatStandOnOthers) {
  const std::vector<Point> row = {At(0, 0), At(20, 0), At(29, 9), At(60, 0)};
  EXPECT_THAT(CountOverlapping(std::vector<Copies>{{&kSquare, row}}), ElementsAre(2));
}

TEST(CountOverlapping, TouchingIsNotOverlapping) {
  const std::vector<Point> grid = {At(0, 0), At(10, 0), At(0, 10), At(10, 10)};
  EXPECT_THAT(CountOverlapping(std::vector<Copies>{{&kSquare, grid}}), ElementsAre(0));
}

TEST(CountOverlapping, LooksAtHullsAndNotAtBoxes) {
  const std::vector<Point> corner = {At(0, 0), At(6, 6)};
  EXPECT_THAT(CountOverlapping(std::vector<Copies>{{&kDiamond, corner}}), ElementsAre(0));
  EXPECT_THAT(CountOverlapping(std::vector<Copies>{{&kSquare, corner}}), ElementsAre(2));
}

TEST(CountOverlapping, CountsForEachPart) {
  const std::vector<Point> squares = {At(0, 0), At(50, 0)}, diamonds = {At(3, 0), At(3, 1)};
  const Polygon line = {At(0, 0), At(9, 0)};
  EXPECT_THAT(CountOverlapping(std::vector<Copies>{
                  {&kSquare, squares}, {&line, squares}, {&kDiamond, diamonds}}),
              ElementsAre(1, 0, 2));
}

}  // namespace
}  // namespace slicefarm::slicing
