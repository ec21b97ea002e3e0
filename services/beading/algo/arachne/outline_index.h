#pragma once

#include <memory>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Index of outlines for distance queries.
class OutlineIndex {
 public:
  /// Cost: O(n log n) for n edges.
  explicit OutlineIndex(const MultiPolygon& outlines);
  ~OutlineIndex();
  OutlineIndex(OutlineIndex&&) noexcept;
  OutlineIndex& operator=(OutlineIndex&&) noexcept;

  /// Returns the distance of the nearest outline in nm; infinity if there is none. Cost: usually
  /// O(log n).
  double DistanceFrom(double x, double y) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace slicefarm::beading
