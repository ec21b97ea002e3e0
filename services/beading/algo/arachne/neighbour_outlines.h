#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/beading/algo/arachne/outline_index.h"

namespace slicefarm::beading {

/// Outlines of an object in consecutive layers. Adjacent layers use them to agree on borderline
/// decisions. The index of an outline is built at its first use and kept for the next layers.
class NeighbourOutlines {
 public:
  /// `layers` are consecutive; each outline must outlive this object.
  explicit NeighbourOutlines(std::vector<const MultiPolygon*> layers)
      : layers_(std::move(layers)), indexes_(layers_.size()) {}

  /// Returns the outline of the layer that is `by` layers above layers[i] (below if negative).
  /// Returns nullptr if this layer is not available.
  const MultiPolygon* At(size_t i, int by) const {
    const size_t at = i + static_cast<size_t>(by);  // a negative sum wraps to a huge index
    return at < layers_.size() ? layers_[at] : nullptr;
  }

  /// Returns the mean distance of the position (x, y) from the outlines of layers[i] and of the
  /// layers up to `reach` layers away. `radius_nm`: the distance in layers[i]. Layers are ignored
  /// if their distance differs from `radius_nm` by more than `band_nm`: they have another shape at
  /// this position.
  double MeanRadius(size_t i, size_t reach, double x, double y, double radius_nm,
                    double band_nm) const;

 private:
  const OutlineIndex& IndexOf(size_t i) const;

  std::vector<const MultiPolygon*> layers_;
  mutable std::vector<std::optional<OutlineIndex>> indexes_;
};

}  // namespace slicefarm::beading
