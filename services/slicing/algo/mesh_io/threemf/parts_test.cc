#include "services/slicing/algo/mesh_io/threemf/parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/mesh_collector.h"

namespace slicefarm::slicing::threemf::parts_test {
namespace {

Package MeshOf24() {
  Package package;
  ModelFile& file = package.files.emplace_back();
  ObjectResource object;
  object.id = 5;
  object.name = "own";
  object.mesh = 0;
  object.triangles = 24;
  file.by_id[5] = 0;
  file.objects.push_back(object);
  return package;
}

ModelSettings Volumes(const std::vector<std::pair<int64_t, int64_t>>& ranges) {
  ModelSettings settings;
  settings.part = "config";
  ObjectSettings& object = settings.objects.emplace_back();
  object.object = 5;
  for (const auto& [first, last] : ranges) {
    PartSettings& part = object.parts.emplace_back();
    part.name = "v" + std::to_string(first);
    part.first_triangle = first;
    part.last_triangle = last;
    part.line = 9;
  }
  return settings;
}

absl::StatusOr<std::vector<Part>> Parts(const Package& package, const ModelSettings& settings,
                                        Notes& notes) {
  const auto tree = ComponentTree::Make(package);
  return PartsOf({package, *tree, settings}, {0, 0}, "thing", notes);
}

TEST(PartsOf, AreAllOfTheMeshWithoutVolumes) {
  Notes notes;
  const auto parts = Parts(MeshOf24(), {}, notes);
  ASSERT_TRUE(parts.ok()) << parts.status();
  ASSERT_EQ(parts->size(), 1u);
  EXPECT_EQ((*parts)[0].name, "own");
  EXPECT_EQ((*parts)[0].mesh, MeshRef());
}

TEST(PartsOf, AreVolumesInTheirOrder) {
  Notes notes;
  const auto parts = Parts(MeshOf24(), Volumes({{12, 20}, {0, 11}}), notes);
  ASSERT_TRUE(parts.ok()) << parts.status();
  ASSERT_EQ(parts->size(), 2u);
  EXPECT_EQ((*parts)[0].mesh.first_triangle, 12);
  EXPECT_EQ((*parts)[0].mesh.triangle_count, 9);
  EXPECT_EQ((*parts)[1].name, "v0");
  EXPECT_THAT(notes.Lines(), testing::ElementsAre("triangles of no part of `thing`"));
}

TEST(PartsOf, AreSeamsPaintedOnTheMesh) {
  Package package = MeshOf24();
  MarkPaint& seams = package.files[0].objects[0].marks.seams;
  seams.enforcers = {.triangles = 7, .mesh = {}, .number = 1};
  seams.blockers = {.triangles = 3, .mesh = {}, .number = 2};
  for (const ModelSettings& settings : {ModelSettings(), Volumes({{0, 11}, {12, 23}})}) {
    Notes notes;
    const auto parts = Parts(package, settings, notes);
    ASSERT_TRUE(parts.ok()) << parts.status();
    const size_t solid = settings.objects.empty() ? 1 : 2;
    ASSERT_EQ(parts->size(), solid + 2);
    EXPECT_EQ((*parts)[solid].role, PartRole::kSeamEnforcer);
    EXPECT_EQ((*parts)[solid].mesh, (MeshRef{0, 1, 0, 7}));
    EXPECT_EQ((*parts)[solid + 1].role, PartRole::kSeamBlocker);
    EXPECT_EQ((*parts)[solid + 1].mesh, (MeshRef{0, 2, 0, 3}));
    EXPECT_TRUE(notes.Lines().empty());
  }
}

TEST(PartsOf, MovesPaintAsItsMesh) {
  Package package = MeshOf24();
  ModelFile& file = package.files[0];
  file.objects[0].marks.seams.blockers = {.triangles = 3, .mesh = {}, .number = 1};
  ObjectResource twice;
  twice.id = 6;
  for (const double x : {10, 30}) {
    ObjectUse& use = twice.components.emplace_back();
    use.object = 5;
    use.transform(0, 3) = x;
  }
  file.by_id[6] = 1;
  file.objects.push_back(twice);
  Notes notes;
  const auto tree = ComponentTree::Make(package);
  const auto parts = PartsOf({package, *tree, {}}, {0, 1}, "thing", notes);
  ASSERT_TRUE(parts.ok()) << parts.status();
  ASSERT_EQ(parts->size(), 4u);
  for (const size_t i : {0, 2}) {
    EXPECT_EQ((*parts)[i + 1].role, PartRole::kSeamBlocker);
    EXPECT_EQ((*parts)[i + 1].to_object, (*parts)[i].to_object);
  }
}

/// A mesh that is used twice has two entries with one id: the second entry belongs to the second
/// use.
TEST(PartsOf, EachUseOfAMeshHasItsOwnSettings) {
  Package package = MeshOf24();
  ModelFile& file = package.files[0];
  ObjectResource twice;
  twice.id = 6;
  twice.components.resize(3);
  for (ObjectUse& use : twice.components) use.object = 5;
  file.by_id[6] = 1;
  file.objects.push_back(twice);
  ModelSettings settings;
  ObjectSettings& object = settings.objects.emplace_back();
  object.object = 6;
  object.parts.resize(2);
  object.parts[0] = {.name = "body", .component = 5, .settings = {{"extruder", "1"}}};
  object.parts[1] = {.name = "hole", .role = PartRole::kNegative, .component = 5, .settings = {}};
  Notes notes;
  const auto tree = ComponentTree::Make(package);
  const auto parts = PartsOf({package, *tree, settings}, {0, 1}, "thing", notes);
  ASSERT_TRUE(parts.ok()) << parts.status();
  ASSERT_EQ(parts->size(), 3u);
  EXPECT_EQ((*parts)[0].name, "body");
  EXPECT_EQ((*parts)[1].name, "hole");
  EXPECT_EQ((*parts)[1].role, PartRole::kNegative);
  EXPECT_TRUE((*parts)[1].settings.empty());
  EXPECT_EQ((*parts)[2].name, "body") << "without an entry of its own, the first of its id";
}

TEST(PartsOf, RefusesVolumesThatCannotBe) {
  for (const auto& ranges :
       std::vector<std::vector<std::pair<int64_t, int64_t>>>{{{0, 24}},
                                                             {{24, 24}},
                                                             {{5, 4}},
                                                             {{0, 11}, {11, 23}},
                                                             {{0, 0}, {0, 0}},
                                                             {{0, 1'000'000'000'000}}}) {
    Notes notes;
    const auto parts = Parts(MeshOf24(), Volumes(ranges), notes);
    ASSERT_FALSE(parts.ok());
    EXPECT_EQ(DetailOf(parts.status()).reason, Reason::kMeshMalformed);
    EXPECT_EQ(DetailOf(parts.status()).metadata["line"], "9");
    EXPECT_EQ(DetailOf(parts.status()).metadata["part"], "config");
  }
}

TEST(PartsOf, NotesPaintAndEmptyMeshes) {
  Package package = MeshOf24();
  package.files[0].objects[0].paint = kPaintedFuzzySkin | kPaintedColours;
  package.files[0].objects[0].triangles = 0;
  Notes notes;
  const auto parts = Parts(package, {}, notes);
  ASSERT_TRUE(parts.ok()) << parts.status();
  EXPECT_TRUE(parts->empty());
  EXPECT_THAT(notes.Lines(), testing::ElementsAre("painted fuzzy skin of `thing`",
                                                  "parts without a triangle of `thing`"));
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::parts_test
