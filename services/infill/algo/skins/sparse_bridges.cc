#include "services/infill/algo/skins/sparse_bridges.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/skins/smooth_offset.h"

namespace slicefarm::infill {
namespace {

/// Returns the part of `region` that is at least `width_nm` wide, plus the area within half of this
/// width beside it.
MultiPolygon WidePart(const MultiPolygon& region, Coord width_nm) {
  const MultiPolygon core = SmoothOffset(region, -width_nm / 2);
  if (core.empty()) return {};
  return Intersection(region, SmoothOffset(core, width_nm));
}

/// Returns the cells between beads that overlap `bridged` by more than a dot.
MultiPolygon CellsUnder(const MultiPolygon& bridged, const MultiPolygon& cells, Coord width_nm) {
  const double dot = static_cast<double>(width_nm) * static_cast<double>(width_nm);
  MultiPolygon reached;
  for (const PolygonWithHoles& cell : cells)
    if (Area(Intersection({cell}, bridged)) > std::min(dot, Area(cell) / 2))
      reached.push_back(cell);
  return reached;
}

/// Extends `bridged` to whole cells, and onto the beads around them.
MultiPolygon ToBeads(const MultiPolygon& bridged, const SparseBelow& below,
                     const MultiPolygon& room, Coord width_nm) {
  const auto reach_nm = static_cast<Coord>(std::llround(below.pitch_nm));
  const MultiPolygon near = Intersection(room, SmoothOffset(bridged, reach_nm));
  const MultiPolygon cells =
      CellsUnder(bridged, Difference(Intersection(near, below.region), below.beads), width_nm);
  return Intersection(near, SmoothOffset(Union(bridged, cells), width_nm));
}

/// Returns the least width of a skin that is bridged.
Coord LeastBridgeNm(double gap_nm, Coord width_nm) {
  return static_cast<Coord>(std::llround(gap_nm)) + width_nm;
}

}  // namespace

MultiPolygon BridgeMiddles(const MultiPolygon& solid, double gap_nm, Coord width_nm) {
  // The layer below may be higher, and its lines nearer to each other.
  constexpr double kSurely = 0.8;
  return SmoothOffset(solid, -LeastBridgeNm(kSurely * gap_nm, width_nm) / 2);
}

MultiPolygon UnheldParts(const SparseBelow& below, Coord width_nm, const Skins& skins) {
  return WidePart(Intersection(skins.solid, below.region),
                  LeastBridgeNm(below.least_gap_nm, width_nm));
}

SparseBridges TakeSparseBridges(MultiPolygon bridged, const SparseBelow& below, Coord width_nm,
                                Skins& skins) {
  const MultiPolygon room = Union(skins.solid, skins.sparse);
  if (!below.beads.empty()) bridged = ToBeads(bridged, below, room, width_nm);
  skins.solid = Difference(skins.solid, bridged);
  skins.sparse = Difference(skins.sparse, bridged);
  const MultiPolygon around = Difference(SmoothOffset(bridged, width_nm), below.region);
  return {std::move(bridged), below.beads.empty() ? around : Union(around, below.beads)};
}

}  // namespace slicefarm::infill
