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
};

/// Method by which a pattern fills a solid region.
enum class SolidWay : uint8_t {
  kNone,    ///< no solid fill: the pattern is not allowed in top_fill_pattern and similar settings
  kLines,   ///< straight lines with a spacing fitted to the region
  kCurves,  ///< lines that end at the region's edge
  kAlongEdge,  ///< lines along the region's edge
};

/// Description of a pattern. Settings, help, gallery, benchmarks and tests read this table. The
/// code of each pattern is in services/infill/algo/patterns/.
struct FillPatternInfo {
  FillPattern pattern = FillPattern::kRectilinear;
  std::string_view name;  ///< name in settings: the name in PrusaSlicer if it has the pattern
  bool sparse = false;    ///< true if the pattern is allowed in fill_pattern
  SolidWay solid = SolidWay::kNone;
  std::string_view doc;
  bool has_law = true;   ///< true if the density alone determines the length of the lines exactly
  bool planned = false;  ///< true if services/planning lays out the lines over the whole job
};

inline constexpr FillPatternInfo kFillPatterns[] = {
    {FillPattern::kRectilinear, "rectilinear", true, SolidWay::kLines,
     "Lines that turn by a right angle from layer to layer"},
    {FillPattern::kAlignedRectilinear, "alignedrectilinear", true, SolidWay::kLines,
     "Lines in one direction in all layers"},
    {FillPattern::kLine, "line", true, SolidWay::kNone, "As rectilinear"},
    {FillPattern::kZigzag, "zigzag", true, SolidWay::kLines, "As alignedrectilinear"},
    {FillPattern::kGrid, "grid", true, SolidWay::kNone, "Lines in two directions in each layer"},
    {FillPattern::kTriangles, "triangles", true, SolidWay::kNone,
     "Lines in three directions that meet in points"},
    {FillPattern::kStars, "stars", true, SolidWay::kNone,
     "Lines in three directions, the third between where the others cross: triangles and hexagons"},
    {FillPattern::kCubic, "cubic", true, SolidWay::kNone,
     "Planes of cubes that stand on a corner: three directions that drift with the height"},
    {FillPattern::kHoneycomb, "honeycomb", true, SolidWay::kNone,
     "Hexagons of continuous rows: two beads side by side where rows meet"},
    {FillPattern::kHoneycombCells, "honeycombcells", true, SolidWay::kNone,
     "Hexagons with each wall printed once: stiffest for its plastic, and many paths"},
    {FillPattern::kHoneycomb3d, "3dhoneycomb", true, SolidWay::kNone,
     "Rows of waves whose height grows and shrinks: cells closed on all sides"},
    {FillPattern::kGyroid, "gyroid", true, SolidWay::kNone,
     "A surface as stiff in all directions: sin x cos y + sin y cos z + sin z cos x = 0"},
    {FillPattern::kSchwarzD, "schwarzd", true, SolidWay::kNone,
     "A surface of diamond symmetry: cos x cos y cos z = sin x sin y sin z"},
    {FillPattern::kFischerKochS, "fischerkochs", true, SolidWay::kNone,
     "A surface: cos 2x sin y cos z + cos 2y sin z cos x + cos 2z sin x cos y = 0"},
    {FillPattern::kConcentric, "concentric", true, SolidWay::kAlongEdge,
     "Loops that follow the region's edge"},
    {FillPattern::kArchimedean, "archimedeanchords", true, SolidWay::kCurves,
     "A spiral around the object's middle"},
    {FillPattern::kOctagram, "octagramspiral", true, SolidWay::kCurves,
     "A spiral in the shape of a star of eight points"},
    {FillPattern::kHilbert, "hilbertcurve", true, SolidWay::kCurves,
     "Hilbert's curve: one line of right angles through all cells"},
    {FillPattern::kPeano, "peano", true, SolidWay::kCurves, "Peano's curve: the same by thirds"},
    {FillPattern::kMonotonic, "monotonic", true, SolidWay::kLines,
     "Solid: lines in the order in which they lie, linked; sparse: as rectilinear"},
    {FillPattern::kMonotonicLines, "monotoniclines", true, SolidWay::kLines,
     "Solid: lines in the order in which they lie, not linked; sparse: as rectilinear"},
    {FillPattern::kFermat, "fermat", true, SolidWay::kAlongEdge,
     "Connected Fermat spirals: one path through each region, along its edge", false},
    {FillPattern::kHilbertQuadtree, "hilbertquadtree", true, SolidWay::kAlongEdge,
     "Hilbert's curve inside and loops along the edge: one path through each region", false},
    {FillPattern::kPeanoQuadtree, "peanoquadtree", true, SolidWay::kAlongEdge,
     "Peano's curve in the same way", false},
    {FillPattern::kAdaptiveCubic, "adaptivecubic", true, SolidWay::kNone,
     "Cubic, of cubes that double their size with the distance to the surface", false, true},
    {FillPattern::kSupportCubic, "supportcubic", true, SolidWay::kNone,
     "Cubic, of cubes that double their size with the distance to top surfaces", false, true},
    {FillPattern::kLightning, "lightning", true, SolidWay::kNone,
     "Trees that grow from the walls to where a top surface needs something under it", false, true},
    {FillPattern::kMedialAxis, "medialaxis", true, SolidWay::kNone,
     "Lines at equal distances from the region's medial axis: along its limbs, into its corners"},
    {FillPattern::kVoronoi, "voronoi", true, SolidWay::kNone,
     "Irregular cells of like size: the Voronoi cells of places that Lloyd's method has spread"},
};

inline constexpr int kFillPatternCount = std::size(kFillPatterns);

/// Returns the description of a pattern.
constexpr const FillPatternInfo& InfoOf(FillPattern pattern) {
  return kFillPatterns[static_cast<int>(pattern)];
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
