#pragma once

#include <cstdint>
#include <optional>

#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "services/infill/algo/section_view.h"
#include "services/infill/algo/skins/sparse_bridges.h"

namespace slicefarm::infill {

/// Region with sparse infill. All referenced objects must outlive this.
struct RegionView {
  const SectionView& section;
  const InfillOptions& options;
  const PlannedInfill* plan = nullptr;  ///< null: no plan
  std::optional<int32_t> row = {};      ///< region of the skins; none: the whole object
};

/// Returns the distance between the lines of sparse infill in a layer of this height. Without
/// infill, returns the value that skins above it use.
double SparsePitchNm(const InfillOptions& options, Coord height_nm);

/// Returns the sparse infill of the layer below within `fill_area`: the area where the outlines
/// give no skins and no walls there, and its lines if their positions follow from a formula.
/// REQUIRES: BridgesSparse. Errors: as MakePattern. Cost: the cost of PartFillArea, and of the
/// pattern.
absl::StatusOr<SparseBelow> SparseUnder(const MultiPolygon& fill_area, const RegionView& region);

}  // namespace slicefarm::infill
