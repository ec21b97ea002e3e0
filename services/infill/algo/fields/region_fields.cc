#include "services/infill/algo/fields/region_fields.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/model/fields/field_text.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {
namespace {

absl::Status Malformed(const std::string& setting, const absl::Status& why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{}: {}", setting, std::string(why.message())),
                   {{"setting", setting}});
}

absl::StatusOr<DirectionField> DirectionsOf(const std::string& text) {
  const auto stress = ParseStressField(text);
  if (!stress.ok()) return stress.status();
  return DirectionField(*stress);
}

bool IsSameAtAllHeights(const DensityField& density) {
  return density.kind == DensityField::Kind::kGrid && density.grid.count[2] == 1;
}

}  // namespace

absl::StatusOr<FieldsOfRows> ParseFields(const std::vector<InfillOptions>& regions) {
  FieldsOfRows rows;
  for (const InfillOptions& options : regions) {
    FieldsOfRow& row = rows.emplace_back();
    row.plain_density = options.density;
    row.every_layers = std::max(1, options.every_layers);
    if (!options.density_field.empty()) {
      const auto& density = DensityFieldOf(options.density_field);
      if (!density.ok()) return Malformed("density_field", density.status());
      row.density = &*density;
    }
    if (!options.stress_field.empty()) {
      const auto& directions = options.stress_field.Once(DirectionsOf);
      if (!directions.ok()) return Malformed("stress_field", directions.status());
      row.directions = &*directions;
      row.is_same_at_all_heights = directions->IsSameAtAllHeights() &&
                                   (row.density == nullptr || IsSameAtAllHeights(*row.density));
    }
  }
  return rows;
}

absl::StatusOr<std::optional<LayerField>> RegionFields::Of(int32_t row, int32_t object,
                                                           int32_t own_layer, double z_mm) {
  const FieldsOfRow& fields = fields_[static_cast<size_t>(row)];
  if (fields.density == nullptr && fields.directions == nullptr) return std::nullopt;
  LayerField field{.plain_density = fields.plain_density, .z_mm = z_mm};
  if (fields.directions != nullptr) {
    field.directions = fields.directions;
    field.across = own_layer / fields.every_layers % 2 != 0;
    if (fields.is_same_at_all_heights)
      field.memo = &memos_[static_cast<size_t>(row)][field.across ? 1 : 0];
  }
  if (fields.density == nullptr) return field;
  field.density = fields.density;
  if (field.density->kind == DensityField::Kind::kSurfaceDistance) {
    auto& distances =
        distances_.try_emplace({row, object}, layers_, object, field.density->ReachMm())
            .first->second;
    const MapOf wanted{row, object, own_layer};
    if (!distances.Has(own_layer)) return field;  // an object without layers is all surface
    if (map_of_ != wanted) {
      auto map = distances.Of(own_layer);
      if (!map.ok()) return map.status();
      map_ = *std::move(map);
    }
    map_of_ = wanted;
    field.to_surface = &map_;
  }
  return field;
}

}  // namespace slicefarm::infill
