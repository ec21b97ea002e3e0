#pragma once

#include <cstdint>
#include <iterator>
#include <string_view>

namespace slicefarm {

/// Infill patterns, in the order of kFillPatterns.
enum class FillPattern : uint8_t {
  kRectilinear,
  kAlignedRectilinear,
  kLine,
  kZigzag,
  kGrid,
  kTriangles,
  kStars,
  kCubic,
  kHoneycomb,
  kHoneycombCells,
  kHoneycomb3d,
  kGyroid,
  kSchwarzD,
  kFischerKochS,
  kConcentric,
  kArchimedean,
  kOctagram,
  kHilbert,
  kPeano,
  kMonotonic,
  kMonotonicLines,
  kFermat,
  kHilbertQuadtree,
  kPeanoQuadtree,
  kAdaptiveCubic,
  kSupportCubic,
  kLightning,
  kMedialAxis,
  kVoronoi,
  kCrosshatch,
  kQuarterCubic,
  kCrossZag,
  kLockedZag,
  kLateralLattice,
  kLateralHoneycomb,
};

/// Method by which a pattern fills a solid region.
enum class SolidFillStyle : uint8_t {
  kNone,    ///< no solid fill: the pattern is not allowed in top_fill_pattern and similar settings
  kLines,   ///< straight lines with a spacing fitted to the region
  kCurves,  ///< curved lines that end at the region's boundary
  kAlongEdge,  ///< lines along the region's boundary
};

/// Description of a pattern, which settings, help, gallery, benchmarks and tests read. The code of
/// each pattern is in services/infill/algo/patterns/.
struct FillPatternInfo {
  FillPattern pattern = FillPattern::kRectilinear;
  std::string_view name;  ///< name in settings: the name in PrusaSlicer if it has the pattern
  bool sparse = false;    ///< true if the pattern is allowed in fill_pattern
  SolidFillStyle solid = SolidFillStyle::kNone;
  std::string_view doc;
  bool has_law = true;   ///< true if the density alone determines the length of the lines exactly
  bool planned = false;  ///< true if services/planning lays out the lines over the whole job
};

inline constexpr FillPatternInfo kFillPatterns[] = {
    {FillPattern::kRectilinear, "rectilinear", true, SolidFillStyle::kLines,
     "Parallel lines that turn by 90 degrees from layer to layer"},
    {FillPattern::kAlignedRectilinear, "alignedrectilinear", true, SolidFillStyle::kLines,
     "Parallel lines in the same direction in all layers"},
    {FillPattern::kLine, "line", true, SolidFillStyle::kNone, "As rectilinear"},
    {FillPattern::kZigzag, "zigzag", true, SolidFillStyle::kLines, "As alignedrectilinear"},
    {FillPattern::kGrid, "grid", true, SolidFillStyle::kNone,
     "Lines in two directions in each layer"},
    {FillPattern::kTriangles, "triangles", true, SolidFillStyle::kNone,
     "Lines in three directions that meet in points"},
    {FillPattern::kStars, "stars", true, SolidFillStyle::kNone,
     "Lines in three directions that form triangles and hexagons"},
    {FillPattern::kCubic, "cubic", true, SolidFillStyle::kNone,
     "Cubes standing on a corner: lines in three directions that shift with the height"},
    {FillPattern::kHoneycomb, "honeycomb", true, SolidFillStyle::kNone,
     "Hexagons of continuous rows, with two lines side by side where rows meet"},
    {FillPattern::kHoneycombCells, "honeycombcells", true, SolidFillStyle::kNone,
     "Hexagons with each wall printed once: the highest stiffness for its material, but many "
     "paths"},
    {FillPattern::kHoneycomb3d, "3dhoneycomb", true, SolidFillStyle::kNone,
     "Rows of waves with a height that grows and shrinks: cells closed on all sides"},
    {FillPattern::kGyroid, "gyroid", true, SolidFillStyle::kNone,
     "Gyroid surface, equally stiff in all directions: sin x cos y + sin y cos z + sin z cos x = "
     "0"},
    {FillPattern::kSchwarzD, "schwarzd", true, SolidFillStyle::kNone,
     "Surface of diamond symmetry: cos x cos y cos z = sin x sin y sin z"},
    {FillPattern::kFischerKochS, "fischerkochs", true, SolidFillStyle::kNone,
     "Fischer-Koch S surface: cos 2x sin y cos z + cos 2y sin z cos x + cos 2z sin x cos y = 0"},
    {FillPattern::kConcentric, "concentric", true, SolidFillStyle::kAlongEdge,
     "Loops that follow the edge of the region"},
    {FillPattern::kArchimedean, "archimedeanchords", true, SolidFillStyle::kCurves,
     "Spiral around the middle of the object"},
    {FillPattern::kOctagram, "octagramspiral", true, SolidFillStyle::kCurves,
     "Spiral in the shape of an eight-pointed star"},
    {FillPattern::kHilbert, "hilbertcurve", true, SolidFillStyle::kCurves,
     "Hilbert curve: a single line with right angles through all cells"},
    {FillPattern::kPeano, "peano", true, SolidFillStyle::kCurves,
     "Peano curve: a single line with right angles that divides cells into thirds"},
    {FillPattern::kMonotonic, "monotonic", true, SolidFillStyle::kLines,
     "Solid infill: connected lines printed in order across the area. Sparse infill: like "
     "rectilinear"},
    {FillPattern::kMonotonicLines, "monotoniclines", true, SolidFillStyle::kLines,
     "Solid infill: separate lines printed in order across the area. Sparse infill: like "
     "rectilinear"},
    {FillPattern::kFermat, "fermat", true, SolidFillStyle::kAlongEdge,
     "Connected Fermat spirals: a single path through each region, along its edge", false},
    {FillPattern::kHilbertQuadtree, "hilbertquadtree", true, SolidFillStyle::kAlongEdge,
     "Hilbert curve inside and loops along the edge: a single path through each region", false},
    {FillPattern::kPeanoQuadtree, "peanoquadtree", true, SolidFillStyle::kAlongEdge,
     "Peano curve inside and loops along the edge: a single path through each region", false},
    {FillPattern::kAdaptiveCubic, "adaptivecubic", true, SolidFillStyle::kNone,
     "Cubic cells that double in size with the distance from the surface", false, true},
    {FillPattern::kSupportCubic, "supportcubic", true, SolidFillStyle::kNone,
     "Cubic cells that double in size with the distance from top surfaces", false, true},
    {FillPattern::kLightning, "lightning", true, SolidFillStyle::kNone,
     "Trees that grow from the walls to the areas below top surfaces that need support", false,
     true},
    {FillPattern::kMedialAxis, "medialaxis", true, SolidFillStyle::kNone,
     "Lines at equal distances from the medial axis of the region, along its limbs and into its "
     "corners"},
    {FillPattern::kVoronoi, "voronoi", true, SolidFillStyle::kNone,
     "Irregular cells of similar size: Voronoi cells of points spread by Lloyd's method"},
    {FillPattern::kCrosshatch, "crosshatch", true, SolidFillStyle::kNone,
     "Lines that turn by a right angle after each band of layers, joined by waves between the "
     "bands"},
    {FillPattern::kQuarterCubic, "quartercubic", true, SolidFillStyle::kNone,
     "Planes inclined to four sides, which enclose tetrahedra and tetrahedra with cut corners"},
    {FillPattern::kCrossZag, "crosszag", true, SolidFillStyle::kNone,
     "Parallel lines that shift from layer to layer by infill_shift_step, in even layers to one "
     "side and in odd layers to the other. A layer's lines lie on the lines two layers below"},
    {FillPattern::kLockedZag, "lockedzag", true, SolidFillStyle::kNone,
     "A skin of crosszag lines along the walls, and a skeleton of lines across them that reaches "
     "into the skin. Each part has a density and a width of its own",
     false},
    {FillPattern::kLateralLattice, "laterallattice", true, SolidFillStyle::kNone,
     "Two families of inclined planes that cross each other, seen from the side as a lattice"},
    {FillPattern::kLateralHoneycomb, "lateralhoneycomb", true, SolidFillStyle::kNone,
     "Honeycomb seen from the side: upright planes that fork and join again"},
};

inline constexpr int kFillPatternCount = std::size(kFillPatterns);

/// Returns the description of a pattern.
constexpr const FillPatternInfo& InfoOf(FillPattern pattern) {
  return kFillPatterns[static_cast<int>(pattern)];
}

/// Returns true if a pattern can have several lines side by side in place of each line. Its lines
/// follow from a formula, and at most two of them meet in a point.
constexpr bool TakesSeveralLines(FillPattern pattern) {
  const FillPatternInfo& info = InfoOf(pattern);
  return info.sparse && info.has_law && !info.planned && pattern != FillPattern::kMedialAxis &&
         pattern != FillPattern::kVoronoi && pattern != FillPattern::kHoneycombCells;
}

/// Returns true for spirals around one point.
constexpr bool IsSpiral(FillPattern pattern) {
  return pattern == FillPattern::kArchimedean || pattern == FillPattern::kOctagram;
}

/// Returns true if the corners of a sparse pattern may be rounded (RoundCorners).
constexpr bool HasSmoothCorners(FillPattern pattern) {
  return pattern == FillPattern::kHilbert || pattern == FillPattern::kOctagram ||
         pattern == FillPattern::kLightning || pattern == FillPattern::kHoneycomb ||
         pattern == FillPattern::kHoneycomb3d || pattern == FillPattern::kConcentric ||
         pattern == FillPattern::kCrosshatch;
}

namespace internal {
constexpr bool InOrder() {
  for (int i = 0; i < kFillPatternCount; ++i)
    if (static_cast<int>(kFillPatterns[i].pattern) != i) return false;
  return true;
}
static_assert(InOrder(), "kFillPatterns has a row for each pattern, in their order");
}  // namespace internal

}  // namespace slicefarm
