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

/// Parts of a surface in ranges of heights (slabs), seen from above. A painted face may be level,
/// so that no plane cuts it; a slab still contains it.
class SurfaceSlabs {
 public:
  /// Selection of faces: all faces, or only level ones.
  enum class Faces : uint8_t { kAll, kLevelAlone };

  /// `slabs`: sorted, so that both the low heights and the high heights ascend; slabs may overlap.
  /// `mesh` must outlive this object. Cost: O(faces + number of pairs of a face and a slab that
  /// contains a part of it).
  SurfaceSlabs(const IndexedMesh& mesh, std::vector<Slab> slabs, Faces faces);

  /// Returns the part of the surface in the slab as seen from above, grown by `reach_nm`. Vertical
  /// faces contribute nothing. The result is empty if `cancel` is set. Safe to call from several
  /// threads. Cost: UnionOfMany of one piece per face in the slab, and an offset.
  MultiPolygon Shadow(size_t slab, Coord reach_nm, const CancelToken& cancel = {}) const;

 private:
  Polygon PieceOf(const Triangle& face, const Slab& slab) const;

  const IndexedMesh* mesh_;
  std::vector<Slab> slabs_;
  /// indices of the faces in each slab, indexed by slab
  std::vector<std::vector<uint32_t>> faces_;
};

}  // namespace slicefarm::slicing
