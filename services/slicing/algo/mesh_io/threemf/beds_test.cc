#include "services/slicing/algo/mesh_io/threemf/beds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::slicing::threemf::beds_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Scene with `count` beds and one object that has a copy at each of the places.
struct Scene {
  Project project;
  std::vector<PlateSettings> beds;

  Scene(size_t count, std::vector<std::array<double, 2>> places,
        const std::string& bed = "0x0,200x0,200x150,0x150") {
    project.settings = {{"bed_shape", bed}};
    SceneObject& object = project.objects.emplace_back();
    object.name = "thing";
    for (const auto& [x, y] : places) {
      Instance& instance = object.instances.emplace_back();
      instance.to_plate(0, 3) = x;
      instance.to_plate(1, 3) = y;
    }
    for (size_t i = 0; i < count; ++i) beds.emplace_back().settings = {{"key", std::to_string(i)}};
  }

  std::vector<std::string> Add() {
    Notes notes;
    AddBeds(beds, project, notes);
    return notes.Lines();
  }

  /// Returns the plate of each copy, from 0; -1: none.
  std::vector<int> PlatesOfCopies() const {
    std::vector<int> plates(project.objects[0].instances.size(), -1);
    for (size_t i = 0; i < project.plates.size(); ++i)
      for (const ProjectPlate::Member& member : project.plates[i].members)
        plates[member.instance] = static_cast<int>(i);
    return plates;
  }
};

// A bed of 200 x 150 has a diagonal of 250, so the beds are 75 apart. The positions are from
// PrusaSlicer 2.9.4 (BedsGrid).
TEST(AddBeds, FillGrowingSquares) {
  std::vector<std::array<double, 2>> places;
  constexpr int kColumns[] = {0, 1, 0, 1, 2, 2, 0, 1, 2};
  constexpr int kRows[] = {0, 0, 1, 1, 0, 1, 2, 2, 2};
  for (int i = 0; i < 9; ++i) places.push_back({80 + 275.0 * kColumns[i], 60 + 225.0 * kRows[i]});
  Scene scene(9, places);
  EXPECT_THAT(scene.Add(), IsEmpty());
  EXPECT_THAT(scene.PlatesOfCopies(), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
  for (const Instance& instance : scene.project.objects[0].instances) {
    EXPECT_NEAR(instance.to_plate(0, 3), 80, 1e-9);
    EXPECT_NEAR(instance.to_plate(1, 3), 60, 1e-9);
  }
  EXPECT_EQ(scene.project.plates[3].settings[0].value, "3");
}

TEST(AddBeds, LargeOnesAreAHundredMillimetresApart) {
  Scene scene(2, {{200, 150}, {600, 150}}, "-200x0,400x0,400x300,-200x300,-200x0");
  EXPECT_THAT(scene.Add(), IsEmpty());
  EXPECT_THAT(scene.PlatesOfCopies(), ElementsAre(0, 1));
  EXPECT_NEAR(scene.project.objects[0].instances[1].to_plate(0, 3), -100, 1e-9);
}

/// An object parked beside a bed stays there; it is reported when its position relative to the bed
/// is known.
TEST(AddBeds, NoteWhatIsBesideAll) {
  Scene scene(2, {{-20, 60}, {220, 60}, {-60, 60}, {80, 400}, {900, 60}, {NAN, 60}, {1e300, 0}});
  EXPECT_THAT(scene.Add(), ElementsAre("copies beside all beds of `thing`, `thing`, `thing`, "
                                       "`thing`, `thing`"));
  EXPECT_THAT(scene.PlatesOfCopies(), ElementsAre(0, 0, -1, -1, -1, -1, -1));
}

TEST(AddBeds, OneBedIsNoPlate) {
  for (const auto& [count, bed] :
       {std::pair{1, "0x0,200x0,200x150,0x150"}, {0, "0x0,200x0,200x150,0x150"}, {3, "0x0,0x9"}}) {
    Scene scene(count, {{80, 60}, {355, 60}}, bed);
    EXPECT_THAT(scene.Add(), IsEmpty());
    EXPECT_THAT(scene.project.plates, IsEmpty());
    EXPECT_EQ(scene.project.objects[0].instances[1].to_plate(0, 3), 355);
  }
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::beds_test
