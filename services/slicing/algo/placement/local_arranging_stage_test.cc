#include "services/slicing/algo/placement/local_arranging_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::local_arranging_stage_test {
namespace {

using testing::HasSubstr;

SlicingOptions SmallBed() {
  SlicingOptions options;
  options.bed = {
      {0, 0}, {100 * kNmPerMm, 0}, {100 * kNmPerMm, 100 * kNmPerMm}, {0, 100 * kNmPerMm}};
  return options;
}

/// Returns files with one box each, with these side lengths.
std::vector<MeshFile> Boxes(const std::vector<double>& sides) {
  std::vector<MeshFile> files;
  for (const double side : sides)
    files.push_back({"box", MeshFormat::kStl, ToBinaryStl(BoxMesh({0, 0, 0}, {side, side, 10}))});
  return files;
}

SceneObject Copies(const std::string& name, int32_t file, int count) {
  return ObjectOfFile(name, file, {}, count);
}

absl::StatusOr<std::vector<std::vector<SceneObject>>> Put(const std::vector<double>& sides,
                                                          const std::vector<SceneObject>& objects) {
  const auto places =
      MakeLocalArranging()->PutOnPlates({}, {Boxes(sides), ObjectsToArrange(objects)}, SmallBed());
  if (!places.ok()) return places.status();
  return OnPlates(objects, *places);
}

TEST(LocalArranging, TakesAsManyPlatesAsNeededAndLosesNothing) {
  const auto plates = Put({40, 30}, {Copies("a", 0, 7), Copies("b", 1, 2)});
  ASSERT_TRUE(plates.ok()) << plates.status();
  EXPECT_GE(plates->size(), 2u);
  size_t copies = 0;
  for (const auto& plate : *plates) {
    EXPECT_FALSE(plate.empty());
    for (const SceneObject& object : plate) {
      EXPECT_FALSE(object.instances.empty());
      copies += object.instances.size();
      for (const Instance& instance : object.instances) {
        EXPECT_TRUE(instance.placed && instance.by_middle);
        EXPECT_GE(instance.to_plate(0, 3), 15);
        EXPECT_LE(instance.to_plate(0, 3), 85);
      }
    }
  }
  EXPECT_EQ(copies, 9u);
}

TEST(LocalArranging, OnePlateIsEnoughForFew) {
  const auto plates = Put({40}, {Copies("a", 0, 4)});
  ASSERT_TRUE(plates.ok()) << plates.status();
  ASSERT_EQ(plates->size(), 1u);
  EXPECT_EQ(plates->at(0)[0].instances.size(), 4u);
}

// Three copies fit beside each other, and a fourth one only if it is turned.
TEST(LocalArranging, TurnsCopiesWhereThatSavesAPlate) {
  SlicingOptions options;
  options.bed = {
      {0, 0}, {250 * kNmPerMm, 0}, {250 * kNmPerMm, 210 * kNmPerMm}, {0, 210 * kNmPerMm}};
  const std::vector<MeshFile> files = {
      {"bar", MeshFormat::kStl, ToBinaryStl(BoxMesh({0, 0, 0}, {130, 50, 10}))}};
  const auto plates_of = [&](int copies) {
    const std::vector<SceneObject> objects = {Copies("bar", 0, copies)};
    const auto places =
        MakeLocalArranging()->PutOnPlates({}, {files, ObjectsToArrange(objects)}, options);
    EXPECT_TRUE(places.ok()) << places.status();
    return OnPlates(objects, *places);
  };
  EXPECT_EQ(plates_of(12).size(), 3u);
  // Copies that fit without rotation are not turned.
  const auto plates = plates_of(3);
  ASSERT_FALSE(plates.empty());
  ASSERT_EQ(plates[0].at(0).instances.size(), 3u);
  for (const Instance& copy : plates[0][0].instances) EXPECT_EQ(copy.to_plate(0, 0), 1);
}

TEST(LocalArranging, WhatHasAPlaceKeepsIt) {
  SceneObject standing = Copies("a", 0, 1);
  standing.instances[0].placed = true;
  standing.instances[0].to_plate(0, 3) = standing.instances[0].to_plate(1, 3) = 50;
  const auto plates = Put({90}, {Copies("b", 0, 1), standing});
  ASSERT_TRUE(plates.ok()) << plates.status();
  ASSERT_EQ(plates->size(), 2u);
  EXPECT_EQ(plates->at(0).at(0), standing);
  EXPECT_EQ(plates->at(1).at(0).name, "b");
}

TEST(LocalArranging, NamesWhatIsTooLarge) {
  const absl::Status status = Put({40, 120}, {Copies("a", 0, 1), Copies("slab", 1, 2)}).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfBuildVolume);
  EXPECT_THAT(std::string(status.message()), HasSubstr("\"slab\""));
}

TEST(LocalArranging, IsCancelled) {
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  const std::vector<SceneObject> objects = {Copies("a", 0, 7)};
  EXPECT_TRUE(absl::IsCancelled(
      MakeLocalArranging()
          ->PutOnPlates(call, {Boxes({40}), ObjectsToArrange(objects)}, SmallBed())
          .status()));
}

TEST(LocalArranging, ErrorsOfFilesArePassedOn) {
  EXPECT_EQ(DetailOf(Put({}, {Copies("a", 0, 1)}).status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::slicing::local_arranging_stage_test
