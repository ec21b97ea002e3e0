#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Scans a region by rings. Cuts the region into convex pieces and fills each piece with rings. The
/// first ring is half a hatch distance, less half of ring_overlap_nm, from the piece's boundary.
/// Each further ring is a hatch distance further inside. An unmelted area in the middle is scanned
/// along its spine. kRings scans from the middle outwards, kRingsInward from the boundary inwards.
/// With linked rings, the rings of a piece form one line, with a link from each ring to the nearest
/// corner of the next.
///
/// Appends lines to `group`, in an order that begins near `from`, and adds the cuts to `counts`.
/// With turn_rings, the cuts and the starts of rings depend on `layer` (layer_shift.h). REQUIRES:
/// options.strategy is kRings or kRingsInward. Errors: Cancelled; REQUEST_MALFORMED (Decompose).
absl::Status ScanByRings(const MultiPolygon& region, const ExposureOptions& options, int32_t layer,
                         Point from, const CancelToken& cancel, ExposureGroup& group,
                         CutCounts& counts);

}  // namespace slicefarm::exposure
