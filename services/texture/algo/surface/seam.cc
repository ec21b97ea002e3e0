#include "services/texture/algo/surface/seam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "common/base/disjoint_sets.h"

namespace slicefarm::texture {
namespace {

constexpr int kRootsTried = 8;  // roots tried for the loops around handles
constexpr size_t kMostExtremities = 8;
constexpr double kExtremityShare = 0.5;  // least distance from the seam, relative to the first one

struct Edge {
  SeamEdge ends;
  double length = 0;
  std::array<int32_t, 2> triangles = {-1, -1};
};

/// Edges of the surface, and the edges at each vertex.
struct EdgeGraph {
  std::vector<Edge> edges;
  std::vector<std::vector<int32_t>> at;  ///< edges at each vertex
};

EdgeGraph GraphOf(const SurfaceMesh& mesh) {
  struct Side {
    SeamEdge ends;
    int32_t triangle = 0;
  };
  std::vector<Side> sides;
  for (int32_t t = 0; t < static_cast<int32_t>(mesh.triangles.size()); ++t) {
    const auto& corners = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      sides.push_back({{low, high}, t});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.ends, a.triangle) < std::pair(b.ends, b.triangle);
  });
  EdgeGraph graph;
  graph.at.resize(mesh.points_mm.size());
  for (const Side& side : sides) {
    if (!graph.edges.empty() && graph.edges.back().ends == side.ends) {
      graph.edges.back().triangles[1] = side.triangle;
      continue;
    }
    const auto [a, b] = side.ends;
    for (const int32_t vertex : side.ends)
      graph.at[vertex].push_back(static_cast<int32_t>(graph.edges.size()));
    graph.edges.push_back(
        {side.ends, (mesh.points_mm[a] - mesh.points_mm[b]).norm(), {side.triangle, -1}});
  }
  return graph;
}

/// Shortest paths along edges to the nearest of several source vertices.
struct ShortestPaths {
  std::vector<double> distance;
  /// Next edge towards the source; -1 for a source, or if no source is reachable.
  std::vector<int32_t> edge;

  /// Returns the edges from a vertex to its source.
  std::vector<int32_t> PathFrom(const EdgeGraph& graph, int32_t vertex) const {
    std::vector<int32_t> path;
    while (edge[vertex] >= 0) {
      path.push_back(edge[vertex]);
      const SeamEdge& ends = graph.edges[edge[vertex]].ends;
      vertex = ends[0] == vertex ? ends[1] : ends[0];
    }
    return path;
  }
};

/// Runs Dijkstra's algorithm from the sources. Of two paths with equal length, it chooses the path
/// over the vertex with the lower index.
ShortestPaths PathsTo(const EdgeGraph& graph, const std::vector<int32_t>& sources) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  ShortestPaths paths{.distance = std::vector<double>(graph.at.size(), kFar),
                      .edge = std::vector<int32_t>(graph.at.size(), -1)};
  using Entry = std::pair<double, int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const int32_t source : sources) {
    paths.distance[source] = 0;
    open.emplace(0, source);
  }
  while (!open.empty()) {
    const auto [distance, vertex] = open.top();
    open.pop();
    if (distance > paths.distance[vertex]) continue;
    for (const int32_t e : graph.at[vertex]) {
      const SeamEdge& ends = graph.edges[e].ends;
      const int32_t other = ends[0] == vertex ? ends[1] : ends[0];
      const double there = distance + graph.edges[e].length;
      if (there >= paths.distance[other]) continue;
      paths.distance[other] = there;
      paths.edge[other] = e;
      open.emplace(there, other);
    }
  }
  return paths;
}

int32_t Farthest(const ShortestPaths& paths) {
  int32_t farthest = 0;
  double most = -1;
  for (int32_t v = 0; v < static_cast<int32_t>(paths.distance.size()); ++v) {
    if (std::isfinite(paths.distance[v]) && paths.distance[v] > most) {
      most = paths.distance[v];
      farthest = v;
    }
  }
  return farthest;
}

/// Returns shortest paths between points that are far from each other.
std::vector<int32_t> SeamBetweenExtremities(const SurfaceMesh& mesh, const EdgeGraph& graph) {
  const int32_t first = Farthest(PathsTo(graph, {mesh.triangles[0][0]}));
  std::vector<int32_t> seam, reached = {first};
  double span = 0;
  for (size_t i = 1; i < kMostExtremities; ++i) {
    const ShortestPaths paths = PathsTo(graph, reached);
    const int32_t next = Farthest(paths);
    if (i == 1) span = paths.distance[next];
    if (paths.distance[next] < kExtremityShare * span) break;
    for (const int32_t e : paths.PathFrom(graph, next)) {
      seam.push_back(e);
      for (const int32_t vertex : graph.edges[e].ends) reached.push_back(vertex);
    }
  }
  return seam;
}

/// Returns two edges for each handle: the edges that are neither in the tree of shortest paths nor
/// crossed by a spanning tree of the faces. The spanning tree prefers edges that close the longest
/// loops.
std::vector<int32_t> LoopEdges(const SurfaceMesh& mesh, const EdgeGraph& graph,
                               const SurfaceTopology& topology, const ShortestPaths& paths) {
  std::vector<bool> in_tree(graph.edges.size(), false);
  for (const int32_t e : paths.edge) {
    if (e >= 0) in_tree[e] = true;
  }
  // A hole counts as an additional face. It is added to the tree last, because the surface must be
  // connected without it.
  const auto faces = static_cast<int32_t>(mesh.triangles.size());
  std::vector<int32_t> hole_of(mesh.points_mm.size(), -1);
  for (size_t i = 0; i < topology.loops.size(); ++i) {
    for (const int32_t vertex : topology.loops[i])
      hole_of[vertex] = faces + static_cast<int32_t>(i);
  }
  struct Crossing {
    bool of_hole = false;
    double loop = 0;  ///< length of the loop through the root
    int32_t edge = 0;
  };
  std::vector<Crossing> crossings;
  for (int32_t e = 0; e < static_cast<int32_t>(graph.edges.size()); ++e) {
    if (in_tree[e]) continue;
    const Edge& edge = graph.edges[e];
    crossings.push_back({edge.triangles[1] < 0,
                         paths.distance[edge.ends[0]] + paths.distance[edge.ends[1]] + edge.length,
                         e});
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tuple(a.of_hole, -a.loop, a.edge) < std::tuple(b.of_hole, -b.loop, b.edge);
  });
  DisjointSets joined(faces + static_cast<int32_t>(topology.loops.size()));
  std::vector<int32_t> left;
  for (const Crossing& crossing : crossings) {
    const Edge& edge = graph.edges[crossing.edge];
    const int32_t other = crossing.of_hole ? hole_of[edge.ends[0]] : edge.triangles[1];
    if (!joined.Join(edge.triangles[0], other)) left.push_back(crossing.edge);
  }
  return left;
}

/// Removes edges of the seam that lead to a free end.
void Prune(const EdgeGraph& graph, std::vector<int32_t>* seam) {
  std::sort(seam->begin(), seam->end());
  seam->erase(std::unique(seam->begin(), seam->end()), seam->end());
  std::vector<int32_t> degree(graph.at.size(), 0);
  for (const int32_t e : *seam) {
    for (const int32_t vertex : graph.edges[e].ends) ++degree[vertex];
  }
  for (size_t before = seam->size() + 1; seam->size() < before;) {
    before = seam->size();
    std::erase_if(*seam, [&](int32_t e) {
      const auto [a, b] = graph.edges[e].ends;
      if (degree[a] > 1 && degree[b] > 1) return false;
      --degree[a];
      --degree[b];
      return true;
    });
  }
}

double LengthOf(const EdgeGraph& graph, const std::vector<int32_t>& seam) {
  double length = 0;
  for (const int32_t e : seam) length += graph.edges[e].length;
  return length;
}

std::vector<int32_t> SeamAroundHandles(const SurfaceMesh& mesh, const EdgeGraph& graph,
                                       const SurfaceTopology& topology) {
  std::vector<int32_t> best, roots = {mesh.triangles[0][0]};
  for (int i = 0; i < kRootsTried; ++i) {
    const ShortestPaths paths = PathsTo(graph, {roots.back()});
    std::vector<int32_t> seam;
    for (const int32_t e : LoopEdges(mesh, graph, topology, paths)) {
      seam.push_back(e);
      for (const int32_t end : graph.edges[e].ends) {
        for (const int32_t on_way : paths.PathFrom(graph, end)) seam.push_back(on_way);
      }
    }
    Prune(graph, &seam);
    if (i == 0 || LengthOf(graph, seam) < LengthOf(graph, best)) best = std::move(seam);
    roots.push_back(Farthest(PathsTo(graph, roots)));
  }
  return best;
}

}  // namespace

std::vector<SeamEdge> SeamOf(const SurfaceMesh& mesh, const SurfaceTopology& topology) {
  if (topology.handles == 0 && !topology.loops.empty()) return {};
  const EdgeGraph graph = GraphOf(mesh);
  std::vector<SeamEdge> seam;
  for (const int32_t e : topology.handles > 0 ? SeamAroundHandles(mesh, graph, topology)
                                              : SeamBetweenExtremities(mesh, graph))
    seam.push_back(graph.edges[e].ends);
  std::sort(seam.begin(), seam.end());
  return seam;
}

}  // namespace slicefarm::texture
