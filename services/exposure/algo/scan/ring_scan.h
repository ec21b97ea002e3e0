#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Scans a region by rings: cuts it into convex pieces, and fills each by rings at half a hatch
/// distance (less half of ring_overlap_nm) from its border and each a hatch distance further in;
/// a leftover in the middle is scanned along its spine. kRings goes from the middle outwards,
/// kRingsInward from the border inwards. Linked rings of a piece are one line: from each ring on to
/// the nearest corner of the next.
///
/// Appends lines to `group`, in an order that begins near `from`, and the cuts to `counts`.
/// With turn_rings, cuts and the places where rings begin are those of the layer (layer_shift.h).
/// REQUIRES: options.strategy is one of the two. Errors: those of Decompose.
absl::Status ScanByRings(const MultiPolygon& region, const ExposureOptions& options, int32_t layer,
                         Point from, const CancelToken& cancel, ExposureGroup& group,
                         CutCounts& counts);

}  // namespace slicefarm::exposure
