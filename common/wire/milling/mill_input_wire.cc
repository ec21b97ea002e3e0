#include "common/wire/milling/mill_input_wire.h"

#include "common/wire/milling/milling_options_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const MillInput& input, v1::MillHead* proto) {
  *proto->mutable_part() = SizeOf(input.part);
  *proto->mutable_stock() = SizeOf(input.stock);
  return ToProto(input.settings, proto->mutable_settings());
}

absl::StatusOr<MillInputReader> MillInputReader::Begin(const v1::MillHead& head) {
  absl::StatusOr<MillSettings> settings = FromProto(head.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  absl::StatusOr<MeshReader> meshes = MeshReader::Begin({head.part(), head.stock()});
  if (!meshes.ok()) return meshes.status();
  return MillInputReader(*std::move(settings), *std::move(meshes));
}

absl::StatusOr<MillInput> MillInputReader::Finish() {
  absl::StatusOr<std::vector<IndexedMesh>> meshes = meshes_.Finish();
  if (!meshes.ok()) return meshes.status();
  MillInput input{std::move((*meshes)[0]), std::move((*meshes)[1]), std::move(settings_), ""};
  input.digest = DigestOf(input.part, input.stock);
  return input;
}

}  // namespace slicefarm
