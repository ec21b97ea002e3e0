#include "services/infill/algo/patterns/registry.h"

#include <iterator>

#include "services/infill/algo/patterns/cell_curves.h"
#include "services/infill/algo/patterns/concentric.h"
#include "services/infill/algo/patterns/crosshatch.h"
#include "services/infill/algo/patterns/crossing_lines.h"
#include "services/infill/algo/patterns/honeycomb.h"
#include "services/infill/algo/patterns/honeycomb_3d.h"
#include "services/infill/algo/patterns/medial_axis.h"
#include "services/infill/algo/patterns/planned_lines.h"
#include "services/infill/algo/patterns/rectilinear.h"
#include "services/infill/algo/patterns/spirals.h"
#include "services/infill/algo/patterns/surfaces.h"
#include "services/infill/algo/patterns/voronoi.h"
#include "services/infill/algo/patterns/whole_paths.h"

namespace slicefarm::infill {
namespace {

struct Row {
  FillPattern pattern;
  MakePattern* make;
};

constexpr Row kRows[] = {
    {FillPattern::kRectilinear, Rectilinear},
    {FillPattern::kAlignedRectilinear, AlignedRectilinear},
    {FillPattern::kLine, Rectilinear},
    {FillPattern::kZigzag, Zigzag},
    {FillPattern::kGrid, Grid},
    {FillPattern::kTriangles, Triangles},
    {FillPattern::kStars, Stars},
    {FillPattern::kCubic, Cubic},
    {FillPattern::kHoneycomb, Honeycomb},
    {FillPattern::kHoneycombCells, HoneycombCells},
    {FillPattern::kHoneycomb3d, Honeycomb3d},
    {FillPattern::kGyroid, Gyroid},
    {FillPattern::kSchwarzD, SchwarzD},
    {FillPattern::kFischerKochS, FischerKochS},
    {FillPattern::kConcentric, Concentric},
    {FillPattern::kArchimedean, Archimedean},
    {FillPattern::kOctagram, Octagram},
    {FillPattern::kHilbert, Hilbert},
    {FillPattern::kPeano, Peano},
    {FillPattern::kMonotonic, Rectilinear},
    {FillPattern::kMonotonicLines, Rectilinear},
    {FillPattern::kFermat, Fermat},
    {FillPattern::kHilbertQuadtree, HilbertQuadtree},
    {FillPattern::kPeanoQuadtree, PeanoQuadtree},
    {FillPattern::kAdaptiveCubic, PlannedLines},
    {FillPattern::kSupportCubic, PlannedLines},
    {FillPattern::kLightning, PlannedLines},
    {FillPattern::kMedialAxis, MedialAxis},
    {FillPattern::kVoronoi, Voronoi},
    {FillPattern::kCrosshatch, Crosshatch},
    {FillPattern::kQuarterCubic, QuarterCubic},
    {FillPattern::kCrossZag, CrossZag},
    {FillPattern::kLockedZag, CrossZag},  // its parts: locked_zag.h
    {FillPattern::kLateralLattice, LateralLattice},
    {FillPattern::kLateralHoneycomb, LateralHoneycomb},
};

constexpr bool InOrder() {
  for (size_t i = 0; i < std::size(kRows); ++i)
    if (static_cast<size_t>(kRows[i].pattern) != i) return false;
  return std::size(kRows) == kFillPatternCount;
}
static_assert(InOrder(),
              "each pattern of common/model/options/fill_patterns.h has a row, in their order");

}  // namespace

MakePattern* PatternOf(FillPattern pattern) { return kRows[static_cast<int>(pattern)].make; }

}  // namespace slicefarm::infill
