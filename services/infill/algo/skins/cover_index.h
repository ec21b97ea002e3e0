#pragma once

#include <map>

#include "common/geometry/box_index.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/skins/skins.h"

namespace slicefarm::infill {

/// Indices of the outlines that decide the skins of many fill areas. A fill area is divided by the
/// islands near it, because the whole outlines for each of many islands would take quadratic time.
class CoverIndex {
 public:
  /// `cover` and `outline` (the outline of the fill areas' own layer; may be null) must outlive
  /// this object. Cost: O(n log n), n islands of the different outlines with many islands.
  CoverIndex(const Cover& cover, const MultiPolygon* outline);
  CoverIndex(const CoverIndex&) = delete;
  CoverIndex& operator=(const CoverIndex&) = delete;

  /// Returns the cover for a fill area with this box: outlines with many islands have only islands
  /// with boxes that meet it. Equal pointers of the whole cover are equal again, and the own
  /// layer's outline is never changed. Cost: O(log n) per outline, and the islands near the box.
  Cover Near(const Box& box) const;

 private:
  void Add(const MultiPolygon* layer);

  const Cover& cover_;
  const MultiPolygon* outline_;
  std::map<const MultiPolygon*, BoxIndex> indices_;
};

}  // namespace slicefarm::infill
