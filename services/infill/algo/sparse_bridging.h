#pragma once

#include <memory>
#include <optional>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/region_context.h"
#include "services/infill/algo/skins/skins.h"
#include "services/infill/algo/skins/sparse_bridges.h"
#include "services/infill/algo/sparse_under.h"

namespace slicefarm {
struct PlannedInfill;
}  // namespace slicefarm

namespace slicefarm::infill {

/// Fill area for which bridges over sparse infill are searched.
struct BridgedArea {
  const MultiPolygon& area;
  bool filled = true;  ///< true if the region has infill, so that some layers are all solid
  Point middle = {};   ///< point around which the pattern is laid out
};

/// Search for the bridges over sparse infill of a region. One object serves all fill areas of the
/// region: data of the whole layer below are computed once. Not thread-safe.
class SparseBridging {
 public:
  /// `context` and `plan` must outlive this object. `plan` may be null. REQUIRES: bridges over
  /// sparse infill are enabled (BridgesSparse).
  SparseBridging(const RegionContext& context, const PlannedInfill* plan);
  ~SparseBridging();

  /// Removes from the skins the parts that need bridges between the lines of the sparse infill
  /// below, and returns them. Errors: see SparseUnder::TakeBridges.
  absl::StatusOr<SparseBridges> Take(const BridgedArea& fill, Skins& skins);

  /// Removes from the skins the parts over bridges of the layer below that are over sparse infill,
  /// and returns them as second bridges. The bridges of the layer below are computed again, from
  /// its outline without walls. Errors: see SparseUnder::TakeBridges.
  absl::StatusOr<SparseBridges> TakeSecond(const BridgedArea& fill, Skins& skins);

 private:
  struct LowerLayer;

  bool SkinsBegin(const BridgedArea& fill) const;
  Coord WidthNm() const;

  const RegionContext& context_;
  const PlannedInfill* plan_;
  std::optional<SparseUnder> under_;   ///< made when first needed
  std::unique_ptr<LowerLayer> lower_;  ///< made when first needed
};

}  // namespace slicefarm::infill
