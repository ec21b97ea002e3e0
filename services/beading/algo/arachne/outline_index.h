#pragma once

#include <memory>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Outlines, for questions of distance.
class OutlineIndex {
 public:
  /// Cost: O(n log n), n edges.
  explicit OutlineIndex(const MultiPolygon& outlines);
  ~OutlineIndex();
  OutlineIndex(OutlineIndex&&) noexcept;
  OutlineIndex& operator=(OutlineIndex&&) noexcept;

  /// How far the nearest outline is, in nm; infinity if there is none. Cost: O(log n) as a rule.
  double DistanceFrom(double x, double y) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace slicefarm::beading
