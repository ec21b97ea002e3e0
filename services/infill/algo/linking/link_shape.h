#pragma once

#include <vector>

#include "common/geometry/edge_index.h"
#include "services/infill/algo/linking/edge_ends.h"
#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// How a link runs from one piece's end to the next one's: along the edge, with its corners cut
/// off where the pieces meet it.
struct LinkShape {
  int32_t stretch = 0;   ///< the link runs from this end forwards
  double from_cut_nm = 0;  ///< what the cut corners take from the two pieces
  double to_cut_nm = 0;
  Polyline way;          ///< from what is left of one piece to what is left of the other
  double length_nm = 0;  ///< of the way

  /// Length in beads as wide as the pieces, less what the pieces lost; links print `flow` of that.
  double Net(double flow) const { return flow * length_nm - from_cut_nm - to_cut_nm; }
};

/// The shapes of all links. A corner is cut off up to `cut_nm` along the piece and as far along the
/// edge, less where pieces or links are short, and not where the cut would leave the region.
std::vector<LinkShape> ShapeLinks(const EdgeEnds& ends, const Links& links,
                                  const EdgeIndex& edges, double cut_nm);

}  // namespace slicefarm::infill
