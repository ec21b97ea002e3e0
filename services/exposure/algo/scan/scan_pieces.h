#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/exposure/algo/decompose/decompose.h"

namespace slicefarm::exposure {

/// Returns convex pieces of the region to be scanned. The boundary may move by 1 um: invisible
/// corners are removed, because each reflex corner would cost a cut. If rounding or simplification
/// has made rings cross, the region is united with itself. If crossings remain, the region is
/// opened (inset and outset) by 1 um. Errors: Cancelled; REQUEST_MALFORMED (Decompose). variant:
/// DecomposeOptions::variant.
absl::StatusOr<ConvexPieces> ScanPieces(const MultiPolygon& region, DecomposeMethod method,
                                        int32_t variant, const CancelToken& cancel);

}  // namespace slicefarm::exposure
