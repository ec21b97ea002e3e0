#pragma once

#include <span>
#include <vector>

#include "common/model/options/slicing_options.h"
#include "common/model/scene/mesh.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm::slicing {

/// Object for which layer heights are computed.
struct HeightProblem {
  std::vector<const IndexedMesh*> solids;  ///< solid meshes; the object's bottom is at z = 0
  Coord top_nm = 0;
  Coord first_nm = 0;  ///< height of the first layer, which is always used
  /// ranges with a height of their own; if several contain a layer, the first is used
  std::vector<RangeInput> ranges;
};

/// Returns the tops of the layers, ascending, including the first layer. The result has the fewest
/// layers that satisfy these rules:
///
/// - No layer leaves a step (cusp) higher than `options.cusp_nm`, measured along the surface
///   normal. A layer beside a face is at most cusp / |normal z| high, but never lower than
///   `options.min_nm`.
/// - All heights are between `options.min_nm` and `options.max_nm`. Ranges use their own height.
/// - No layer is more than `options.max_ratio` times as high as its neighbour. Exceptions are the
///   first layer, and heights so small that the next possible height is already beyond the ratio.
/// - Each level face of at least 1 mm2 is the top of a layer. If level faces are closer together
///   than the lowest layer, some of them have no layer top. The object's top also has none if no
///   allowed layer ends there.
///
/// Among solutions with equally many layers, the result has the smallest changes of height. Heights
/// are multiples of about 10 um between level faces. REQUIRES: 0 < min_nm <= max_nm, max_ratio >=
/// 1. Cost: O(faces + top / 10 um * (max / 10 um)^2).
///
/// Source: Dolenc and Makela, Slicing procedures for layered manufacturing techniques (1994), for
/// the cusp. They choose one layer after the other; here dynamic programming chooses all heights
/// together.
std::vector<Coord> AdaptiveTops(const HeightProblem& problem, const AdaptiveHeights& options);

}  // namespace slicefarm::slicing
