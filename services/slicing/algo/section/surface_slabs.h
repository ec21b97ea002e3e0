#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Range of heights from `low_nm` to `high_nm`, both included.
struct Slab {
  Coord low_nm = 0;
  Coord high_nm = 0;
};

/// Parts of a surface between heights, seen from above. It is needed because a painted face may be
/// level, so no plane cuts it.
class SurfaceSlabs {
 public:
  /// Selection of faces: all faces or only level ones.
  enum class Faces : uint8_t { kAll, kLevelAlone };

  /// `slabs`: the low heights ascend, and so do the high ones. `mesh` must outlive this object.
  /// Cost: O(faces + slabs that they are in).
  SurfaceSlabs(const IndexedMesh& mesh, std::vector<Slab> slabs, Faces faces);

  /// Returns the shadow of the surface in the slab, grown by `reach_nm`. Vertical faces have none.
  /// The result is empty if `cancel` is set. Safe to call from several threads. Cost: a union of as
  /// many pieces (UnionOfMany), and an offset.
  MultiPolygon Shadow(size_t slab, Coord reach_nm, const CancelToken& cancel = {}) const;

 private:
  Polygon PieceOf(const Triangle& face, const Slab& slab) const;

  const IndexedMesh* mesh_;
  std::vector<Slab> slabs_;
  std::vector<std::vector<uint32_t>> faces_;  ///< faces per slab
};

}  // namespace slicefarm::slicing
