#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/beading/algo/arachne/outline_index.h"

namespace slicefarm::beading {

/// The outlines of an object's layers around one of them. Adjacent layers use them to agree on
/// borderline decisions. Indexes are made when they are asked for, and kept for the next layer.
class NeighbourOutlines {
 public:
  /// `layers` are consecutive; each outline must outlive this.
  explicit NeighbourOutlines(std::vector<const MultiPolygon*> layers)
      : layers_(std::move(layers)), indexes_(layers_.size()) {}

  /// The outline of the layer `by` above layers[i]; below, if negative. nullptr: it is not here.
  const MultiPolygon* At(size_t i, int by) const {
    const size_t at = i + static_cast<size_t>(by);  // below 0 wraps to far above
    return at < layers_.size() ? layers_[at] : nullptr;
  }

  /// The mean distance from the outlines, of the layers at most `reach` from layers[i] and itself,
  /// of a place that is `radius_nm` away from those of layers[i]. Layers in which it differs from
  /// that by more than `band_nm` have another shape there and do not count.
  double MeanRadius(size_t i, size_t reach, double x, double y, double radius_nm,
                    double band_nm) const;

 private:
  const OutlineIndex& IndexOf(size_t i) const;

  std::vector<const MultiPolygon*> layers_;
  mutable std::vector<std::optional<OutlineIndex>> indexes_;
};

}  // namespace slicefarm::beading
