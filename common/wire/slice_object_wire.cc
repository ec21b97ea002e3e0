#include "common/wire/slice_object_wire.h"

#include <cmath>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

constexpr int kPartRoles = 7;
static_assert(v1::PART_ROLE_SOLID == static_cast<int>(PartRole::kSolid) + 1);
static_assert(v1::PART_ROLE_NEGATIVE == static_cast<int>(PartRole::kNegative) + 1);
static_assert(v1::PART_ROLE_MODIFIER == static_cast<int>(PartRole::kModifier) + 1);
static_assert(v1::PART_ROLE_SUPPORT_ENFORCER == static_cast<int>(PartRole::kSupportEnforcer) + 1);
static_assert(v1::PART_ROLE_SUPPORT_BLOCKER == static_cast<int>(PartRole::kSupportBlocker) + 1);
static_assert(v1::PART_ROLE_SEAM_ENFORCER == static_cast<int>(PartRole::kSeamEnforcer) + 1);
static_assert(v1::PART_ROLE_SEAM_BLOCKER == static_cast<int>(PartRole::kSeamBlocker) + 1);
static_assert(v1::PartRole_MAX == kPartRoles);
constexpr int kPlaces = 3;
static_assert(v1::SliceCopy::PLACE_ANYWHERE == static_cast<int>(CopyInput::Place::kAnywhere) + 1);
static_assert(v1::SliceCopy::PLACE_MIDDLE_AT == static_cast<int>(CopyInput::Place::kMiddleAt) + 1);
static_assert(v1::SliceCopy::PLACE_ORIGIN_AT == static_cast<int>(CopyInput::Place::kOriginAt) + 1);
static_assert(v1::SliceCopy::Place_MAX == kPlaces);

absl::Status ToProto(const PartInput& part, v1::SlicePart* proto) {
  proto->set_name(part.name);
  proto->mutable_mesh()->set_file(part.mesh.file);
  proto->mutable_mesh()->set_mesh(part.mesh.mesh);
  proto->mutable_mesh()->set_first_triangle(part.mesh.first_triangle);
  proto->mutable_mesh()->set_triangle_count(part.mesh.triangle_count);
  proto->set_role(EnumToProto<v1::PartRole>(part.role));
  PutTransform(part.to_object, proto->mutable_to_object());
  proto->mutable_regions()->Assign(part.regions.begin(), part.regions.end());
  proto->mutable_changes()->insert(part.changes.begin(), part.changes.end());
  return absl::OkStatus();
}

absl::Status CheckRowsOf(const v1::SlicePart& proto) {
  for (const int32_t row : proto.regions())
    if (row < 0) return Malformed("regions", "are negative");
  for (const auto& [outside, inside] : proto.changes())
    if (outside < 0 || inside < 0) return Malformed("changes", "are negative");
  if (proto.changes_size() > limits::kMaxRegionSettings) {
    return LimitError(Reason::kRequestTooLarge, "changes of a modifier", limits::kMaxRegionSettings,
                      proto.changes_size());
  }
  return absl::OkStatus();
}

absl::StatusOr<PartInput> FromProto(const v1::SlicePart& proto) {
  const auto role = EnumFromProto<PartRole>(proto.role(), kPartRoles, "role");
  if (!role.ok()) return role.status();
  const v1::MeshRef& mesh = proto.mesh();
  if (mesh.file() < 0 || mesh.mesh() < kOnlyMesh || mesh.first_triangle() < 0 ||
      mesh.triangle_count() < -1) {
    return Malformed("mesh", "has negative numbers");
  }
  if (absl::Status rows = CheckRowsOf(proto); !rows.ok()) return rows;
  const auto to_object = TakeTransform(proto.to_object(), "to_object");
  if (!to_object.ok()) return to_object.status();
  PartInput part;
  part.name = proto.name();
  part.mesh = {mesh.file(), mesh.mesh(), mesh.first_triangle(), mesh.triangle_count()};
  part.role = *role;
  part.to_object = *to_object;
  part.regions.assign(proto.regions().begin(), proto.regions().end());
  part.changes.insert(proto.changes().begin(), proto.changes().end());
  return part;
}

absl::Status ToProto(const RangeInput& range, v1::SliceHeights* proto) {
  proto->set_from_nm(range.from_nm);
  proto->set_to_nm(range.to_nm);
  proto->set_layer_height_nm(range.layer_height_nm);
  return absl::OkStatus();
}

absl::StatusOr<RangeInput> FromProto(const v1::SliceHeights& proto) {
  const auto is_height = [](int64_t nm) { return 0 <= nm && nm <= limits::kMaxCoord; };
  if (!is_height(proto.from_nm()) || !is_height(proto.to_nm()) ||
      !is_height(proto.layer_height_nm())) {
    return Malformed("from_nm, to_nm, layer_height_nm", "not all are heights");
  }
  return RangeInput{proto.from_nm(), proto.to_nm(), proto.layer_height_nm()};
}

absl::Status ToProto(const CopyInput& copy, v1::SliceCopy* proto) {
  proto->set_place(EnumToProto<v1::SliceCopy::Place>(copy.place));
  return ToProto(copy.at, proto->mutable_at());
}

absl::StatusOr<CopyInput> FromProto(const v1::SliceCopy& proto) {
  const auto place = EnumFromProto<CopyInput::Place>(proto.place(), kPlaces, "place");
  if (!place.ok()) return place.status();
  return CopyInput{*place, FromProto(proto.at())};
}

/// Does the same as AllToProto, for the converters of this file.
template <typename Model, typename Proto>
absl::Status EachToProto(const std::vector<Model>& models, std::string_view field,
                         google::protobuf::RepeatedPtrField<Proto>* protos) {
  for (size_t i = 0; i < models.size(); ++i) {
    if (absl::Status status = ToProto(models[i], protos->Add()); !status.ok())
      return Within(field, i, status);
  }
  return absl::OkStatus();
}

template <typename Model, typename Proto>
absl::Status EachFromProto(const google::protobuf::RepeatedPtrField<Proto>& protos,
                           std::string_view field, std::vector<Model>* models) {
  for (int i = 0; i < protos.size(); ++i) {
    absl::StatusOr<Model> model = FromProto(protos[i]);
    if (!model.ok()) return Within(field, i, model.status());
    models->push_back(*std::move(model));
  }
  return absl::OkStatus();
}

}  // namespace

void PutTransform(const Transform& transform, google::protobuf::RepeatedField<double>* proto) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) proto->Add(transform(row, column));
}

absl::StatusOr<Transform> TakeTransform(const google::protobuf::RepeatedField<double>& proto,
                                        std::string_view field) {
  if (proto.size() != 12) return Malformed(field, "not 12 numbers");
  Transform transform;
  for (int i = 0; i < 12; ++i) {
    if (!std::isfinite(proto[i])) return Malformed(field, "is not finite");
    transform(i / 4, i % 4) = proto[i];
  }
  return transform;
}

absl::Status ToProto(const ObjectInput& object, v1::SliceObject* proto) {
  proto->set_name(object.name);
  proto->set_sunk_mm(object.sunk_mm);
  PutTransform(object.to_plate, proto->mutable_to_plate());
  absl::Status status = EachToProto(object.parts, "parts", proto->mutable_parts());
  status.Update(EachToProto(object.ranges, "ranges", proto->mutable_ranges()));
  status.Update(EachToProto(object.copies, "copies", proto->mutable_copies()));
  return status;
}

absl::StatusOr<ObjectInput> FromProto(const v1::SliceObject& proto) {
  if (!std::isfinite(proto.sunk_mm()) || std::abs(proto.sunk_mm()) > limits::kMaxMeshCoordinateMm) {
    return Malformed("sunk_mm", "is not a depth");
  }
  if (proto.copies_size() > limits::kMaxObjects) {
    return LimitError(Reason::kRequestTooLarge, "copies of an object", limits::kMaxObjects,
                      proto.copies_size());
  }
  const auto to_plate = TakeTransform(proto.to_plate(), "to_plate");
  if (!to_plate.ok()) return to_plate.status();
  ObjectInput object;
  object.name = proto.name();
  object.sunk_mm = proto.sunk_mm();
  object.to_plate = *to_plate;
  object.copies.clear();
  absl::Status status = EachFromProto(proto.parts(), "parts", &object.parts);
  status.Update(EachFromProto(proto.ranges(), "ranges", &object.ranges));
  status.Update(EachFromProto(proto.copies(), "copies", &object.copies));
  if (!status.ok()) return status;
  return object;
}

}  // namespace slicefarm
