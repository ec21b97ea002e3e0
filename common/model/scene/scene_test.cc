#include "common/model/scene/scene.h"

#include <gtest/gtest.h>

namespace slicefarm::scene_test {
namespace {

TEST(ObjectOfFile, ACopyAtEachCenter) {
  Placement placement;
  placement.scale = {2, 2, 2};
  placement.centers = {{FromMm(10), FromMm(20)}, {FromMm(30), FromMm(40)}};
  const SceneObject object = ObjectOfFile("a", 3, placement, 0);
  ASSERT_EQ(object.parts.size(), 1u);
  EXPECT_EQ(object.parts[0].mesh.file, 3);
  ASSERT_EQ(object.instances.size(), 2u);
  EXPECT_TRUE(object.instances[1].placed && object.instances[1].by_middle);
  EXPECT_EQ(object.instances[1].to_plate(0, 3), 30);
  EXPECT_EQ(object.instances[1].to_plate(1, 3), 40);
  EXPECT_EQ(object.instances[1].to_plate(2, 2), 2);
}

TEST(ObjectOfFile, SoManyCopiesAnywhere) {
  EXPECT_EQ(ObjectOfFile("a", 0, {}, 0).instances.size(), 1u);
  const SceneObject object = ObjectOfFile("a", 0, {}, 7);
  EXPECT_EQ(object.instances.size(), 7u);
  EXPECT_FALSE(object.instances[6].placed);
}

}  // namespace
}  // namespace slicefarm::scene_test
