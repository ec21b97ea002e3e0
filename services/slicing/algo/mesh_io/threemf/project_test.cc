#include "services/slicing/algo/mesh_io/threemf/project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::project_test {
namespace {

/// Returns objects 1 to n, each with a mesh of 12 triangles and built once.
Package PackageOf(int32_t count) {
  Package package;
  ModelFile& file = package.files.emplace_back();
  file.part = "m.model";
  file.application = "CAD";
  for (int32_t i = 0; i < count; ++i) {
    ObjectResource object;
    object.id = static_cast<ResourceId>(i + 1);
    object.mesh = i;
    object.triangles = 12;
    file.by_id[object.id] = file.objects.size();
    file.objects.push_back(object);
    BuildItem item;
    item.path = file.part;
    item.object = object.id;
    item.line = i + 10;
    file.items.push_back(item);
  }
  return package;
}

TEST(MakeProject, NamesAndOrdersObjects) {
  Package package = PackageOf(2);
  std::swap(package.files[0].items[0], package.files[0].items[1]);
  package.files[0].items.push_back(package.files[0].items[0]);
  package.files[0].objects[0].name = "Gear";
  const auto project = MakeProject(package, {});
  ASSERT_TRUE(project.ok()) << project.status();
  EXPECT_EQ(project->application, "CAD");
  ASSERT_EQ(project->objects.size(), 2u);
  EXPECT_EQ(project->objects[0].name, "object 2");
  EXPECT_EQ(project->objects[0].instances.size(), 2u);
  EXPECT_EQ(project->objects[0].parts[0].mesh.mesh, 1);
  EXPECT_EQ(project->objects[1].name, "Gear");
  EXPECT_FALSE(project->objects[1].instances[0].placed) << "no printer, no place";
}

TEST(MakeProject, SaysThatPlacesAreNotKept) {
  Package package = PackageOf(2);
  EXPECT_TRUE(MakeProject(package, {})->without_effect.empty());
  package.files[0].items[1].transform(0, 3) = 30;
  EXPECT_THAT(MakeProject(package, {})->without_effect,
              testing::ElementsAre(testing::StartsWith("positions on the bed")));
  Metadata metadata;
  metadata.has_printer = true;
  EXPECT_TRUE(MakeProject(package, metadata)->without_effect.empty());
  EXPECT_TRUE(MakeProject(PackageOf(1), {})->without_effect.empty());
}

/// The first projects of Bambu Studio have each object in a separate file, with numbers that are
/// unique over all files.
TEST(MakeProject, ObjectsOfOtherFilesHaveSettingsAndPlates) {
  Package package = PackageOf(1);
  ModelFile& other = package.files.emplace_back();
  std::swap(other.objects, package.files[0].objects);
  std::swap(other.by_id, package.files[0].by_id);
  other.part = package.files[0].items[0].path = "other.model";
  Metadata metadata;
  ObjectSettings& lid = metadata.model.objects.emplace_back();
  lid.object = 1;
  lid.name = "Lid";
  lid.settings.push_back({"wall_loops", "5"});
  PlateSettings& plate = metadata.model.plates.emplace_back();
  plate.number = 1;
  plate.members.push_back({1, 0});
  auto project = MakeProject(package, metadata);
  ASSERT_TRUE(project.ok()) << project.status();
  EXPECT_EQ(project->objects[0].name, "Lid");
  ASSERT_EQ(project->objects[0].settings.size(), 1u);
  EXPECT_EQ(project->objects[0].settings[0].value, "5");
  ASSERT_EQ(project->plates.size(), 1u);
  EXPECT_EQ(project->plates[0].members.size(), 1u);

  // A number that the first file uses too means the object of the first file.
  package.files[0].by_id[1] = 0;
  package.files[0].objects.push_back(package.files[1].objects[0]);
  project = MakeProject(package, metadata);
  ASSERT_TRUE(project.ok()) << project.status();
  EXPECT_EQ(project->objects[0].name, "object 1");
}

TEST(MakeProject, BedsArePlates) {
  Package package = PackageOf(2);
  package.files[0].items[1].transform(0, 3) = 500;
  Metadata metadata;
  metadata.has_printer = true;
  metadata.project.settings.push_back({"bed_shape", "0x0,300x0,300x400,0x400"});
  metadata.beds.resize(2);
  const auto project = MakeProject(package, metadata);
  ASSERT_TRUE(project.ok()) << project.status();
  ASSERT_EQ(project->plates.size(), 2u);
  for (const ProjectPlate& plate : project->plates) EXPECT_EQ(plate.members.size(), 1u);
  EXPECT_NEAR(project->objects[1].instances[0].to_plate(0, 3), 100, 1e-9);
}

TEST(MakeProject, NotesWhatIsNoModel) {
  Package package = PackageOf(2);
  package.files[0].objects[1].type = "support";
  Metadata metadata;
  metadata.project.has_scripts = true;
  const auto project = MakeProject(package, metadata);
  ASSERT_TRUE(project.ok()) << project.status();
  EXPECT_EQ(project->objects.size(), 1u);
  EXPECT_THAT(project->without_effect,
              testing::ElementsAre("scripts (post_process), which are never run",
                                   "objects of type `support` of `object 2`"));
}

TEST(MakeProject, SaysWhatIsWrong) {
  EXPECT_EQ(DetailOf(MakeProject(PackageOf(0), {}).status()).reason, Reason::kMeshEmpty);
  Package empty = PackageOf(1);
  empty.files[0].objects[0].triangles = 0;
  const auto nothing = MakeProject(empty, {});
  EXPECT_EQ(DetailOf(nothing.status()).reason, Reason::kMeshEmpty);
  EXPECT_EQ(DetailOf(nothing.status()).metadata["line"], "10");
  Package lost = PackageOf(1);
  lost.files[0].items[0].object = 1'000'000'000;
  EXPECT_EQ(DetailOf(MakeProject(lost, {}).status()).reason, Reason::kMeshMalformed);
  Package large = PackageOf(2);
  large.files[0].objects[0].triangles = large.files[0].objects[1].triangles = 15'000'000;
  EXPECT_EQ(DetailOf(MakeProject(large, {}).status()).reason, Reason::kMeshTooLarge);
}

TEST(MakeProject, BoundsTheText) {
  Metadata metadata;
  for (int i = 0; i < 300; ++i)
    metadata.project.settings.push_back({"k", std::string(60'000, 'x'), Source::kProfile});
  const auto project = MakeProject(PackageOf(1), metadata);
  EXPECT_EQ(DetailOf(project.status()).reason, Reason::kMeshTooLarge) << project.status();
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::project_test
