#pragma once

#include <cstdint>
#include <optional>

#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "services/infill/algo/section_view.h"
#include "services/infill/algo/skins/cover_index.h"
#include "services/infill/algo/skins/sparse_bridges.h"

namespace slicefarm::infill {

/// Region of a section, for questions about its sparse infill. All referenced objects must outlive
/// this struct.
struct RegionView {
  const SectionView& section;
  const InfillOptions& options;
  const PlannedInfill* plan = nullptr;  ///< plan of the region's infill; null: no plan
  /// Index of the settings of the region that alone decides the skins; nullopt: the whole object
  /// decides.
  std::optional<int32_t> row = {};
};

/// Returns the distance in nm between the lines of sparse infill in a layer of this height, or
/// between groups of lines side by side. Without sparse infill, returns the distance for which
/// skins above are planned: five spacings.
double SparsePitchNm(const InfillOptions& options, Coord height_nm);

/// Returns the width in nm that a skin over sparse infill has at least, besides its own line, to be
/// bridged.
double LeastBridgedGapNm(const InfillOptions& options, Coord height_nm);

/// Sparse infill of the layer below a region. It decides where skins of the region are bridges. One
/// object serves all fill areas of the region. Not thread-safe.
class SparseUnder {
 public:
  /// REQUIRES: bridges over sparse infill are enabled (BridgesSparse). Cost: a comparison of some
  /// outlines.
  explicit SparseUnder(const RegionView& region);

  /// Returns the sparse infill of the layer below within `fill_area`, computed from outlines,
  /// without its beads: the area inside the walls and without skins. Returns an empty region if
  /// this area does not meet `wanted`. Cost: that of SparsePart, and one offset of the layer for
  /// the first fill area.
  SparseBelow Within(const MultiPolygon& fill_area, const MultiPolygon& wanted);

  /// Returns the areas of the beads of the sparse infill. Returns an empty area if the lines of the
  /// pattern do not follow from a formula. Errors: see MakePattern. Cost: that of the pattern, and
  /// a union of the lines.
  /// `middle`: point around which the pattern is laid out.
  absl::StatusOr<MultiPolygon> BeadsIn(const SparseBelow& sparse, Point middle = {}) const;

  /// Removes from a fill area's skins the parts that are over sparse infill and wide enough to need
  /// bridges, and returns these parts. `middles`: the result of BridgeMiddles for `skins.solid`.
  /// `middle`: see BeadsIn.
  /// Errors: see BeadsIn. Cost: the cost of Within, and of BeadsIn and TakeSparseBridges if there
  /// is a part to bridge.
  absl::StatusOr<SparseBridges> TakeBridges(const MultiPolygon& fill_area,
                                            const MultiPolygon& middles, Coord width_nm,
                                            Point middle, Skins& skins);

 private:
  /// Returns the area inside the walls of the layer below; computed at the first call.
  const MultiPolygon& WithinWalls();

  RegionView region_;
  SectionView below_;
  const MultiPolygon* outline_ = nullptr;  ///< outline of the layer below; null: no layer below
  bool same_outline_ = false;  ///< true if the layer below and this layer have the same outline
  Cover cover_;
  std::optional<CoverIndex> near_cover_;
  std::optional<MultiPolygon> within_walls_;
};

}  // namespace slicefarm::infill
