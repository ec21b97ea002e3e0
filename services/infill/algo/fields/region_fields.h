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

/// The fields of a row of settings.
struct FieldsOfRow {
  const DensityField* density = nullptr;  ///< the text's own, which must outlive it; null: none
  const DirectionField* directions = nullptr;  ///< the same
  double plain_density = 0;
  int32_t every_layers = 1;
  bool is_same_at_all_heights = false;
};
using FieldsOfRows = std::vector<FieldsOfRow>;

/// Each text is read once for all who have it. Errors: SETTING_MALFORMED for a text that is no
/// field.
absl::StatusOr<FieldsOfRows> ParseFields(const std::vector<InfillOptions>& regions);

/// The fields of a job's regions in a stretch of its layers.
class RegionFields {
 public:
  /// `fields` and `layers` must outlive this.
  RegionFields(const FieldsOfRows& fields, std::span<const SlicedLayer> layers)
      : fields_(fields), memos_(fields.size()), layers_(layers) {}

  /// What the fields of a row of settings say about an object's own layer, whose middle is at
  /// `z_mm`. Both families of directions are followed in turn, layer by layer, or by as many layers
  /// as are filled at once. None: it has no fields. It holds until the next call. Errors: those of
  /// SurfaceDistances.
  absl::StatusOr<std::optional<LayerField>> Of(int32_t row, int32_t object, int32_t own_layer,
                                               double z_mm);

 private:
  const FieldsOfRows& fields_;
  std::vector<std::array<StreamMemo, 2>> memos_;  ///< by row and family, of fields that are the
                                                  ///< same at all heights
  std::span<const SlicedLayer> layers_;
  std::map<std::pair<int32_t, int32_t>, SurfaceDistances> distances_;  ///< by row and object
  using MapOf = std::array<int32_t, 3>;  ///< row, object, its own layer
  std::optional<MapOf> map_of_;
  DistanceMap map_;
};

}  // namespace slicefarm::infill
