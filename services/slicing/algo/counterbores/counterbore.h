#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Counterbore: holes that begin over one common wider recess, so that no layer below supports
/// their walls.
struct Counterbore {
  MultiPolygon holes;  ///< the holes, as islands
  /// Areas that stay open, one for the first layer of the holes and one for each layer above it.
  /// They are chosen so that the layer below supports the outlines of each area. The first area
  /// consists of slots across the recess. In the second, these slots are crossed by slots at right
  /// angles. If corners wider than a bead would remain, a third area is also crossed by the two
  /// diagonal slots. Each area is within the previous one and contains the holes. There are at
  /// least two areas.
  std::vector<MultiPolygon> open_areas;
};

/// Returns the counterbores in the outlines `here` of a layer, above the outlines `below`. A hole
/// belongs to a counterbore if only air is below everything within 0.4 mm around it.
///
/// The slots have a direction in which bridges beside the holes end on `below` at both ends. If
/// there is no such direction, as on a ledge, there is no counterbore. Among the possible
/// directions, the function chooses the one with the crossed slots closest around the holes. If
/// several directions are equally good, it chooses the one with the shortest bridges.
///
/// Cost: one difference and one offset of both outlines; for counterbores also the boolean
/// operations of their slots.
std::vector<Counterbore> CounterboresOver(const MultiPolygon& below, const MultiPolygon& here);

}  // namespace slicefarm::slicing
