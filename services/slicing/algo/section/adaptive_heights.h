#pragma once

#include <span>
#include <vector>

#include "common/model/options/slicing_options.h"
#include "common/model/scene/mesh.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm::slicing {

/// Object to which the layers are fitted.
struct HeightProblem {
  std::vector<const IndexedMesh*> solids;  ///< solid meshes; the object's bottom is at z = 0
  Coord top_nm = 0;
  Coord first_nm = 0;  ///< height of the first layer, which is always used
  /// requested heights; if several ranges match, the first is used
  std::vector<RangeInput> ranges;
};

/// Returns the tops of the layers, upwards, including the first layer. It finds the fewest layers
/// that satisfy:
///
/// - No layer leaves a step (cusp) higher than `options.cusp_nm`, measured along the surface
///   normal. A layer beside a face is at most cusp / |normal z| high, but never lower than
///   `options.min_nm`.
/// - All heights are between `options.min_nm` and `options.max_nm`. Ranges use their own height.
/// - No layer is more than `options.max_ratio` times as high as its neighbour. Exceptions are the
///   first layer, and heights so small that the next possible height is already beyond the ratio.
/// - Each level face of at least 1 mm2 is the top of a layer. If level faces are closer together
///   than the lowest layer, some of them are missed. The object's top is also missed if nothing
///   else fits.
///
/// Among solutions with equally many layers, it takes the one with the smallest changes of height.
/// Heights are multiples of about 10 um between level faces. REQUIRES: 0 < min_nm <= max_nm,
/// max_ratio >= 1. Cost: O(faces + top / 10 um * (max / 10 um)^2).
///
/// Source: Dolenc and Makela, Slicing procedures for layered manufacturing techniques (1994), for
/// the cusp. Dynamic programming over all heights replaces their choice of one layer after the
/// other.
std::vector<Coord> AdaptiveTops(const HeightProblem& problem, const AdaptiveHeights& options);

}  // namespace slicefarm::slicing
