#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Heights from `low_nm` to `high_nm`, both included.
struct Slab {
  Coord low_nm = 0;
  Coord high_nm = 0;
};

/// What of a surface lies between heights, seen from above: a painted face may be level, and no
/// plane cuts it.
class SurfaceSlabs {
 public:
  enum class Faces : uint8_t { kAll, kLevelAlone };

  /// `slabs`: both of their heights ascend. `mesh` must outlive this. Cost: O(faces and slabs that
  /// they lie in).
  SurfaceSlabs(const IndexedMesh& mesh, std::vector<Slab> slabs, Faces faces);

  /// Returns the shadow of what lies in the slab, grown by `reach_nm`. Upright faces have none. Empty once `cancel`
  /// says so. Safe to call from many threads. Cost: a union of as many pieces (UnionOfMany), and an offset.
  MultiPolygon Shadow(size_t slab, Coord reach_nm, const CancelToken& cancel = {}) const;

 private:
  Polygon PieceOf(const Triangle& face, const Slab& slab) const;

  const IndexedMesh* mesh_;
  std::vector<Slab> slabs_;
  std::vector<std::vector<uint32_t>> faces_;  ///< by slab
};

}  // namespace slicefarm::slicing
