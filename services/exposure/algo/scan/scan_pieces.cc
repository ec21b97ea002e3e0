#include "services/exposure/algo/scan/scan_pieces.h"

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::exposure {
namespace {

constexpr Coord kMergeNm = 1'000;

bool IsCrossing(const absl::Status& status) { return absl::IsInvalidArgument(status); }

}  // namespace

absl::StatusOr<ConvexPieces> ScanPieces(const MultiPolygon& region, DecomposeMethod method,
                                        int32_t variant, const CancelToken& cancel) {
  const DecomposeOptions how = {.method = method, .merge_nm = kMergeNm, .variant = variant};
  auto pieces = Decompose(Simplify(region, kMergeNm), how, cancel);
  // Simplification may make the sides of a narrow part cross. Then the region itself is decomposed.
  if (IsCrossing(pieces.status())) pieces = Decompose(region, how, cancel);
  if (!IsCrossing(pieces.status())) return pieces;
  const MultiPolygon united = Union(region, {});
  pieces = Decompose(united, how, cancel);
  if (!IsCrossing(pieces.status())) return pieces;
  return Decompose(OffsetTwice(united, -kMergeNm, kMergeNm, {.miter_limit = 2}), how, cancel);
}

}  // namespace slicefarm::exposure
