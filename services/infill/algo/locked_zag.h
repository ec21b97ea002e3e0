#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/pattern_options.h"
#include "services/infill/algo/sparse.h"

namespace slicefarm::infill {

/// Part of a region, and the parameters of its sparse infill.
struct SparseZone {
  MultiPolygon area;
  SparseFill fill;
};

/// Divides a region for the pattern lockedzag. The skin is the part within `skin_depth_nm` of the
/// region's boundary, with crosszag lines. The skeleton is the rest with zigzag lines at right
/// angles to the skin's lines. It reaches `lock_depth_nm` into the skin, so that both hold to each
/// other. `fill`: parameters that both parts share. Cost: two offsets and two boolean operations.
std::vector<SparseZone> LockedZones(const MultiPolygon& region, const SparseFill& fill,
                                    const LockedZagOptions& options);

}  // namespace slicefarm::infill
