#include "services/slicing/algo/mesh_io/threemf/components.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::slicing::threemf::components_test {
namespace {

/// Package of one file: object i + 1 has the listed components, or else a mesh.
struct Shape {
  std::vector<ObjectUse> components;
  bool empty = false;
};

Package PackageOf(const std::vector<Shape>& shapes) {
  Package package;
  ModelFile& file = package.files.emplace_back();
  file.part = kModelName;
  for (const Shape& shape : shapes) {
    ObjectResource object;
    object.id = static_cast<ResourceId>(file.objects.size() + 1);
    object.components = shape.components;
    for (ObjectUse& use : object.components) use.path = file.part;
    if (shape.components.empty() && !shape.empty) object.mesh = object.id - 1, object.triangles = 1;
    file.by_id[object.id] = file.objects.size();
    file.objects.push_back(object);
  }
  return package;
}

ObjectUse Use(ResourceId object, double x = 0) {
  ObjectUse use;
  use.object = object;
  use.transform(0, 3) = x;
  return use;
}

TEST(ComponentTree, FlattensWithAllTransforms) {
  const Package package = PackageOf({{},
                                     {{Use(1, 1), Use(1, 2)}},
                                     {{Use(2, 10), Use(1, 100), Use(4)}},
                                     {.components = {}, .empty = true}});
  const auto tree = ComponentTree::Make(package);
  ASSERT_TRUE(tree.ok()) << tree.status();
  const auto parts = tree->Flatten({0, 2});
  ASSERT_TRUE(parts.ok()) << parts.status();
  ASSERT_EQ(parts->size(), 3u);
  EXPECT_EQ((*parts)[0].to_object(0, 3), 11);
  EXPECT_EQ((*parts)[1].to_object(0, 3), 12);
  EXPECT_EQ((*parts)[2].to_object(0, 3), 100);
  EXPECT_EQ((*parts)[1].component, 2u);
  EXPECT_EQ((*parts)[2].component, 1u);
  EXPECT_EQ(tree->Flatten({0, 0})->size(), 1u);
  EXPECT_TRUE(tree->Flatten({0, 3})->empty());
}

TEST(ComponentTree, RefusesCycles) {
  for (const std::vector<Shape>& shapes : std::vector<std::vector<Shape>>{
           {{{Use(1)}}}, {{}, {{Use(3)}}, {{Use(2)}}}, {{{Use(2)}}, {{Use(3)}}, {{Use(1)}}}}) {
    const Package package = PackageOf(shapes);
    const auto tree = ComponentTree::Make(package);
    EXPECT_EQ(DetailOf(tree.status()).reason, Reason::kMeshMalformed) << tree.status();
    EXPECT_NE(std::string(tree.status().message()).find("contains itself"), std::string::npos);
  }
}

TEST(ComponentTree, RefusesWhatIsNotThere) {
  const Package package = PackageOf({{{Use(1'000'000'000)}}});
  EXPECT_EQ(DetailOf(ComponentTree::Make(package).status()).reason, Reason::kMeshMalformed);
}

std::vector<Shape> Chain(ResourceId levels, bool downwards, int width = 1) {
  std::vector<Shape> shapes(levels + 1);
  for (ResourceId i = 0; i < levels; ++i) {
    const size_t at = downwards ? i : i + 1;
    const ResourceId next = downwards ? i + 2 : i + 1;
    shapes[at].components.assign(static_cast<size_t>(width), Use(next, 1));
  }
  return shapes;
}

TEST(ComponentTree, BoundsTheDepth) {
  for (const bool downwards : {true, false}) {
    const Package deepest = PackageOf(Chain(32, downwards));
    const auto tree = ComponentTree::Make(deepest);
    ASSERT_TRUE(tree.ok()) << tree.status();
    EXPECT_EQ(tree->Flatten({0, downwards ? 0u : 32u})->size(), 1u);
    for (const ResourceId levels : {33u, 60u, 1000u}) {
      const Package deeper = PackageOf(Chain(levels, downwards));
      const auto refused = ComponentTree::Make(deeper);
      EXPECT_EQ(DetailOf(refused.status()).metadata["limit"], "32") << refused.status();
    }
  }
}

/// The objects nest to 2^32 parts, with and without a mesh. The result must come without visiting
/// each part.
TEST(ComponentTree, BoundsTheNumberOfParts) {
  const Package many = PackageOf(Chain(32, true, 2));
  const auto tree = ComponentTree::Make(many);
  ASSERT_TRUE(tree.ok()) << tree.status();
  const auto parts = tree->Flatten({0, 0});
  EXPECT_EQ(DetailOf(parts.status()).reason, Reason::kMeshTooLarge) << parts.status();
  std::vector<Shape> shapes = Chain(32, true, 2);
  shapes.back().empty = true;
  const Package none = PackageOf(shapes);
  EXPECT_TRUE(ComponentTree::Make(none)->Flatten({0, 0})->empty());
}

TEST(ComponentTree, RefusesTransformsThatOverflowTogether) {
  std::vector<Shape> shapes = Chain(4, true);
  for (Shape& shape : shapes)
    for (ObjectUse& use : shape.components) use.transform(0, 0) = 1000;
  const Package package = PackageOf(shapes);
  const auto tree = ComponentTree::Make(package);
  ASSERT_TRUE(tree.ok()) << tree.status();
  EXPECT_EQ(DetailOf(tree->Flatten({0, 0}).status()).reason, Reason::kOutOfRange);
}

TEST(ComponentTree, KnowsOtherNames) {
  const Package package =
      PackageOf({{}, {{Use(1)}}, {{Use(2)}}, {{Use(1, 5)}}, {{Use(1), Use(1)}}});
  const auto tree = ComponentTree::Make(package);
  ASSERT_TRUE(tree.ok()) << tree.status();
  EXPECT_EQ(tree->Original({0, 2}), (ObjectKey{0, 0}));
  EXPECT_EQ(tree->Original({0, 3}), (ObjectKey{0, 3}));
  EXPECT_EQ(tree->Original({0, 4}), (ObjectKey{0, 4}));
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::components_test
