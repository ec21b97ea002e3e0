#pragma once

#include <cstdint>
#include <optional>

#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "services/infill/algo/section_view.h"
#include "services/infill/algo/skins/sparse_bridges.h"

namespace slicefarm::infill {

/// Region with sparse infill. All referenced objects must outlive this struct.
struct RegionView {
  const SectionView& section;
  const InfillOptions& options;
  const PlannedInfill* plan = nullptr;  ///< null: no plan
  /// Row of the region that decides the skins by its outlines; none: the whole object decides.
  std::optional<int32_t> row = {};
};

/// Returns the distance between the lines of sparse infill in a layer of this height. Without
/// sparse infill, returns the pitch that skins above assume: five spacings.
double SparsePitchNm(const InfillOptions& options, Coord height_nm);

/// The layer below a region, as the skins of all the region's fill areas look at it. Not for use by
/// several threads at once.
class SparseUnder {
 public:
  /// REQUIRES: bridges over sparse infill are enabled (BridgesSparse). Cost: a comparison of some
  /// outlines.
  explicit SparseUnder(const RegionView& region);

  /// Returns the sparse infill of the layer below within `fill_area`, where outlines say that it
  /// has no skins and no walls there; without its lines, and nothing if it does not meet `wanted`.
  /// Cost: that of SparsePart; for the first fill area also an offset of the layer.
  SparseBelow Within(const MultiPolygon& fill_area, const MultiPolygon& wanted);

  /// Returns the lines of sparse infill, as wide as they are, where a law says how they lie.
  /// Errors: as MakePattern. Cost: that of the pattern, and a union of the lines.
  absl::StatusOr<MultiPolygon> BeadsIn(const SparseBelow& sparse) const;

  /// Takes from the skins of a fill area what lies over sparse infill and is wide enough to need
  /// bridges. `middles`: BridgeMiddles of their solid part. Errors: as BeadsIn. Cost: that of
  /// Within, and of BeadsIn and TakeSparseBridges where there is something to bridge.
  absl::StatusOr<SparseBridges> TakeBridges(const MultiPolygon& fill_area,
                                            const MultiPolygon& middles, Coord width_nm,
                                            Skins& skins);

 private:
  /// Returns the area inside the walls of the layer below.
  const MultiPolygon& WithinWalls();

  RegionView region_;
  SectionView below_;
  const MultiPolygon* outline_ = nullptr;  ///< outline of the layer below; null: no layer below
  bool same_outline_ = false;  ///< true if the layer below and this layer have the same outline
  Cover cover_;
  std::optional<MultiPolygon> within_walls_;
};

}  // namespace slicefarm::infill
