#include "services/infill/algo/patterns/whole_paths.h"

#include <cmath>
#include <utility>

#include "services/infill/algo/space_filling/fermat.h"
#include "services/infill/algo/space_filling/quadtree_fill.h"

namespace slicefarm::infill {
namespace {

/// Returns the lines of all islands. `fill`: fills one island.
template <typename Fill>
absl::StatusOr<std::vector<Piece>> OfIslands(const MultiPolygon& region, const Fill& fill) {
  std::vector<Piece> pieces;
  for (const PolygonWithHoles& island : region) {
    auto lines = fill(island);
    if (!lines.ok()) return lines.status();
    for (Polyline& line : *lines) pieces.push_back({.points = std::move(line)});
  }
  return pieces;
}

}  // namespace

absl::StatusOr<std::vector<Piece>> Fermat(const MultiPolygon& region,
                                          const PatternContext& context) {
  return OfIslands(region, [&](const PolygonWithHoles& island) {
    return FermatFill(island, {std::llround(context.pitch_nm), context.first_line});
  });
}

absl::StatusOr<std::vector<Piece>> HilbertQuadtree(const MultiPolygon& region,
                                                   const PatternContext& context) {
  return OfIslands(region, [&](const PolygonWithHoles& island) {
    return HilbertFill(island, {std::llround(context.pitch_nm), context.first_line});
  });
}

absl::StatusOr<std::vector<Piece>> PeanoQuadtree(const MultiPolygon& region,
                                                 const PatternContext& context) {
  return OfIslands(region, [&](const PolygonWithHoles& island) {
    return PeanoFill(island, {std::llround(context.pitch_nm), context.first_line});
  });
}

}  // namespace slicefarm::infill
