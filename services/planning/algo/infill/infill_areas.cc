#include "services/planning/algo/infill/infill_areas.h"

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::planning {
namespace {

/// Returns the parts of a region that are at least `width_nm` wide.
MultiPolygon Opened(const MultiPolygon& region, Coord width_nm) {
  return FastOffset(FastOffset(region, -width_nm / 2), width_nm / 2);
}

/// Returns `shared`, grown by `least_nm`. Where `area` extends beyond the grown area, `shared` does
/// not grow near this extension.
MultiPolygon WithEdges(const MultiPolygon& shared, const MultiPolygon& area, Coord least_nm) {
  const MultiPolygon around = FastOffset(shared, least_nm);
  const MultiPolygon beyond = Difference(area, around);
  if (beyond.empty()) return around;
  return Union(shared, Difference(around, FastOffset(beyond, least_nm)));
}

}  // namespace

void LeaveOutUnneeded(std::span<const MultiPolygon> areas, std::span<const MultiPolygon> roofs,
                      Coord least_nm, Coord margin_nm, std::span<InfillAreas> infill_areas) {
  MultiPolygon needed;
  for (size_t i = areas.size(); i-- > 0;) {
    if (!needed.empty()) needed = Intersection(needed, areas[i]);
    const MultiPolygon roof = Opened(roofs[i], least_nm);
    if (!roof.empty()) needed = Union(needed, roof);
    infill_areas[i].left_out =
        Union(infill_areas[i].left_out, Difference(FastOffset(areas[i], margin_nm), needed));
  }
}

void CombineLayers(const ObjectStack& stack, std::span<const MultiPolygon> areas,
                   int32_t every_layers, Coord least_nm, std::span<InfillAreas> infill_areas) {
  const auto count = static_cast<size_t>(every_layers);
  // The first layer is not combined: it is on the bed and must be complete.
  for (size_t first = 1; first + count <= stack.size(); first += count) {
    MultiPolygon shared = areas[first];
    Coord height_nm = 0;
    for (size_t i = first; i < first + count; ++i) {
      if (areas[i] != areas[first]) shared = Intersection(shared, areas[i]);
      height_nm += stack[i].height_nm;
    }
    if (shared.empty()) continue;
    const size_t last = first + count - 1;
    for (size_t i = first; i < last; ++i)
      infill_areas[i].left_out =
          Union(infill_areas[i].left_out, WithEdges(shared, areas[i], least_nm));
    infill_areas[last].combined = WithEdges(shared, areas[last], least_nm);
    infill_areas[last].combined_height_nm = height_nm;
  }
}

}  // namespace slicefarm::planning
