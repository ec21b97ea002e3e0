#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Holes that begin over one common wider recess, so that nothing below supports their edges.
struct Counterbore {
  MultiPolygon holes;  ///< the holes, as islands
  /// Areas to leave open, one for the first layer of the holes and one for each layer above it.
  /// They are chosen so that the edges of each layer lie on the layer below: first slots across the
  /// recess, then the same slots crossed by slots at right angles. If this leaves corners wider
  /// than a bead, a third area is crossed by the two diagonal slots too. Each area lies within the
  /// previous one and contains the holes. There are at least two areas.
  std::vector<MultiPolygon> rooms;
};

/// Returns the counterbores in the outlines `here` of a layer, above the outlines `below`. A hole
/// belongs to a counterbore if only air is below everything within 0.4 mm around it.
///
/// The slots run in a direction in which bridges beside the holes rest on `below` at both ends. If
/// there is no such direction, as on a ledge, there is no counterbore. Among the possible
/// directions, it takes the direction with the crossed slots closest around the holes. Among equal
/// ones, it takes the direction with the shortest bridges.
///
/// Cost: one difference and one offset of both outlines; no more if they show no overhang.
std::vector<Counterbore> CounterboresOver(const MultiPolygon& below, const MultiPolygon& here);

}  // namespace slicefarm::slicing
