#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/beading/algo/arachne/outline_index.h"

namespace slicefarm::beading {

/// Outlines of an object in consecutive layers. The number of beads at a position is chosen by the
/// mean of several layers, so adjacent layers choose the same number. The index of an outline is
/// built at its first use and remains for the next layers. Not thread-safe.
class NeighbourOutlines {
 public:
  /// `layers`: outlines of consecutive layers, lowest first; must outlive this object.
  explicit NeighbourOutlines(std::vector<const MultiPolygon*> layers)
      : layers_(std::move(layers)), indexes_(layers_.size()) {}

  /// Returns the outlines of the layer that is `by` layers above layers[i] (below if negative);
  /// nullptr if `layers` does not contain this layer.
  const MultiPolygon* At(size_t i, int by) const {
    const size_t at = i + static_cast<size_t>(by);  // a negative sum wraps to a huge index
    return at < layers_.size() ? layers_[at] : nullptr;
  }

  /// Returns the mean distance, in nm, of the position (x, y) from the outlines of layers[i] and of
  /// the layers up to `reach` layers above and below it. `radius_nm`: the distance in layers[i]. A
  /// layer is ignored if its distance differs from `radius_nm` by more than `band_nm`, because its
  /// shape is different at this position.
  double MeanRadius(size_t i, size_t reach, double x, double y, double radius_nm,
                    double band_nm) const;

 private:
  const OutlineIndex& IndexOf(size_t i) const;

  std::vector<const MultiPolygon*> layers_;
  mutable std::vector<std::optional<OutlineIndex>> indexes_;
};

}  // namespace slicefarm::beading
