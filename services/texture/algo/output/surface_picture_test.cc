#include "services/texture/algo/output/surface_picture.h"

#include <gtest/gtest.h>

#include "common/picture/picture_test.h"

namespace slicefarm::texture::surface_picture_test {
namespace {

SurfaceMesh Square() {
  SurfaceMesh mesh;
  mesh.points_mm = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(DrawSurface, ShowsLinesOnTheNearSideOnly) {
  const Eigen::Vector3d up(0, 0, 1);
  const std::vector<PictureLine> lines = {{{2, 5, 0}, {8, 5, 0}, up, 1},
                                          {{2, 2, 0}, {8, 2, 0}, -up, 1}};
  const auto png = DrawSurface(Square(), lines, {.size_px = 240, .towards_viewer = up});
  ASSERT_TRUE(png.ok()) << png.status();
  const Picture picture(*png);
  EXPECT_EQ(picture.width(), 240);
  // The scale is 20 px per mm, with y upwards.
  const Colour line = picture.At(120, 120), hidden = picture.At(120, 180);
  EXPECT_NE(line.red, line.blue) << "in colour";
  EXPECT_EQ(hidden.red, hidden.blue) << "grey";
  EXPECT_EQ(picture.At(5, 5).red, 1) << "white around";
}

TEST(DrawMap, ColoursTrianglesByTheirValues) {
  const std::vector<Eigen::Vector2d> map = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const double values[] = {1, 3};
  const auto png = DrawMap(Square(), map, values, 3, 240);
  ASSERT_TRUE(png.ok()) << png.status();
  const Picture picture(*png);
  const Colour dark = picture.At(180, 160), light = picture.At(60, 80);
  EXPECT_LT(dark.green + 0.3, light.green);
}

}  // namespace
}  // namespace slicefarm::texture::surface_picture_test
