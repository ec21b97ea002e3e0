#pragma once

#include <cstdint>
#include <optional>

#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "services/infill/algo/section_view.h"
#include "services/infill/algo/skins/sparse_bridges.h"

namespace slicefarm::infill {

/// Whose sparse infill it is. All must outlive this.
struct RegionView {
  const SectionView& section;
  const InfillOptions& options;
  const PlannedInfill* plan = nullptr;  ///< null: nothing is planned
  std::optional<int32_t> row = {};      ///< the region that skins are of; none: of the whole object
};

/// How far apart the lines of sparse infill lie in a layer so high; of none at all, what skins over
/// it take for it.
double SparsePitchNm(const InfillOptions& options, Coord height_nm);

/// The sparse infill of the layer below within `fill_area`: where outlines say that it has no skins
/// and no walls there, and its lines, where a law says how they lie. REQUIRES: BridgesSparse.
/// Errors: as MakePattern. Cost: that of PartFillArea, and of the pattern.
absl::StatusOr<SparseBelow> SparseUnder(const MultiPolygon& fill_area, const RegionView& region);

}  // namespace slicefarm::infill
