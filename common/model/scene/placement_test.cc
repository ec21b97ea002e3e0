#include "common/model/scene/placement.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::placement_test {
namespace {

TEST(CheckPlacement, RefusesSenselessFactors) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Placement> cases = {
      {.unit_mm = 0},
      {.unit_mm = nan},
      {.scale = {1, -1, 1}},
      {.scale = {1, 1, 0}},
      {.rotate_deg = {0, nan, 0}},
      {.rotate_deg = {0, 0, std::numeric_limits<double>::infinity()}}};
  for (const Placement& placement : cases)
    EXPECT_EQ(DetailOf(CheckPlacement(placement)).reason, Reason::kSettingOutOfRange);
  EXPECT_TRUE(CheckPlacement({}).ok());
}

struct PlacementCase {
  const char* name;
  Placement placement;
  Eigen::Vector3d want;  ///< expected image of (10, 20, 30)
};

TEST(TransformOf, UnitsThenScaleThenTurn) {
  const std::vector<PlacementCase> cases = {
      {"AsIs", {}, {10, 20, 30}},
      {"Inches", {.unit_mm = 25.4}, {254, 508, 762}},
      {"Scale", {.scale = {1, 2, 0.5}}, {10, 40, 15}},
      {"AboutX", {.rotate_deg = {90, 0, 0}}, {10, -30, 20}},
      {"AboutY", {.rotate_deg = {0, -90, 0}}, {-30, 20, 10}},
      {"AboutZ", {.rotate_deg = {0, 0, 270}}, {20, -10, 30}},
      {"ScaleThenTurn", {.scale = {2, 1, 1}, .rotate_deg = {0, 0, 90}}, {-20, 20, 30}},
  };
  for (const PlacementCase& c : cases) {
    const Transform transform = TransformOf(c.placement);
    const Eigen::Vector3d got = transform * Eigen::Vector4d(10, 20, 30, 1);
    EXPECT_TRUE(got.isApprox(c.want, 1e-14)) << c.name << ": " << got.transpose();
  }
}

TEST(Combined, IsTheSecondAfterTheFirst) {
  Transform turn = TransformOf({.rotate_deg = {0, 0, 90}});
  Transform move = Transform::Identity();
  move.col(3) = Eigen::Vector3d(1, 2, 3);
  const Eigen::Vector4d x(1, 0, 0, 1);
  EXPECT_EQ((Combined(turn, move) * x).eval(), Eigen::Vector3d(-2, 2, 3));
  EXPECT_EQ((Combined(move, turn) * x).eval(), Eigen::Vector3d(1, 3, 3));
}

}  // namespace
}  // namespace slicefarm::placement_test
