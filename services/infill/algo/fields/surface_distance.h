#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/measure.h"
#include "common/model/layers/layer.h"

namespace slicefarm::infill {

/// Distances on cells of kDistanceCellMm, which lie on the object's own grid.
struct DistanceMap {
  int64_t first_x = 0, first_y = 0;  ///< of the cells' indices
  int64_t width = 0, height = 0;
  std::vector<float> mm;  ///< x running fastest; at the cells' middles

  /// Linear between middles; as at the nearest one outside.
  double At(double x_mm, double y_mm) const;
};

inline constexpr double kDistanceCellMm = 0.5;

/// How far places in an object are from its surface, in space: in their own layer and through the
/// layers above and below, which count as slabs. What no layer has is air, and so is the bed.
///
/// Accuracy: half a cell and half a layer. A distance does not depend on which other layers are at
/// hand, as long as all those are that lie within `reach_mm`; it is never more than that.
/// Cost: O(cells) for each layer once, and O(cells) for each pair of layers within reach.
class SurfaceDistances {
 public:
  /// `layers` must outlive this.
  SurfaceDistances(std::span<const SlicedLayer> layers, int32_t object, double reach_mm);

  /// Whether the object has such a layer here.
  bool Has(int32_t own_layer) const { return sections_.contains(own_layer); }
  /// REQUIRES: Has(own_layer). Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells.
  absl::StatusOr<DistanceMap> Of(int32_t own_layer);

 private:
  using Squares = std::vector<float>;  ///< squared distances within a layer, in cells

  const Squares& Within(int32_t own_layer);

  double reach_mm_;
  std::map<int32_t, const ObjectSection*> sections_;  ///< by own layer
  int64_t first_x_ = 0, first_y_ = 0, width_ = 0, height_ = 0;
  std::map<int32_t, std::shared_ptr<const Squares>> within_;
};

}  // namespace slicefarm::infill
