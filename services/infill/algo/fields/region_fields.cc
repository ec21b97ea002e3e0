#include "services/infill/algo/fields/region_fields.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/model/fields/field_text.h"

namespace slicefarm::infill {
namespace {

absl::Status Malformed(const std::string& setting, const absl::Status& why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{}: {}", setting, std::string(why.message())),
                   {{"setting", setting}});
}

bool IsSameAtAllHeights(const DensityField& density) {
  return density.kind == DensityField::Kind::kGrid && density.grid.count[2] == 1;
}

}  // namespace

absl::StatusOr<RegionFields> RegionFields::Read(std::span<const InfillOptions> regions,
                                                std::span<const SlicedLayer> layers) {
  RegionFields fields;
  fields.layers_ = layers;
  for (const InfillOptions& options : regions) {
    Fields& row = fields.rows_.emplace_back();
    row.plain_density = options.density;
    row.every_layers = std::max(1, options.every_layers);
    if (!options.density_field.empty()) {
      auto density = ParseDensityField(options.density_field);
      if (!density.ok()) return Malformed("density_field", density.status());
      row.density = *std::move(density);
    }
    if (!options.stress_field.empty()) {
      const auto stress = ParseStressField(options.stress_field);
      if (!stress.ok()) return Malformed("stress_field", stress.status());
      row.directions.emplace(*stress);
      if (row.directions->IsSameAtAllHeights() &&
          (!row.density.has_value() || IsSameAtAllHeights(*row.density)))
        row.is_same_at_all_heights = true;
    }
  }
  return fields;
}

absl::StatusOr<std::optional<LayerField>> RegionFields::Of(int32_t row, int32_t object,
                                                           int32_t own_layer, double z_mm) {
  Fields& fields = rows_[static_cast<size_t>(row)];
  if (!fields.density.has_value() && !fields.directions.has_value()) return std::nullopt;
  LayerField field{.plain_density = fields.plain_density, .z_mm = z_mm};
  if (fields.directions.has_value()) {
    field.directions = &*fields.directions;
    field.across = own_layer / fields.every_layers % 2 != 0;
    if (fields.is_same_at_all_heights) field.memo = &fields.memos[field.across ? 1 : 0];
  }
  if (!fields.density.has_value()) return field;
  field.density = &*fields.density;
  if (field.density->kind == DensityField::Kind::kSurfaceDistance) {
    auto& distances =
        distances_.try_emplace({row, object}, layers_, object, field.density->ReachMm())
            .first->second;
    const MapOf wanted{row, object, own_layer};
    if (!distances.Has(own_layer)) return field;  // an object that is not sliced is all surface
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
