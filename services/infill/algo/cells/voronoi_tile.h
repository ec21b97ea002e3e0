#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/lines/level_lines.h"

namespace slicefarm::infill {

/// Edge between two cells. `from` and `to` are indices of vertices. The second vertex is in the
/// tile with the offset `step_u`, `step_v`, counted in tiles.
struct TileEdge {
  int32_t from = 0;
  int32_t to = 0;
  int32_t step_u = 0;
  int32_t step_v = 0;
};

/// Edges of cells that cover the plane. The tile is 1 x 1 in size and repeats at each step of (1,
/// 0) and (0, 1). Three edges meet in each vertex.
struct VoronoiTile {
  /// each vertex once; some are outside of the square from (0, 0) to (1, 1)
  std::vector<Vector2> vertices;
  std::vector<TileEdge> edges;
};

/// Returns the Voronoi cells of `side` x `side` points in a tile. Each point starts at a random
/// position in its own square of the tile. It is then moved `rounds` times to the centroid of its
/// cell. The result is the same on each machine.
///
/// Source: S. Lloyd, "Least Squares Quantization in PCM", 1982; Boost.Polygon's Voronoi diagram of
/// points. REQUIRES: side >= 6, so that three cells meet in at most one vertex. Cost: O(rounds n
/// log n), n points: 4 us for each point in each round.
VoronoiTile RelaxedCells(int side, int rounds);

}  // namespace slicefarm::infill
