#include "common/wire/support/mesh_wire.h"

#include <algorithm>
#include <cmath>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/repeated_wire.h"

namespace slicefarm {
namespace {

using google::protobuf::RepeatedField;

constexpr int kPictureFormats = 5;
constexpr int kPictureRoles = 5;
static_assert(v1::PICTURE_FORMAT_PNG == static_cast<int>(PictureFormat::kPng) + 1);
static_assert(v1::PICTURE_FORMAT_QOI == static_cast<int>(PictureFormat::kQoi) + 1);
static_assert(v1::PICTURE_FORMAT_JPG == static_cast<int>(PictureFormat::kJpg) + 1);
static_assert(v1::PICTURE_FORMAT_BTT == static_cast<int>(PictureFormat::kBtt) + 1);
static_assert(v1::PICTURE_FORMAT_COLPIC == static_cast<int>(PictureFormat::kColPic) + 1);
static_assert(v1::PictureFormat_MAX == kPictureFormats);
static_assert(v1::PictureRole_MAX == kPictureRoles);
static_assert(v1::MESH_FORMAT_UNSPECIFIED == static_cast<int>(MeshFormat::kUnknown));
static_assert(v1::MESH_FORMAT_STL == static_cast<int>(MeshFormat::kStl));
static_assert(v1::MESH_FORMAT_OBJ == static_cast<int>(MeshFormat::kObj));
static_assert(v1::MESH_FORMAT_PLY == static_cast<int>(MeshFormat::kPly));
static_assert(v1::MESH_FORMAT_3MF == static_cast<int>(MeshFormat::k3mf));

bool AllFinite(const RepeatedField<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

absl::Status CheckTriple(const RepeatedField<double>& values, std::string_view field) {
  if (values.size() != 3) return Malformed(field, "not 3 values");
  if (!AllFinite(values)) return Malformed(field, "is not finite");
  return absl::OkStatus();
}

absl::Status CheckPlacement(const v1::Placement& proto) {
  if (!std::isfinite(proto.unit_mm()) || proto.unit_mm() < 0) {
    return Malformed("unit_mm", "is not a length");
  }
  const int scales = proto.scale_size();
  if (scales != 0 && scales != 1 && scales != 3) return Malformed("scale", "neither 0, 1 nor 3");
  if (!AllFinite(proto.scale()) ||
      std::ranges::any_of(proto.scale(), [](double scale) { return scale <= 0; })) {
    return Malformed("scale", "is not positive");
  }
  if (proto.rotate_deg_size() != 0) {
    if (absl::Status status = CheckTriple(proto.rotate_deg(), "rotate_deg"); !status.ok()) {
      return status;
    }
  }
  if (proto.centers_size() > limits::kMaxObjects) {
    return LimitError(Reason::kRequestTooLarge, "copies of an object", limits::kMaxObjects,
                      proto.centers_size());
  }
  return absl::OkStatus();
}

absl::Status CheckReport(const v1::MeshReport& proto) {
  if (absl::Status status = CheckTriple(proto.min_mm(), "min_mm"); !status.ok()) return status;
  if (absl::Status status = CheckTriple(proto.max_mm(), "max_mm"); !status.ok()) return status;
  if (!std::isfinite(proto.volume_mm3())) return Malformed("volume_mm3", "is not finite");
  if (!std::isfinite(proto.largest_gap_closed_mm())) {
    return Malformed("largest_gap_closed_mm", "is not finite");
  }
  if (!std::isfinite(proto.dropped_length_mm())) {
    return Malformed("dropped_length_mm", "is not finite");
  }
  if (!std::isfinite(proto.cracks_closed_mm())) {
    return Malformed("cracks_closed_mm", "is not finite");
  }
  return absl::OkStatus();
}

v1::Lying LyingToProto(const Lying& lying) {
  v1::Lying proto;
  proto.set_contact_mm2(lying.contact_mm2);
  proto.set_overhang_mm2(lying.overhang_mm2);
  proto.set_height_mm(lying.height_mm);
  proto.set_stable(lying.stable);
  return proto;
}

absl::StatusOr<Lying> LyingFromProto(const v1::Lying& proto) {
  for (const double value : {proto.contact_mm2(), proto.overhang_mm2(), proto.height_mm()})
    if (!std::isfinite(value))
      return Malformed("contact_mm2, overhang_mm2, height_mm", "not all are finite");
  return Lying{proto.contact_mm2(), proto.overhang_mm2(), proto.height_mm(), proto.stable()};
}

std::array<double, 3> Triple(const RepeatedField<double>& values) {
  return {values[0], values[1], values[2]};
}

}  // namespace

v1::MeshFormat ToProto(MeshFormat format) { return static_cast<v1::MeshFormat>(format); }

absl::StatusOr<MeshFormat> FromProto(v1::MeshFormat proto) {
  if (!v1::MeshFormat_IsValid(proto)) return Malformed("format", "is not a value of this version");
  return static_cast<MeshFormat>(proto);
}

absl::Status ToProto(const Placement& placement, v1::Placement* proto) {
  proto->set_unit_mm(placement.unit_mm);
  proto->mutable_scale()->Assign(placement.scale.begin(), placement.scale.end());
  proto->mutable_rotate_deg()->Assign(placement.rotate_deg.begin(), placement.rotate_deg.end());
  return AllToProto(placement.centers, "centers", proto->mutable_centers());
}

absl::StatusOr<Placement> FromProto(const v1::Placement& proto) {
  if (absl::Status status = CheckPlacement(proto); !status.ok()) return status;
  Placement placement;
  if (proto.unit_mm() != 0) placement.unit_mm = proto.unit_mm();
  if (proto.scale_size() == 1) placement.scale.fill(proto.scale(0));
  if (proto.scale_size() == 3) placement.scale = Triple(proto.scale());
  if (proto.rotate_deg_size() == 3) placement.rotate_deg = Triple(proto.rotate_deg());
  placement.centers.reserve(proto.centers_size());
  for (const v1::Point& center : proto.centers()) placement.centers.push_back(FromProto(center));
  return placement;
}

v1::MeshReport ToProto(const MeshReport& report) {
  v1::MeshReport proto;
  proto.set_name(report.name);
  proto.set_triangles(report.triangles);
  proto.set_vertices(report.vertices);
  proto.set_bodies(report.bodies);
  proto.set_open_edges(report.open_edges);
  proto.set_non_manifold_edges(report.non_manifold_edges);
  proto.set_flipped_faces(report.flipped_faces);
  proto.set_degenerate_faces(report.degenerate_faces);
  proto.set_repeated_faces(report.repeated_faces);
  proto.set_volume_mm3(report.volume_mm3);
  proto.mutable_min_mm()->Assign(report.min_mm.begin(), report.min_mm.end());
  proto.mutable_max_mm()->Assign(report.max_mm.begin(), report.max_mm.end());
  proto.set_open_loops_closed(report.open_loops_closed);
  proto.set_open_loops_dropped(report.open_loops_dropped);
  proto.set_largest_gap_closed_mm(report.largest_gap_closed_mm);
  proto.set_dropped_length_mm(report.dropped_length_mm);
  proto.set_cracks_closed_mm(report.cracks_closed_mm);
  proto.set_copies_off_bed(report.copies_off_bed);
  proto.set_overlapping_copies(report.overlapping_copies);
  return proto;
}

absl::StatusOr<MeshReport> FromProto(const v1::MeshReport& proto) {
  if (absl::Status status = CheckReport(proto); !status.ok()) return status;
  MeshReport report;
  report.name = proto.name();
  report.triangles = proto.triangles();
  report.vertices = proto.vertices();
  report.bodies = proto.bodies();
  report.open_edges = proto.open_edges();
  report.non_manifold_edges = proto.non_manifold_edges();
  report.flipped_faces = proto.flipped_faces();
  report.degenerate_faces = proto.degenerate_faces();
  report.repeated_faces = proto.repeated_faces();
  report.volume_mm3 = proto.volume_mm3();
  report.min_mm = Triple(proto.min_mm());
  report.max_mm = Triple(proto.max_mm());
  report.open_loops_closed = proto.open_loops_closed();
  report.open_loops_dropped = proto.open_loops_dropped();
  report.largest_gap_closed_mm = proto.largest_gap_closed_mm();
  report.dropped_length_mm = proto.dropped_length_mm();
  report.cracks_closed_mm = proto.cracks_closed_mm();
  report.copies_off_bed = proto.copies_off_bed();
  report.overlapping_copies = proto.overlapping_copies();
  return report;
}

v1::OrientationAdvice ToProto(const OrientationAdvice& advice) {
  v1::OrientationAdvice proto;
  proto.set_object(advice.object);
  proto.mutable_rotate_deg()->Assign(advice.rotate_deg.begin(), advice.rotate_deg.end());
  *proto.mutable_asked() = LyingToProto(advice.asked);
  *proto.mutable_advised() = LyingToProto(advice.advised);
  return proto;
}

absl::StatusOr<OrientationAdvice> FromProto(const v1::OrientationAdvice& proto) {
  if (absl::Status ok = CheckTriple(proto.rotate_deg(), "rotate_deg"); !ok.ok()) return ok;
  const absl::StatusOr<Lying> asked = LyingFromProto(proto.asked());
  if (!asked.ok()) return Within("asked", asked.status());
  const absl::StatusOr<Lying> advised = LyingFromProto(proto.advised());
  if (!advised.ok()) return Within("advised", advised.status());
  return OrientationAdvice{proto.object(), Triple(proto.rotate_deg()), *asked, *advised};
}

v1::Thumbnail ToProto(const Thumbnail& thumbnail) {
  v1::Thumbnail proto;
  proto.set_width_px(thumbnail.width_px);
  proto.set_height_px(thumbnail.height_px);
  proto.set_data(thumbnail.data);
  proto.set_format(EnumToProto<v1::PictureFormat>(thumbnail.format));
  proto.set_role(EnumToProto<v1::PictureRole>(thumbnail.role));
  return proto;
}

absl::StatusOr<Thumbnail> FromProto(const v1::Thumbnail& proto) {
  if (proto.width_px() < 1 || proto.height_px() < 1) return Malformed("width_px", "is not a size");
  const auto format = EnumFromProto<PictureFormat>(proto.format(), kPictureFormats, "format");
  if (!format.ok()) return format.status();
  const auto role = EnumFromProto<PictureRole>(proto.role(), kPictureRoles, "role");
  if (!role.ok()) return role.status();
  return Thumbnail{proto.width_px(), proto.height_px(), proto.data(), *format, *role};
}

}  // namespace slicefarm
