#include "common/wire/layers/path_wire.h"

#include <limits>

#include "common/base/error.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

static_assert(v1::FEATURE_EXTERNAL_PERIMETER == static_cast<int>(Feature::kExternalPerimeter) + 1);
static_assert(v1::FEATURE_PERIMETER == static_cast<int>(Feature::kPerimeter) + 1);
static_assert(v1::FEATURE_OVERHANG_PERIMETER == static_cast<int>(Feature::kOverhangPerimeter) + 1);
static_assert(v1::FEATURE_GAP_FILL == static_cast<int>(Feature::kGapFill) + 1);
static_assert(v1::FEATURE_INTERNAL_INFILL == static_cast<int>(Feature::kInternalInfill) + 1);
static_assert(v1::FEATURE_SOLID_INFILL == static_cast<int>(Feature::kSolidInfill) + 1);
static_assert(v1::FEATURE_TOP_SOLID_INFILL == static_cast<int>(Feature::kTopSolidInfill) + 1);
static_assert(v1::FEATURE_BRIDGE_INFILL == static_cast<int>(Feature::kBridgeInfill) + 1);
static_assert(v1::FEATURE_SKIRT == static_cast<int>(Feature::kSkirt) + 1);
static_assert(v1::FEATURE_SUPPORT == static_cast<int>(Feature::kSupport) + 1);
static_assert(v1::FEATURE_SUPPORT_INTERFACE == static_cast<int>(Feature::kSupportInterface) + 1);
static_assert(v1::FEATURE_IRONING == static_cast<int>(Feature::kIroning) + 1);
static_assert(v1::FEATURE_SOLID_OVER_BRIDGE == static_cast<int>(Feature::kSolidOverBridge) + 1);
static_assert(v1::FEATURE_INTERNAL_BRIDGE == static_cast<int>(Feature::kInternalBridge) + 1);
static_assert(v1::Feature_MAX == kFeatureCount);

absl::Status PackWidths(const std::vector<Coord>& widths_nm, v1::Path* proto) {
  proto->mutable_widths_nm()->Reserve(static_cast<int>(widths_nm.size()));
  for (const Coord width : widths_nm) {
    if (width < 0 || width > std::numeric_limits<uint32_t>::max()) {
      return LimitError(Reason::kOutOfRange, "width in nm", std::numeric_limits<uint32_t>::max(),
                        width);
    }
    proto->add_widths_nm(static_cast<uint32_t>(width));
  }
  return absl::OkStatus();
}

absl::Status CheckFields(const v1::Path& proto) {
  if (proto.settings() < 0) return Malformed("settings", "is negative");
  if (proto.inset() < 0) return Malformed("inset", "is negative");
  if (proto.has_ring() && proto.ring() < 0) return Malformed("ring", "is negative");
  if (proto.tool() < 0) return Malformed("tool", "is negative");
  const int points = proto.xy_nm_size() / 2;
  if (points < 2) return Malformed("xy_nm", "fewer than 2 points");
  if (proto.widths_nm_size() != 1 && proto.widths_nm_size() != points) {
    return Malformed("widths_nm", "neither one width nor one for each point");
  }
  return absl::OkStatus();
}

}  // namespace

v1::Feature ToProto(Feature feature) { return EnumToProto<v1::Feature>(feature); }

absl::StatusOr<Feature> FromProto(v1::Feature proto) {
  return EnumFromProto<Feature>(proto, kFeatureCount, "feature");
}

absl::Status ToProto(const Path& path, v1::Path* proto) {
  proto->set_feature(ToProto(path.feature));
  proto->set_settings(path.settings);
  proto->set_inset(path.inset);
  proto->set_closed(path.closed);
  proto->set_one_way(!path.reversible);
  proto->set_tool(path.tool);
  if (path.ring >= 0) proto->set_ring(path.ring);
  if (absl::Status status = PackWidths(path.widths_nm, proto); !status.ok()) return status;
  return PackPoints(path.points, proto->mutable_xy_nm());
}

absl::StatusOr<Path> FromProto(const v1::Path& proto) {
  if (absl::Status status = CheckFields(proto); !status.ok()) return status;
  const absl::StatusOr<Feature> feature = FromProto(proto.feature());
  if (!feature.ok()) return feature.status();
  absl::StatusOr<std::vector<Point>> points = UnpackPoints(proto.xy_nm(), "xy_nm");
  if (!points.ok()) return points.status();

  Path path;
  path.feature = *feature;
  path.settings = proto.settings();
  path.inset = proto.inset();
  path.closed = proto.closed();
  path.reversible = !proto.one_way();
  path.tool = proto.tool();
  if (proto.has_ring()) path.ring = proto.ring();
  path.points = *std::move(points);
  path.widths_nm.assign(proto.widths_nm().begin(), proto.widths_nm().end());
  return path;
}

}  // namespace slicefarm
