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

/// Sparse infill of the layer below a region, for the skins of all fill areas of the region. Not
/// thread-safe.
class SparseUnder {
 public:
  /// REQUIRES: bridges over sparse infill are enabled (BridgesSparse). Cost: a comparison of some
  /// outlines.
  explicit SparseUnder(const RegionView& region);

  /// Returns the sparse infill of the layer below within `fill_area`, without its lines: the area
  /// without skins and walls, as computed from outlines. Returns nothing if it does not meet
  /// `wanted`. Cost: that of SparsePart, and one offset of the layer for the first fill area.
  SparseBelow Within(const MultiPolygon& fill_area, const MultiPolygon& wanted);

  /// Returns the areas of the beads of sparse infill, for patterns with lines that follow from a
  /// formula. Errors: see MakePattern. Cost: that of the pattern, and a union of the lines.
  absl::StatusOr<MultiPolygon> BeadsIn(const SparseBelow& sparse) const;

  /// Takes the parts of a fill area's skins that are over sparse infill and wide enough to need
  /// bridges. `middles`: BridgeMiddles of their solid part. Errors: see BeadsIn. Cost: the cost of
  /// Within, and of BeadsIn and TakeSparseBridges if there is a part to bridge.
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
