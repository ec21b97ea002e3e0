#include "services/slicing/algo/mesh_io/mesh_source.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing {
namespace {

TEST(DirectMeshSource, ReadsWhatTheReaderReads) {
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30}));
  const auto source = MakeDirectMeshSource();
  const auto mesh = source->Read(box, MeshFormat::kUnknown, 100, {});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_EQ(mesh->positions.size(), 8u);
  EXPECT_EQ(mesh->triangles.size(), 12u);
  EXPECT_EQ(DetailOf(source->Read(box, MeshFormat::kStl, 25, {}).status()).reason,
            Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(source->Read(box, MeshFormat::kObj, 100, {}).status()).reason,
            Reason::kMeshMalformed);
  const CancelToken cancelled([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(source->Read(box, MeshFormat::kStl, 100, cancelled).status()));
}

}  // namespace
}  // namespace slicefarm::slicing
