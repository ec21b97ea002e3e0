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

/// Distances to the surface in one layer, in square cells of kDistanceCellMm, on a grid through the
/// object's origin.
struct DistanceMap {
  /// index of the first cell in x and y, counted from the origin
  int64_t first_x = 0, first_y = 0;
  int64_t width = 0, height = 0;
  std::vector<float> mm;  ///< distances in the middles of cells; x changes fastest

  /// Returns the distance at a point, interpolated linearly between the middles of cells. Outside
  /// of the grid, returns the value at the nearest point of the grid.
  double At(double x_mm, double y_mm) const;
};

/// Size of a cell in mm.
inline constexpr double kDistanceCellMm = 0.5;

/// Distances in space of points in an object from its surface. Each layer is a slab between its
/// bottom and its top. Everything outside of the layers is air, also below the lowest layer.
///
/// Accuracy: half a cell and half a layer. A larger distance than `reach_mm` is returned as
/// `reach_mm`, so layers farther away may be missing in `layers`. Cost: O(cells) for each layer
/// once, and O(cells) for each pair of layers within reach.
class SurfaceDistances {
 public:
  /// Keeps a reference: `layers` must outlive this object.
  SurfaceDistances(std::span<const SlicedLayer> layers, int32_t object, double reach_mm);

  /// Returns true if `layers` contains this layer of the object. `own_layer`: index of the layer in
  /// the object.
  bool Has(int32_t own_layer) const { return sections_.contains(own_layer); }
  /// Returns the distances in a layer, at the height of its middle. Call it for the layers in
  /// ascending order: otherwise the outlines of some layers are processed several times. REQUIRES:
  /// Has(own_layer). Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells.
  absl::StatusOr<DistanceMap> Of(int32_t own_layer);

 private:
  using Squares = std::vector<float>;  ///< squared distances within a layer, in cells

  const Squares& Within(int32_t own_layer);

  double reach_mm_;
  /// Sections of the object; the key is the index of the layer in the object.
  std::map<int32_t, const ObjectSection*> sections_;
  int64_t first_x_ = 0, first_y_ = 0, width_ = 0, height_ = 0;
  std::map<int32_t, std::shared_ptr<const Squares>> within_;
};

}  // namespace slicefarm::infill
