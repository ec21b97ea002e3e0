#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/lines/level_lines.h"

namespace slicefarm::infill {

/// An edge between two cells. Its second vertex lies in the tile `step_u`, `step_v` tiles aside.
struct TileEdge {
  int32_t from = 0;
  int32_t to = 0;
  int32_t step_u = 0;
  int32_t step_v = 0;
};

/// The edges of cells that cover the plane, of which those of one tile of size 1 x 1 are repeated
/// at each step of (1, 0) and (0, 1). Three edges meet in each vertex.
struct VoronoiTile {
  std::vector<Vector2> vertices;  ///< each once; not all lie within the tile's square
  std::vector<TileEdge> edges;
};

/// The Voronoi cells of `side` x `side` places in a tile, which first lie at random in a square
/// each, and then move `rounds` times to the middle of their cells. The same on each machine.
///
/// Source: S. Lloyd, "Least Squares Quantization in PCM", 1982; Boost.Polygon's Voronoi diagram of
/// points. REQUIRES: side >= 6, so that three cells meet in one vertex at most. Cost: O(rounds n
/// log n), n places: 4 us for each in each round.
VoronoiTile RelaxedCells(int side, int rounds);

}  // namespace slicefarm::infill
