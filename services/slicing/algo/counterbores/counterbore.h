#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Holes that begin over one wider recess, so that nothing below carries their edges.
struct Counterbore {
  MultiPolygon holes;  ///< as islands
  /// What the layer of the holes, and each of those above it, leaves open, so that its edges lie on
  /// what the layer below left: slots across the recess, crossed by slots; where these leave
  /// corners wider than a bead, crossed by slots between both. Each lies within the one before, and
  /// around the holes. At least two.
  std::vector<MultiPolygon> rooms;
};

/// The counterbores in the outlines `here` of a layer, above the outlines `below`. A hole is part of
/// one where air lies below all that is within 0.4 mm of it. Slots run where bridges beside the holes
/// rest on `below` at both ends; where they do in no direction, as in a ledge, there is none. Of the
/// directions, that whose crossed slots lie closest around the holes, and then the shortest way.
/// Cost: a difference and an offset of both outlines; where that leaves no overhang, no more.
std::vector<Counterbore> CounterboresOver(const MultiPolygon& below, const MultiPolygon& here);

}  // namespace slicefarm::slicing
