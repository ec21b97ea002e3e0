#include "services/texture/algo/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/picture/picture_test.h"
#include "services/texture/algo/output/displaced_mesh.h"
#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::whole_file_test {
namespace {

/// Returns a job on a flat square of 8 mm: the map has no distortion, and the picture shows it from
/// above.
EngraveJob JobOn(EngraveFormat format) {
  SurfaceMesh square;
  square.points_mm = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto spec = ParseTextureSpec("bumps:height=0.3,pitch=2");
  auto plan =
      PlanEngraving(FlatMapOf(square), *TextureOf(*ComputedHeights(*spec)), std::nullopt, {});
  return {.plan = *std::move(plan), .program = {}, .format = format, .displaced_edge_mm = 0.5};
}

TEST(WholeFile, MeshesAreThoseOfTheDisplacedSurface) {
  const EngraveJob stl = JobOn(EngraveFormat::kStl), obj = JobOn(EngraveFormat::kObj);
  const auto mesh = DisplacedMesh(stl.plan, {0.5});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  ASSERT_GT(mesh->triangles.size(), 500u);
  EXPECT_EQ(WholeFile(stl).value(), StlBytes(*mesh));
  EXPECT_EQ(WholeFile(obj).value(), ObjText(*mesh));
}

TEST(WholeFile, ShowsLinesInColour) {
  const auto png = WholeFile(JobOn(EngraveFormat::kPng));
  ASSERT_TRUE(png.ok()) << png.status();
  const Picture picture(*png);
  int coloured = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Colour colour = picture.At(x, y);
      coloured += colour.red != colour.blue;
    }
  }
  EXPECT_GT(coloured, picture.width() * picture.height() / 10);
}

/// Without distortion, the whole map has the colour of the dark end of the scale.
TEST(WholeFile, ShowsTheMapsDistortion) {
  const auto png = WholeFile(JobOn(EngraveFormat::kMapPng));
  ASSERT_TRUE(png.ok()) << png.status();
  const Picture picture(*png);
  const Colour middle = picture.At(picture.width() / 2, picture.height() / 2);
  EXPECT_NEAR(middle.red, ScaleColour(0).red, 0.01);
  EXPECT_NEAR(middle.green, ScaleColour(0).green, 0.01);
  EXPECT_EQ(picture.At(3, 3).green, 1) << "white around";
}

TEST(WholeFile, CanBeCancelled) {
  const CancelToken cancelled([] { return true; });
  EXPECT_EQ(WholeFile(JobOn(EngraveFormat::kPng), cancelled).status().code(),
            absl::StatusCode::kCancelled);
}

TEST(WholeFile, RefusesTooManyTriangles) {
  EngraveJob job = JobOn(EngraveFormat::kStl);
  job.displaced_edge_mm = 1e-5;
  EXPECT_EQ(DetailOf(WholeFile(job).status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::texture::whole_file_test
