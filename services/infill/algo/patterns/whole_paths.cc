#include "services/infill/algo/patterns/whole_paths.h"

#include <cmath>
#include <utility>

#include "services/infill/algo/space_filling/fermat.h"
#include "services/infill/algo/space_filling/quadtree_fill.h"

namespace slicefarm::infill {
namespace {

/// `fill`: of one island, at a spacing.
template <typename Fill>
absl::StatusOr<std::vector<Piece>> OfIslands(const MultiPolygon& region, const PatternPlace& place,
                                             const Fill& fill) {
  std::vector<Piece> pieces;
  for (const PolygonWithHoles& island : region) {
    auto lines = fill(island, std::llround(place.pitch_nm));
    if (!lines.ok()) return lines.status();
    for (Polyline& line : *lines) pieces.push_back({.points = std::move(line)});
  }
  return pieces;
}

}  // namespace

absl::StatusOr<std::vector<Piece>> Fermat(const MultiPolygon& region, const PatternPlace& place) {
  return OfIslands(region, place, [](const PolygonWithHoles& island, Coord spacing_nm) {
    return FermatFill(island, {spacing_nm});
  });
}

absl::StatusOr<std::vector<Piece>> HilbertQuadtree(const MultiPolygon& region,
                                                   const PatternPlace& place) {
  return OfIslands(region, place, [](const PolygonWithHoles& island, Coord spacing_nm) {
    return HilbertFill(island, {spacing_nm});
  });
}

absl::StatusOr<std::vector<Piece>> PeanoQuadtree(const MultiPolygon& region,
                                                 const PatternPlace& place) {
  return OfIslands(region, place, [](const PolygonWithHoles& island, Coord spacing_nm) {
    return PeanoFill(island, {spacing_nm});
  });
}

}  // namespace slicefarm::infill
