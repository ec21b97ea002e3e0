#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "services/infill/algo/fields/layer_field.h"
#include "services/infill/algo/fields/streamlines.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::infill {

/// Fields of one region: of one row of the job's table of infill options.
struct FieldsOfRow {
  /// Density field; null: none. It is stored together with the setting's text
  /// (InfillOptions::density_field), which must outlive this struct.
  const DensityField* density = nullptr;
  /// Direction field; null: none. It is stored together with the setting's text
  /// (InfillOptions::stress_field), which must outlive this struct.
  const DirectionField* directions = nullptr;
  double plain_density = 0;
  int32_t every_layers = 1;
  bool is_same_at_all_heights = false;
};
using FieldsOfRows = std::vector<FieldsOfRow>;

/// Reads the fields of each row of `regions`. The result has the same indices. A text that several
/// rows share is read only once. Errors: SETTING_MALFORMED for a text that is not a field.
absl::StatusOr<FieldsOfRows> ParseFields(const std::vector<InfillOptions>& regions);

/// Fields of a job's regions in a range of its layers.
class RegionFields {
 public:
  /// `fields` and `layers` must outlive this object.
  RegionFields(const FieldsOfRows& fields, std::span<const SlicedLayer> layers)
      : fields_(fields), memos_(fields.size()), layers_(layers) {}

  /// Returns the density and direction fields of a layer with its middle at `z_mm`; nullopt if the
  /// row has neither. `row`: row of the infill options, as index into FieldsOfRows; `object`: id of
  /// the object; `own_layer`: index of the layer in the object. A direction field has two families
  /// of lines, which consecutive layers use alternately. Layers that are filled together
  /// (every_layers) count as one. The result is valid until the next call. Errors:
  /// REQUEST_TOO_LARGE (see SurfaceDistances::Of).
  absl::StatusOr<std::optional<LayerField>> Of(int32_t row, int32_t object, int32_t own_layer,
                                               double z_mm);

 private:
  const FieldsOfRows& fields_;
  /// Cached lines of fields that do not depend on the height, indexed by row and family of
  /// directions.
  std::vector<std::array<StreamMemo, 2>> memos_;
  std::span<const SlicedLayer> layers_;
  /// Distances to the surface; the key is the row and the object.
  std::map<std::pair<int32_t, int32_t>, SurfaceDistances> distances_;
  using MapOf = std::array<int32_t, 3>;  ///< key: row, object, own layer
  std::optional<MapOf> map_of_;
  DistanceMap map_;
};

}  // namespace slicefarm::infill
