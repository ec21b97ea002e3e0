#include "services/slicing/algo/mesh_io/threemf/plates.h"

#include <gtest/gtest.h>

namespace slicefarm::slicing::threemf::plates_test {
namespace {

constexpr char kArea[] = R"(["0x0","250x0","250x210","0x210"])";

/// Scene with `count` plates that each have a copy of object 7. All copies are in the middle of the
/// first plate, apart from the distance between the plates.
struct Scene {
  Project project;
  std::vector<PlateSettings> plates;
  ItemsOfObject items;

  Scene(int32_t count, int columns) {
    project.settings = {{"printable_area", kArea}};
    SceneObject& object = project.objects.emplace_back();
    object.name = "thing";
    for (int32_t i = 0; i < count; ++i) {
      Instance& instance = object.instances.emplace_back();
      instance.to_plate(0, 3) = 125 + 300.0 * (i % columns);
      instance.to_plate(1, 3) = 105 - 252.0 * (i / columns);
      items[7].push_back({0, i});
      PlateSettings& plate = plates.emplace_back();
      plate.number = i + 1;
      plate.name = "plate " + std::to_string(i + 1);
      plate.members.push_back({7, i});
    }
  }

  std::vector<std::string> Add() {
    Notes notes;
    AddPlates(plates, items, project, notes);
    return notes.Lines();
  }

  const Instance& At(size_t i) const { return project.objects[0].instances[i]; }
};

TEST(AddPlates, TakesOffWhatIsBetweenThem) {
  struct Case {
    int32_t count;
    int columns;
  };
  for (const Case& c : std::initializer_list<Case>{{1, 1}, {2, 2}, {4, 2}, {5, 3}, {10, 4}}) {
    Scene scene(c.count, c.columns);
    EXPECT_TRUE(scene.Add().empty());
    ASSERT_EQ(scene.project.plates.size(), static_cast<size_t>(c.count));
    for (int32_t i = 0; i < c.count; ++i) {
      EXPECT_NEAR(scene.At(i).to_plate(0, 3), 125, 1e-9) << c.count << " " << i;
      EXPECT_NEAR(scene.At(i).to_plate(1, 3), 105, 1e-9) << c.count << " " << i;
      EXPECT_EQ(scene.project.plates[i].members.size(), 1u);
    }
  }
}

TEST(AddPlates, GoesByTheirNumbers) {
  Scene scene(3, 2);
  std::swap(scene.plates[0], scene.plates[2]);
  scene.Add();
  EXPECT_EQ(scene.project.plates[0].name, "plate 1");
  EXPECT_NEAR(scene.At(2).to_plate(1, 3), 105, 1e-9);
  Scene odd(2, 2);
  odd.plates[1].number = 7;
  odd.Add();
  EXPECT_EQ(odd.project.plates[1].name, "plate 2");
}

TEST(AddPlates, HasNoPlacesWithoutABed) {
  for (const std::string area : {"", "[]", "0x0,0x0", "nanx0,1x1", "1e9x0,0x1e9"}) {
    Scene scene(2, 2);
    scene.project.settings[0].value = area;
    scene.Add();
    EXPECT_TRUE(scene.At(0).placed);
    EXPECT_FALSE(scene.At(1).placed) << area;
  }
}

TEST(AddPlates, NotesWhatDoesNotFit) {
  Scene scene(2, 2);
  scene.plates[0].members.push_back({7, 0});
  scene.plates[0].members.push_back({8, 0});
  scene.plates[0].members.push_back({7, 1'000'000'000});
  scene.plates[1].members.clear();
  const std::vector<std::string> notes = scene.Add();
  EXPECT_EQ(notes,
            (std::vector<std::string>{"entries of plates that are missing or on another plate",
                                      "copies beside all plates of `thing`"}));
  EXPECT_EQ(scene.project.plates[0].members.size(), 1u);
}

TEST(AddPlates, NoneAreNone) {
  Scene scene(1, 1);
  scene.plates.clear();
  EXPECT_TRUE(scene.Add().empty());
  EXPECT_TRUE(scene.project.plates.empty());
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::plates_test
