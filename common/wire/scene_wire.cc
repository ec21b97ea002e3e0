#include "common/wire/scene_wire.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/slice_object_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/mesh_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

using Numbers = google::protobuf::RepeatedField<double>;

absl::StatusOr<Transform> TransformFromProto(const Numbers& proto, std::string_view field) {
  if (proto.empty()) return Transform(Transform::Identity());
  absl::StatusOr<Transform> transform = TakeTransform(proto, field);
  if (!transform.ok()) return transform.status();
  if (transform->cwiseAbs().maxCoeff() <= limits::kMaxTransformEntry) return transform;
  return Malformed(field, "has numbers beyond a million");
}

void ToProto(const Part& part, std::span<const StoredMesh> meshes, v1::Part* proto) {
  const StoredMesh& stored = meshes[static_cast<size_t>(part.mesh.file)];
  proto->set_name(part.name);
  v1::PartMesh& mesh = *proto->mutable_mesh();
  mesh.set_sha256(stored.sha256);
  mesh.set_format(ToProto(stored.format));
  if (part.mesh.mesh != kOnlyMesh) mesh.set_mesh(part.mesh.mesh);
  mesh.set_first_triangle(part.mesh.first_triangle);
  if (part.mesh.triangle_count >= 0) mesh.set_triangle_count(part.mesh.triangle_count);
  proto->set_role(EnumToProto<v1::PartRole>(part.role));
  PutTransform(part.to_object, proto->mutable_to_object());
  SettingsToProto(part.settings, proto->mutable_settings());
}

v1::Instance::Place PlaceOf(const Instance& instance) {
  if (!instance.placed) return v1::Instance::PLACE_ANYWHERE;
  return instance.by_middle ? v1::Instance::PLACE_MIDDLE_AT : v1::Instance::PLACE_ORIGIN_AT;
}

absl::StatusOr<Instance> FromProto(const v1::Instance& proto) {
  if (!v1::Instance::Place_IsValid(proto.place()))
    return Malformed("place", "is not one of this version");
  const auto to_plate = TransformFromProto(proto.to_plate(), "to_plate");
  if (!to_plate.ok()) return to_plate.status();
  Instance instance;
  instance.to_plate = *to_plate;
  instance.placed = proto.place() == v1::Instance::PLACE_ORIGIN_AT ||
                    proto.place() == v1::Instance::PLACE_MIDDLE_AT;
  instance.by_middle = proto.place() != v1::Instance::PLACE_ORIGIN_AT;
  return instance;
}

absl::StatusOr<HeightRange> FromProto(const v1::HeightRange& proto) {
  if (!std::isfinite(proto.from_mm()) || !std::isfinite(proto.to_mm()))
    return Malformed("from_mm, to_mm", "are not finite");
  return HeightRange{proto.from_mm(), proto.to_mm(), SettingsFromProto(proto.settings())};
}

/// Reader of objects that gives an index to each mesh that the objects refer to.
class SceneReader {
 public:
  absl::Status Add(const v1::Object& proto) {
    absl::StatusOr<SceneObject> object = proto.parts().empty() ? OfOneMesh(proto) : OfParts(proto);
    if (!object.ok()) return object.status();
    object->settings = SettingsFromProto(proto.settings());
    for (int i = 0; i < proto.height_ranges_size(); ++i) {
      absl::StatusOr<HeightRange> range = FromProto(proto.height_ranges(i));
      if (!range.ok()) return Within("height_ranges", i, range.status());
      object->ranges.push_back(*std::move(range));
    }
    if (proto.height_ranges_size() > limits::kMaxHeightRanges) {
      return LimitError(Reason::kRequestTooLarge, "height ranges of an object",
                        limits::kMaxHeightRanges, proto.height_ranges_size());
    }
    scene_.objects.push_back(*std::move(object));
    return absl::OkStatus();
  }

  SubmittedScene Take() && { return std::move(scene_); }

 private:
  /// Checks the number of copies before any copy is made, because a short message may request very
  /// many.
  absl::Status CountCopies(int64_t copies) {
    copies_ += std::max<int64_t>(copies, 1);
    if (copies_ <= limits::kMaxObjects) return absl::OkStatus();
    return LimitError(Reason::kRequestTooLarge, "objects with their copies", limits::kMaxObjects,
                      copies_);
  }

  absl::StatusOr<int32_t> FileOf(const std::string& sha256, v1::MeshFormat proto_format,
                                 const std::string& name, std::string_view field) {
    if (!IsSha256Hex(sha256)) return Malformed(field, "is not a SHA-256, 64 lower-case hex digits");
    const auto format = slicefarm::FromProto(proto_format);
    if (!format.ok()) return format.status();
    const auto [mesh, is_new] =
        known_.try_emplace({sha256, *format}, static_cast<int32_t>(scene_.meshes.size()));
    if (is_new) scene_.meshes.push_back({sha256, name, *format});
    return mesh->second;
  }

  absl::StatusOr<SceneObject> OfOneMesh(const v1::Object& proto) {
    if (!proto.instances().empty())
      return Malformed("instances", "are those of an object of parts, and there are no parts");
    if (proto.copies() < 0) return Malformed("copies", "are negative");
    const int64_t centers = proto.placement().centers_size();
    if (absl::Status ok = CountCopies(std::max<int64_t>(proto.copies(), centers)); !ok.ok())
      return ok;
    const auto file = FileOf(proto.mesh_sha256(), proto.format(), proto.name(), "mesh_sha256");
    if (!file.ok()) return file.status();
    const auto placement = slicefarm::FromProto(proto.placement());
    if (!placement.ok()) return Within("placement", placement.status());
    if (absl::Status ok = CheckPlacement(*placement); !ok.ok()) return ok;
    return ObjectOfFile(proto.name(), *file, *placement, proto.copies());
  }

  absl::StatusOr<SceneObject> OfParts(const v1::Object& proto) {
    if (!proto.mesh_sha256().empty() || proto.has_placement() || proto.copies() != 0)
      return Malformed("parts", "exclude mesh_sha256, placement and copies");
    if (absl::Status ok = CountCopies(proto.instances_size()); !ok.ok()) return ok;
    parts_ += proto.parts_size();
    if (parts_ > limits::kMaxParts) {
      return LimitError(Reason::kRequestTooLarge, "parts of all objects", limits::kMaxParts,
                        parts_);
    }
    // Each part gets a row of settings in each height range.
    slices_ += int64_t{proto.parts_size()} * (proto.height_ranges_size() + 1);
    if (slices_ > limits::kMaxPartRanges) {
      return LimitError(Reason::kRequestTooLarge, "parts of all objects, in each height range",
                        limits::kMaxPartRanges, slices_);
    }
    SceneObject object;
    object.name = proto.name();
    for (int i = 0; i < proto.parts_size(); ++i) {
      absl::StatusOr<Part> part = PartFromProto(proto.parts(i), proto.name());
      if (!part.ok()) return Within("parts", i, part.status());
      object.parts.push_back(*std::move(part));
    }
    for (int i = 0; i < proto.instances_size(); ++i) {
      const absl::StatusOr<Instance> instance = FromProto(proto.instances(i));
      if (!instance.ok()) return Within("instances", i, instance.status());
      object.instances.push_back(*instance);
    }
    if (object.instances.empty()) object.instances.push_back({.placed = false});
    return object;
  }

  absl::StatusOr<Part> PartFromProto(const v1::Part& proto, const std::string& object) {
    const v1::PartMesh& mesh = proto.mesh();
    Part part;
    part.name = proto.name();
    const auto file = FileOf(mesh.sha256(), mesh.format(), object, "sha256");
    if (!file.ok()) return Within("mesh", file.status());
    part.mesh = {*file, mesh.has_mesh() ? mesh.mesh() : kOnlyMesh, mesh.first_triangle(),
                 mesh.has_triangle_count() ? mesh.triangle_count() : -1};
    if (mesh.mesh() < 0 || mesh.first_triangle() < 0 || mesh.triangle_count() < 0)
      return Malformed("mesh", "has negative numbers");
    if (proto.role() != v1::PART_ROLE_UNSPECIFIED) {
      const auto role = EnumFromProto<PartRole>(proto.role(), v1::PartRole_MAX, "role");
      if (!role.ok()) return role.status();
      part.role = *role;
    }
    const auto to_object = TransformFromProto(proto.to_object(), "to_object");
    if (!to_object.ok()) return to_object.status();
    part.to_object = *to_object;
    part.settings = SettingsFromProto(proto.settings());
    return part;
  }

  SubmittedScene scene_;
  std::map<std::pair<std::string, MeshFormat>, int32_t> known_;
  int64_t parts_ = 0;
  int64_t slices_ = 0;  ///< number of parts times height ranges
  int64_t copies_ = 0;
};

}  // namespace

void ToProto(const SceneObject& object, std::span<const StoredMesh> meshes, v1::Object* proto) {
  proto->set_name(object.name);
  SettingsToProto(object.settings, proto->mutable_settings());
  for (const Part& part : object.parts) ToProto(part, meshes, proto->add_parts());
  for (const HeightRange& range : object.ranges) {
    v1::HeightRange& added = *proto->add_height_ranges();
    added.set_from_mm(range.from_mm);
    added.set_to_mm(range.to_mm);
    SettingsToProto(range.settings, added.mutable_settings());
  }
  for (const Instance& instance : object.instances) {
    if (!instance.printable) continue;
    v1::Instance& added = *proto->add_instances();
    added.set_place(PlaceOf(instance));
    PutTransform(instance.to_plate, added.mutable_to_plate());
  }
}

absl::StatusOr<SubmittedScene> FromProto(
    const google::protobuf::RepeatedPtrField<v1::Object>& objects) {
  SceneReader reader;
  for (int i = 0; i < objects.size(); ++i)
    if (absl::Status ok = reader.Add(objects[i]); !ok.ok()) return Within("objects", i, ok);
  return std::move(reader).Take();
}

}  // namespace slicefarm
