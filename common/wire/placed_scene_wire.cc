#include "common/wire/placed_scene_wire.h"

#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/mesh_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

static_assert(v1::PART_ROLE_SEAM_BLOCKER == static_cast<int>(PartRole::kSeamBlocker) + 1);

absl::StatusOr<PlacedScenePart> PartOf(const v1::PlacedPart& proto) {
  const auto role = EnumFromProto<PartRole>(proto.role(), v1::PartRole_MAX, "role");
  if (!role.ok()) return role.status();
  absl::StatusOr<MeshReport> report = FromProto(proto.report());
  if (!report.ok()) return Within("report", report.status());
  return PlacedScenePart{*role, {}, *std::move(report)};
}

absl::StatusOr<PlacedSceneObject> ObjectOf(const v1::PlacedSceneObject& proto) {
  if (proto.to_origin_nm_size() != 3) return Malformed("to_origin_nm", "not three numbers");
  if (proto.shifts_size() > limits::kMaxObjects)
    return LimitError(Reason::kRequestTooLarge, "copies of an object", limits::kMaxObjects,
                      proto.shifts_size());
  PlacedSceneObject object;
  object.name = proto.name();
  object.to_origin = {proto.to_origin_nm(0), proto.to_origin_nm(1), proto.to_origin_nm(2)};
  for (const v1::Point& shift : proto.shifts()) object.shifts.push_back(FromProto(shift));
  for (int i = 0; i < proto.parts_size(); ++i) {
    absl::StatusOr<PlacedScenePart> part = PartOf(proto.parts(i));
    if (!part.ok()) return Within("parts", i, part.status());
    object.parts.push_back(*std::move(part));
  }
  return object;
}

}  // namespace

absl::Status ToProto(const PlacedScene& scene, v1::PlacedScene* proto) {
  for (const PlacedSceneObject& object : scene.objects) {
    v1::PlacedSceneObject* to = proto->add_objects();
    to->set_name(object.name);
    for (const Coord c : {object.to_origin.x, object.to_origin.y, object.to_origin.z})
      to->add_to_origin_nm(c);
    absl::Status put = AllToProto(object.shifts, "shifts", to->mutable_shifts());
    if (!put.ok()) return put;
    for (const PlacedScenePart& part : object.parts) {
      v1::PlacedPart* part_proto = to->add_parts();
      part_proto->set_role(EnumToProto<v1::PartRole>(part.role));
      *part_proto->mutable_size() = SizeOf(part.mesh);
      *part_proto->mutable_report() = ToProto(part.report);
    }
  }
  return absl::OkStatus();
}

absl::StatusOr<PlacedScene> FromProto(const v1::PlacedScene& proto) {
  if (proto.objects_size() > limits::kMaxObjects)
    return LimitError(Reason::kRequestTooLarge, "objects", limits::kMaxObjects,
                      proto.objects_size());
  PlacedScene scene;
  for (int i = 0; i < proto.objects_size(); ++i) {
    absl::StatusOr<PlacedSceneObject> object = ObjectOf(proto.objects(i));
    if (!object.ok()) return Within("objects", i, object.status());
    scene.objects.push_back(*std::move(object));
  }
  return scene;
}

std::vector<v1::MeshSize> MeshSizesOf(const v1::PlacedScene& proto) {
  std::vector<v1::MeshSize> sizes;
  for (const v1::PlacedSceneObject& object : proto.objects())
    for (const v1::PlacedPart& part : object.parts()) sizes.push_back(part.size());
  return sizes;
}

void PutMeshes(std::vector<IndexedMesh> meshes, PlacedScene& scene) {
  auto next = meshes.begin();
  for (PlacedSceneObject& object : scene.objects)
    for (PlacedScenePart& part : object.parts) part.mesh = std::move(*next++);
}

}  // namespace slicefarm
