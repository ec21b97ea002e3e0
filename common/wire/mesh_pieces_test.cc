#include "common/wire/mesh_pieces.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::mesh_pieces_test {
namespace {

/// Returns a fan of the given number of triangles.
IndexedMesh Fan(uint32_t triangles) {
  IndexedMesh mesh;
  for (uint32_t i = 0; i < triangles + 2; ++i) mesh.vertices.push_back({i, -Coord{i}, 7});
  for (uint32_t i = 0; i < triangles; ++i) mesh.triangles.push_back({0, i + 1, i + 2});
  return mesh;
}

std::vector<v1::MeshPiece> PiecesOf(const std::vector<IndexedMesh>& meshes) {
  std::vector<v1::MeshPiece> pieces;
  for (const IndexedMesh& mesh : meshes)
    EXPECT_TRUE(ForEachPiece(mesh, [&](const v1::MeshPiece& piece) {
                  pieces.push_back(piece);
                  return true;
                }).ok());
  return pieces;
}

absl::StatusOr<std::vector<IndexedMesh>> Read(const std::vector<v1::MeshSize>& sizes,
                                              const std::vector<v1::MeshPiece>& pieces) {
  auto reader = MeshReader::Begin(sizes);
  if (!reader.ok()) return reader.status();
  for (const v1::MeshPiece& piece : pieces)
    if (absl::Status added = reader->Add(piece); !added.ok()) return added;
  return reader->Finish();
}

TEST(MeshPieces, Return) {
  const std::vector<std::vector<IndexedMesh>> cases = {
      {}, {{}}, {Fan(1)}, {{}, Fan(2), {}}, {Fan(200'000), {}, Fan(65'536), Fan(3)}};
  for (const std::vector<IndexedMesh>& meshes : cases) {
    std::vector<v1::MeshSize> sizes;
    for (const IndexedMesh& mesh : meshes) sizes.push_back(SizeOf(mesh));
    const auto back = Read(sizes, PiecesOf(meshes));
    ASSERT_TRUE(back.ok()) << back.status();
    EXPECT_EQ(*back, meshes);
  }
}

TEST(MeshPieces, EndWhenThePeerIsGone) {
  int sent = 0;
  const auto send = [&](const v1::MeshPiece&) { return ++sent < 2; };
  EXPECT_TRUE(ForEachPiece(Fan(200'000), send).ok());
  EXPECT_EQ(sent, 2);
}

TEST(MeshPieces, RefuseWhatIsNoMesh) {
  const IndexedMesh fan = Fan(4);
  const auto pieces = PiecesOf({fan});
  v1::MeshSize more = SizeOf(fan), fewer = SizeOf(fan), negative = SizeOf(fan);
  more.set_triangles(5);
  fewer.set_vertices(5);
  negative.set_triangles(-1);
  for (const v1::MeshSize& size : {more, fewer, negative})
    EXPECT_EQ(DetailOf(Read({size}, pieces).status()).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(Read({}, pieces).status()).reason, Reason::kRequestMalformed);
  v1::MeshSize huge = SizeOf(fan);
  huge.set_triangles(INT64_MAX);
  EXPECT_EQ(DetailOf(Read({huge, huge}, {}).status()).reason, Reason::kMeshTooLarge);
  auto wild = pieces;
  wild.back().set_corners(2, 6);
  ExpectMalformed(Read({SizeOf(fan)}, wild).status(), "piece.corners");
  wild = pieces;
  wild.front().add_xyz_nm(1);
  ExpectMalformed(Read({SizeOf(fan)}, wild).status(), "piece");
  IndexedMesh far = fan;
  far.vertices[1].z = Coord{1} << 32;
  EXPECT_EQ(DetailOf(ForEachPiece(far, [](const auto&) { return true; })).reason,
            Reason::kOutOfRange);
}

}  // namespace
}  // namespace slicefarm::mesh_pieces_test
