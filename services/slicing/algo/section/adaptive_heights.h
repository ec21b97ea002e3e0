#pragma once

#include <span>
#include <vector>

#include "common/model/options/slicing_options.h"
#include "common/model/scene/mesh.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm::slicing {

/// What an object's layers are fitted to.
struct HeightProblem {
  std::vector<const IndexedMesh*> solids;  ///< the object stands on 0
  Coord top_nm = 0;
  Coord first_nm = 0;  ///< of the first layer, which is as high whatever is asked for
  std::vector<RangeInput> ranges;  ///< heights that are asked for; the first one that holds counts
};

/// The tops of the layers, upwards, the first one's included: the fewest layers of which
///
/// - none leaves a step (cusp) of more than `options.cusp_nm`, measured along the surface's normal:
///   a layer beside a face is at most cusp / |normal z| high, but never less than `options.min_nm`;
/// - all lie between `options.min_nm` and `options.max_nm`, in ranges at their height;
/// - none is more than `options.max_ratio` times as high as its neighbour (but for the first, and where
///   steps are coarser than that);
/// - each level face of at least 1 mm2 is the top of a layer. Of those nearer than the lowest layer
///   some are not; so is the object's top where nothing else fits.
///
/// Of equally many the ones that change least. Heights go in steps of about 10 um between level
/// faces. REQUIRES: 0 < min_nm <= max_nm, max_ratio >= 1. Cost: O(faces + top / 10 um * (max / 10 um)^2).
/// Source: Dolenc and Makela, Slicing procedures for layered manufacturing techniques (1994), for
/// the cusp; dynamic programming over all heights instead of one layer after the other.
std::vector<Coord> AdaptiveTops(const HeightProblem& problem, const AdaptiveHeights& options);

}  // namespace slicefarm::slicing
