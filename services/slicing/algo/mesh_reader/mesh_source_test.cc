#include "services/slicing/algo/mesh_reader/mesh_source.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::mesh_source_test {
namespace {

TEST(DirectMeshSource, ReadsWhatTheReaderReads) {
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30}));
  const auto source = MakeDirectMeshSource();
  constexpr ReadDepth kDepth = ReadDepth::kMeshes;
  const auto contents = source->Read(box, MeshFormat::kUnknown, 100, kDepth, {});
  ASSERT_TRUE(contents.ok()) << contents.status();
  ASSERT_EQ(contents->meshes.size(), 1u);
  EXPECT_EQ(contents->meshes[0].positions.size(), 8u);
  EXPECT_EQ(contents->meshes[0].triangles.size(), 12u);
  EXPECT_EQ(DetailOf(source->Read(box, MeshFormat::kStl, 25, kDepth, {}).status()).reason,
            Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(source->Read(box, MeshFormat::kObj, 100, kDepth, {}).status()).reason,
            Reason::kMeshMalformed);
  const CancelToken cancelled([] { return true; });
  EXPECT_TRUE(
      absl::IsCancelled(source->Read(box, MeshFormat::kStl, 100, kDepth, cancelled).status()));
}

}  // namespace
}  // namespace slicefarm::slicing::mesh_source_test
