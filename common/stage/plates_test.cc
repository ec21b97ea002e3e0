#include "common/stage/plates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::plates_test {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

SceneObject Copies(const std::string& name, int count) { return ObjectOfFile(name, 0, {}, count); }

/// Returns an object with a copy at a fixed position.
SceneObject Standing(const std::string& name, double x, double y) {
  SceneObject object = Copies(name, 1);
  object.instances[0].placed = true;
  object.instances[0].by_middle = false;
  object.instances[0].to_plate(0, 3) = x;
  object.instances[0].to_plate(1, 3) = y;
  return object;
}

TEST(ObjectsToArrange, CopiesThatAreTurnedAlikeAreOfOneObject) {
  SceneObject object = Copies("a", 4);
  object.instances[1].to_plate(2, 2) = 2;
  object.instances[2].printable = false;
  object.parts[0].to_object(0, 3) = 5;
  const SceneObject scene[] = {object, Standing("b", 30, 40)};
  const std::vector<ObjectInput> inputs = ObjectsToArrange(scene);
  ASSERT_THAT(inputs, SizeIs(3));
  EXPECT_THAT(inputs[0].copies, SizeIs(2));
  EXPECT_THAT(inputs[1].copies, SizeIs(1));
  EXPECT_EQ(inputs[1].to_plate(2, 2), 2);
  EXPECT_EQ(inputs[1].parts[0].to_object(0, 3), 5);
  EXPECT_EQ(inputs[2].name, "b");
  EXPECT_EQ(inputs[2].to_plate, Transform(Transform::Identity()));
  EXPECT_THAT(inputs[2].copies,
              ElementsAre(CopyInput{CopyInput::Place::kOriginAt, {FromMm(30), FromMm(40)}}));
}

TEST(OnPlates, ACopyIsTurnedWithoutLosingADigit) {
  SceneObject object = Copies("a", 1);
  object.instances[0].to_plate(0, 0) = 2;
  const SceneObject scene[] = {object};
  const std::vector<PlatePosition> positions = {{0, {FromMm(10), FromMm(20)}, true}};
  const Transform turned = OnPlates(scene, positions).at(0).at(0).instances.at(0).to_plate;
  EXPECT_EQ(turned(0, 0), 0);
  EXPECT_EQ(turned(0, 1), -1);
  EXPECT_EQ(turned(1, 0), 2);
  EXPECT_EQ(turned(1, 1), 0);
  EXPECT_EQ(turned(0, 3), 10);
  EXPECT_EQ(turned(1, 3), 20);
}

TEST(OnPlates, EachCopyIsOnItsPlateAtItsPlace) {
  const SceneObject scene[] = {Copies("a", 3), Standing("b", 30, 40), Copies("c", 1)};
  const std::vector<PlatePosition> positions = {
      {0, {FromMm(10), 0}}, {2, {FromMm(20), 0}}, {0, {FromMm(50), 0}}, {0, {}}, {2, {0, 7}}};
  const auto plates = OnPlates(scene, positions);
  ASSERT_THAT(plates, SizeIs(2)) << "plate 1 has nothing";
  ASSERT_THAT(plates[0], SizeIs(2));
  EXPECT_EQ(plates[0][0].name, "a");
  ASSERT_THAT(plates[0][0].instances, SizeIs(2));
  EXPECT_EQ(plates[0][0].instances[1].to_plate(0, 3), 50);
  EXPECT_TRUE(plates[0][0].instances[1].placed && plates[0][0].instances[1].by_middle);
  EXPECT_EQ(plates[0][1], scene[1]) << "what has a place keeps it";
  ASSERT_THAT(plates[1], SizeIs(2));
  EXPECT_EQ(plates[1][0].instances[0].to_plate(0, 3), 20);
  EXPECT_EQ(plates[1][1].name, "c");
  EXPECT_EQ(plates[1][1].instances[0].to_plate(1, 3), 7e-6);
}

// The n-th copy of ObjectsToArrange has the n-th position, for any orientation of the copies.
TEST(OnPlates, PositionsFollowTheCopiesOfObjectsToArrange) {
  SceneObject object = Copies("a", 4);
  for (size_t i = 0; i < 4; ++i)
    object.instances[i].to_plate(2, 2) = 1 + static_cast<double>(i % 2);
  std::vector<PlatePosition> positions;
  for (const ObjectInput& input : ObjectsToArrange({&object, 1}))
    for (size_t i = 0; i < input.copies.size(); ++i)
      positions.push_back({static_cast<int32_t>(input.to_plate(2, 2)), {}});
  const auto plates = OnPlates({&object, 1}, positions);
  ASSERT_THAT(plates, SizeIs(2));
  for (size_t plate = 0; plate < 2; ++plate)
    for (const Instance& copy : plates[plate][0].instances)
      EXPECT_EQ(copy.to_plate(2, 2), 1 + static_cast<double>(plate));
}

}  // namespace
}  // namespace slicefarm::plates_test
