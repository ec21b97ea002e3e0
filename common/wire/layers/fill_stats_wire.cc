#include "common/wire/layers/fill_stats_wire.h"

#include "common/wire/layers/path_wire.h"
#include "common/wire/support/amounts.h"
#include "common/wire/support/enum_wire.h"

namespace slicefarm {
namespace {

absl::StatusOr<std::optional<FillPattern>> PatternFromProto(int32_t proto) {
  if (proto == 0) return std::nullopt;
  const auto pattern = EnumFromProto<FillPattern>(proto, kFillPatternCount, "pattern");
  if (!pattern.ok()) return pattern.status();
  return *pattern;
}

}  // namespace

absl::Status ToProto(const FillStats& use, v1::FillStats* proto) {
  proto->set_settings(use.settings);
  proto->set_feature(ToProto(use.feature));
  if (use.pattern) proto->set_pattern(EnumToProto<int32_t>(*use.pattern));
  proto->set_area_mm2(use.area_mm2);
  proto->set_volume_mm3(use.volume_mm3);
  proto->set_asked_mm3(use.asked_mm3);
  proto->set_plastic_mm3(use.plastic_mm3);
  proto->set_paths(use.paths);
  proto->set_length_mm(use.length_mm);
  proto->set_longest_mm(use.longest_mm);
  return absl::OkStatus();
}

absl::StatusOr<FillStats> FromProto(const v1::FillStats& proto) {
  if (proto.settings() < 0) return Malformed("settings", "is negative");
  if (proto.paths() < 0) return Malformed("paths", "is negative");
  if (!AreAmounts({proto.area_mm2(), proto.volume_mm3(), proto.asked_mm3(), proto.plastic_mm3(),
                   proto.length_mm(), proto.longest_mm()}))
    return Malformed("area_mm2, volume_mm3, asked_mm3, plastic_mm3, length_mm, longest_mm",
                     "not all are amounts");
  const absl::StatusOr<Feature> feature = FromProto(proto.feature());
  if (!feature.ok()) return feature.status();
  const auto pattern = PatternFromProto(proto.pattern());
  if (!pattern.ok()) return pattern.status();
  return FillStats{proto.settings(),    *feature,           *pattern,
                   proto.area_mm2(),    proto.volume_mm3(), proto.asked_mm3(),
                   proto.plastic_mm3(), proto.paths(),      proto.length_mm(),
                   proto.longest_mm()};
}

}  // namespace slicefarm
