#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/exposure/algo/decompose/decompose.h"

namespace slicefarm::exposure {

/// Convex pieces of what is to be scanned, whose border may move by 1 um: corners that change
/// nothing to be seen would cost a cut each. Where rounding or simplifying has made rings cross,
/// the region is united with itself; where that leaves crossings, it is opened by 1 um. Errors:
/// those of Decompose. variant: DecomposeOptions::variant.
absl::StatusOr<ConvexPieces> ScanPieces(const MultiPolygon& region, DecomposeMethod method,
                                        int32_t variant, const CancelToken& cancel);

}  // namespace slicefarm::exposure
