#include "services/infill/algo/cells/voronoi_tile.h"

#include <algorithm>
#include <array>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <map>
#include <utility>

#include "common/base/split_mix.h"

namespace slicefarm::infill {
namespace {

/// Size of a tile in the diagram's integers.
constexpr int32_t kTileUnits = 1 << 24;
/// Width of the margin around the tile, in cells, in which copies of the points are added. No cell
/// is wider.
constexpr int kMarginCells = 3;

using CellDiagram = boost::polygon::voronoi_diagram<double>;

struct Site {
  int32_t x = 0;
  int32_t y = 0;
};

/// Point of the tile, or a copy of it in another tile.
struct SiteCopy {
  int32_t site = 0;
  int32_t step_u = 0;
  int32_t step_v = 0;

  bool IsOwn() const { return step_u == 0 && step_v == 0; }
};

int32_t InTile(double units) {
  const auto at = std::llround(units);
  return static_cast<int32_t>((at % kTileUnits + kTileUnits) % kTileUnits);
}

std::vector<Site> RandomSites(int side) {
  SplitMix draws(1);
  std::vector<Site> sites;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const double x = i + draws.Share(), y = j + draws.Share();
      sites.push_back({InTile(x / side * kTileUnits), InTile(y / side * kTileUnits)});
    }
  }
  return sites;
}

/// Voronoi diagram of a tile's points and of their copies around the tile.
struct TiledDiagram {
  std::vector<SiteCopy> copies;
  CellDiagram diagram;

  TiledDiagram(const std::vector<Site>& sites, int side) {
    const int32_t margin = kTileUnits / side * kMarginCells;
    boost::polygon::voronoi_builder<int32_t> builder;
    for (int32_t site = 0; site < static_cast<int32_t>(sites.size()); ++site) {
      for (int32_t u = -1; u <= 1; ++u) {
        for (int32_t v = -1; v <= 1; ++v) {
          const int32_t x = sites[static_cast<size_t>(site)].x + u * kTileUnits;
          const int32_t y = sites[static_cast<size_t>(site)].y + v * kTileUnits;
          if (std::min(x, y) < -margin || std::max(x, y) >= kTileUnits + margin) continue;
          builder.insert_point(x, y);
          copies.push_back({site, u, v});
        }
      }
    }
    builder.construct(&diagram);
  }

  const SiteCopy& CopyOf(const CellDiagram::cell_type& cell) const {
    return copies[cell.source_index()];
  }
};

/// Returns the centroid of a cell.
Site MiddleOf(const CellDiagram::cell_type& cell) {
  double area = 0, x = 0, y = 0;
  const auto* first = cell.incident_edge();
  const double ox = first->vertex0()->x(), oy = first->vertex0()->y();
  for (const auto* edge = first->next(); edge != first; edge = edge->next()) {
    const double ax = edge->vertex0()->x() - ox, ay = edge->vertex0()->y() - oy;
    const double bx = edge->vertex1()->x() - ox, by = edge->vertex1()->y() - oy;
    const double twice = ax * by - ay * bx;
    area += twice, x += twice * (ax + bx), y += twice * (ay + by);
  }
  return {InTile(ox + x / (3 * area)), InTile(oy + y / (3 * area))};
}

std::vector<Site> Relaxed(const std::vector<Site>& sites, int side) {
  const TiledDiagram tiled(sites, side);
  std::vector<Site> moved(sites.size());
  for (const auto& cell : tiled.diagram.cells()) {
    const SiteCopy& copy = tiled.CopyOf(cell);
    if (copy.IsOwn()) moved[static_cast<size_t>(copy.site)] = MiddleOf(cell);
  }
  return moved;
}

/// Numbers of the vertices of a diagram. The three points around a vertex identify it, so copies of
/// a vertex have the same number. The offset of a vertex in tiles is the offset of the first of
/// these points.
class Vertices {
 public:
  struct Named {
    int32_t number = 0;
    int32_t step_u = 0;
    int32_t step_v = 0;
  };

  explicit Vertices(const TiledDiagram& tiled) : tiled_(tiled) {}

  Named NameOf(const CellDiagram::vertex_type& vertex) {
    std::array<SiteCopy, 3> around;
    const auto* edge = vertex.incident_edge();
    for (SiteCopy& copy : around) {
      copy = tiled_.CopyOf(*edge->cell());
      edge = edge->rot_next();
    }
    std::ranges::sort(around, {}, &SiteCopy::site);
    const SiteCopy& first = around[0];
    const auto [at, is_new] = numbers_.try_emplace({first.site, around[1].site, around[2].site},
                                                   static_cast<int32_t>(places_.size()));
    if (is_new)
      places_.push_back(
          {vertex.x() / kTileUnits - first.step_u, vertex.y() / kTileUnits - first.step_v});
    return {at->second, first.step_u, first.step_v};
  }

  std::vector<Vector2> TakePlaces() { return std::move(places_); }

 private:
  const TiledDiagram& tiled_;
  std::map<std::array<int32_t, 3>, int32_t> numbers_;
  std::vector<Vector2> places_;
};

}  // namespace

VoronoiTile RelaxedCells(int side, int rounds) {
  std::vector<Site> sites = RandomSites(side);
  for (int round = 0; round < rounds; ++round) sites = Relaxed(sites, side);
  const TiledDiagram tiled(sites, side);
  VoronoiTile tile;
  Vertices vertices(tiled);
  for (const auto& cell : tiled.diagram.cells()) {
    const SiteCopy& own = tiled.CopyOf(cell);
    if (!own.IsOwn()) continue;
    const auto* edge = cell.incident_edge();
    do {
      if (tiled.CopyOf(*edge->twin()->cell()).site > own.site) {
        const auto from = vertices.NameOf(*edge->vertex0()), to = vertices.NameOf(*edge->vertex1());
        tile.edges.push_back(
            {from.number, to.number, to.step_u - from.step_u, to.step_v - from.step_v});
      }
      edge = edge->next();
    } while (edge != cell.incident_edge());
  }
  tile.vertices = vertices.TakePlaces();
  return tile;
}

}  // namespace slicefarm::infill
