#include "common/wire/mesh_pieces.h"

#include <algorithm>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

/// Largest number of vertices or triangles in a piece, so that a piece stays at about a megabyte.
constexpr size_t kInPiece = 65'536;
/// Largest memory reserved for an announced mesh. More is allocated when its pieces arrive.
constexpr int64_t kMostReserved = 1 << 20;
constexpr int64_t kMaxVertices = 3 * limits::kMaxTriangles;

absl::Status PutVertices(const IndexedMesh& mesh, size_t first, size_t last, v1::MeshPiece* piece) {
  piece->mutable_xyz_nm()->Reserve(static_cast<int>(3 * (last - first)));
  for (size_t i = first; i < last; ++i) {
    const Vertex& v = mesh.vertices[i];
    for (const Coord c : {v.x, v.y, v.z}) {
      if (absl::Status fits = CheckCoord(c); !fits.ok()) return fits;
      piece->add_xyz_nm(static_cast<int32_t>(c));
    }
  }
  return absl::OkStatus();
}

}  // namespace

v1::MeshSize SizeOf(const IndexedMesh& mesh) {
  v1::MeshSize size;
  size.set_vertices(std::ssize(mesh.vertices));
  size.set_triangles(std::ssize(mesh.triangles));
  return size;
}

absl::Status ForEachPiece(const IndexedMesh& mesh,
                          const std::function<bool(const v1::MeshPiece&)>& send) {
  for (size_t i = 0; i < mesh.vertices.size(); i += kInPiece) {
    v1::MeshPiece piece;
    const size_t last = std::min(mesh.vertices.size(), i + kInPiece);
    if (absl::Status put = PutVertices(mesh, i, last, &piece); !put.ok()) return put;
    if (!send(piece)) return absl::OkStatus();
  }
  for (size_t i = 0; i < mesh.triangles.size(); i += kInPiece) {
    v1::MeshPiece piece;
    const size_t last = std::min(mesh.triangles.size(), i + kInPiece);
    piece.mutable_corners()->Reserve(static_cast<int>(3 * (last - i)));
    for (size_t t = i; t < last; ++t)
      for (const uint32_t corner : mesh.triangles[t]) piece.add_corners(corner);
    if (!send(piece)) return absl::OkStatus();
  }
  return absl::OkStatus();
}

absl::StatusOr<MeshReader> MeshReader::Begin(std::vector<v1::MeshSize> sizes) {
  MeshReader reader;
  int64_t triangles = 0;
  for (size_t i = 0; i < sizes.size(); ++i) {
    const v1::MeshSize& size = sizes[i];
    if (size.vertices() < 0 || size.triangles() < 0 || size.vertices() > kMaxVertices)
      return Within("meshes", i, Malformed("vertices, triangles", "are no sizes"));
    triangles += std::min(size.triangles(), limits::kMaxTriangles + 1);
    if (triangles > limits::kMaxTriangles)
      return LimitError(Reason::kMeshTooLarge, "triangles of all parts", limits::kMaxTriangles,
                        triangles);
    IndexedMesh& mesh = reader.meshes_.emplace_back();
    mesh.vertices.reserve(static_cast<size_t>(std::min(size.vertices(), kMostReserved)));
    mesh.triangles.reserve(static_cast<size_t>(std::min(size.triangles(), kMostReserved)));
  }
  reader.sizes_ = std::move(sizes);
  return reader;
}

bool MeshReader::IsWhole() const {
  return std::ssize(meshes_[mesh_].vertices) == sizes_[mesh_].vertices() &&
         std::ssize(meshes_[mesh_].triangles) == sizes_[mesh_].triangles();
}

absl::Status MeshReader::Add(const v1::MeshPiece& piece) {
  while (mesh_ < meshes_.size() && IsWhole()) ++mesh_;
  if (mesh_ == meshes_.size()) return Malformed("piece", "more than was announced");
  if (piece.xyz_nm_size() % 3 != 0 || piece.corners_size() % 3 != 0)
    return Malformed("piece", "not all have three numbers");
  IndexedMesh& mesh = meshes_[mesh_];
  const int64_t vertices = std::ssize(mesh.vertices) + piece.xyz_nm_size() / 3;
  const int64_t triangles = std::ssize(mesh.triangles) + piece.corners_size() / 3;
  if (vertices > sizes_[mesh_].vertices() || triangles > sizes_[mesh_].triangles())
    return Malformed("piece", "more than was announced");
  for (int i = 0; i < piece.xyz_nm_size(); i += 3)
    mesh.vertices.push_back({piece.xyz_nm(i), piece.xyz_nm(i + 1), piece.xyz_nm(i + 2)});
  for (int i = 0; i < piece.corners_size(); i += 3) {
    for (int k = 0; k < 3; ++k)
      if (piece.corners(i + k) >= sizes_[mesh_].vertices())
        return Malformed("piece.corners", "no vertex is there");
    mesh.triangles.push_back({piece.corners(i), piece.corners(i + 1), piece.corners(i + 2)});
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<IndexedMesh>> MeshReader::Finish() {
  while (mesh_ < meshes_.size() && IsWhole()) ++mesh_;
  if (mesh_ < meshes_.size()) return Malformed("piece", "less than was announced");
  return std::move(meshes_);
}

}  // namespace slicefarm
