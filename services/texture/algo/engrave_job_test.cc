#include "services/texture/algo/engrave_job.h"

#include <gtest/gtest.h>

#include <utility>

#include "common/base/error.h"

namespace slicefarm::texture::engrave_job_test {
namespace {

EngraveInput OnASquare() {
  EngraveInput input;
  input.surface = {{{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, {{0, 1, 2}, {0, 2, 3}}},
                   {0, 1, 2, 3},
                   {{0, 0}, {9, 0}, {9, 9}, {0, 9}}};
  return input;
}

TEST(PrepareEngraving, TakesTheSettings) {
  EngraveInput input = OnASquare();
  input.settings.texture.anchor = "1,2,3";
  input.settings.lines.spacing = "0.1,0.2";
  input.settings.lines.angle = "0,45,90";
  input.settings.machine.centre = "4,5,6";
  const auto job = PrepareEngraving(input);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->plan.options.placement.anchor_mm, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(job->plan.options.lines, (std::vector<LineStyle>{{0.1, 0}, {0.2, 45}, {0.1, 90}}));
  EXPECT_EQ(job->program.axes.centre_mm, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(job->program.layer_mm, 0.05);
}

TEST(PrepareEngraving, RefusesMapsWithFlips) {
  EngraveInput input = OnASquare();
  std::swap(input.surface.map_mm[0], input.surface.map_mm[2]);
  EXPECT_EQ(DetailOf(PrepareEngraving(input).status()).reason, Reason::kRequestMalformed);
  input = OnASquare();
  input.surface.mesh.triangles.pop_back();
  input.surface.mesh.triangles.push_back({0, 1, 2});
  EXPECT_EQ(DetailOf(PrepareEngraving(input).status()).reason, Reason::kMeshMalformed);
}

TEST(PrepareEngraving, AnObjectIsTheTexture) {
  EngraveInput input = OnASquare();
  input.solid = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}},
                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  input.settings.texture.pitch = "3,4";
  const auto job = PrepareEngraving(input);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->plan.texture.tile_mm, Eigen::Vector2d(3, 4));
  input.settings.texture.pitch = "3";
  EXPECT_EQ(DetailOf(PrepareEngraving(input).status()).metadata["setting"], "texture_pitch");
}

}  // namespace
}  // namespace slicefarm::texture::engrave_job_test
