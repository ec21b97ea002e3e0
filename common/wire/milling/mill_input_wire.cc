#include "common/wire/milling/mill_input_wire.h"

#include <utility>
#include <vector>

#include "common/wire/mesh_pieces.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

absl::Status PutMesh(const IndexedMesh& mesh, v1::MeshPiece* proto) {
  return ForEachPiece(mesh, [&](const v1::MeshPiece& piece) {
    proto->MergeFrom(piece);
    return true;
  });
}

v1::MeshSize SizeOf(const v1::MeshPiece& mesh) {
  v1::MeshSize size;
  size.set_vertices(mesh.xyz_nm_size() / 3);
  size.set_triangles(mesh.corners_size() / 3);
  return size;
}

}  // namespace

absl::Status ToProto(const MillInput& input, v1::MillInput* proto) {
  proto->set_settings(PackFields(input.settings));
  absl::Status status = PutMesh(input.part, proto->mutable_part());
  status.Update(PutMesh(input.stock, proto->mutable_stock()));
  return status;
}

absl::StatusOr<MillInput> FromProto(const v1::MillInput& proto) {
  auto settings = OptionsFromBytes<MillSettings>(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  if (!proto.has_part()) return Malformed("part", "is missing");
  const bool has_stock = proto.stock().xyz_nm_size() > 0 || proto.stock().corners_size() > 0;
  std::vector<v1::MeshSize> sizes = {SizeOf(proto.part())};
  if (has_stock) sizes.push_back(SizeOf(proto.stock()));
  absl::StatusOr<MeshReader> reader = MeshReader::Begin(std::move(sizes));
  if (!reader.ok()) return reader.status();
  absl::Status read = Within("part", reader->Add(proto.part()));
  if (read.ok() && has_stock) read = Within("stock", reader->Add(proto.stock()));
  if (!read.ok()) return read;
  absl::StatusOr<std::vector<IndexedMesh>> meshes = reader->Finish();
  if (!meshes.ok()) return meshes.status();
  MillInput input{std::move(meshes->front()), {}, *std::move(settings)};
  if (has_stock) input.stock = std::move(meshes->back());
  return input;
}

}  // namespace slicefarm
