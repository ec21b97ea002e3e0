#include "services/beading/algo/arachne/variable_walls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/skeleton/boundary.h"
#include "common/geometry/skeleton/skeletal_graph.h"
#include "services/beading/algo/arachne/bead_counts.h"
#include "services/beading/algo/arachne/bead_tracing.h"
#include "services/beading/algo/arachne/beading_field.h"
#include "services/beading/algo/skeleton/centrality.h"

namespace slicefarm::beading {
namespace {

/// Inset in nm that removes parts of an outline narrower than twice this distance. It is used only
/// if the outline cannot be used unchanged.
constexpr Coord kOpenNm = 1'500;
/// Length limit of chords. With longer chords, a bead's width changes at wrong positions.
constexpr double kMaxChordNm = 200'000;

SkeletalOptions ForGraph(const VariableWallOptions& options) {
  return {.tolerance_nm = static_cast<double>(options.chord_tolerance_nm),
          .step_nm = kMaxChordNm,
          .transition_angle = options.transition_angle};
}

std::optional<SkeletalGraph> MakeGraph(const PolygonWithHoles& island,
                                       const SkeletalOptions& options) {
  // The coarser grid has fewer edges that are almost but not exactly parallel; these edges make a
  // diagram imprecise. The finer grid preserves the shape of small details.
  for (const Coord unit_nm : {Coord{1'000}, Coord{1}}) {
    const std::optional<Boundary> boundary = MakeBoundary(island, unit_nm);
    if (!boundary) continue;
    std::optional<SkeletalGraph> graph = MakeSkeletalGraph(*boundary, options);
    if (graph) return graph;
  }
  return std::nullopt;
}

std::optional<std::vector<SkeletalGraph>> MakeGraphs(const MultiPolygon& islands,
                                                     const SkeletalOptions& options) {
  std::vector<SkeletalGraph> graphs;
  for (const PolygonWithHoles& island : islands) {
    std::optional<SkeletalGraph> graph = MakeGraph(island, options);
    if (!graph) return std::nullopt;
    graphs.push_back(*std::move(graph));
  }
  return graphs;
}

CountOptions ForCounts(const VariableWallOptions& options, Point origin) {
  CountOptions counts;
  counts.filter_deviation_nm = static_cast<double>(options.filter_deviation_nm);
  if (options.deciding_radius) {
    counts.deciding_radius = [&options, origin](Vector2 place, double radius_nm) {
      return options.deciding_radius(static_cast<double>(origin.x) + place.x(),
                                     static_cast<double>(origin.y) + place.y(), radius_nm);
    };
  }
  return counts;
}

ThickLine AsThickLine(const BeadLine& line, Point origin) {
  ThickLine rounded;
  rounded.closed = line.closed;
  for (const BeadPoint& point : line.points) {
    const Point place = {origin.x + std::llround(point.place.x()),
                         origin.y + std::llround(point.place.y())};
    rounded.points.push_back(place);
    rounded.thickness_nm.push_back(std::llround(point.width));
  }
  return rounded;
}

void AddBeads(SkeletalGraph graph, const BeadingStrategy& strategy,
              const VariableWallOptions& options, VariableWalls& walls,
              std::vector<Polygon>& markers) {
  std::vector<char> central = CentralEdges(
      graph, {.transition_angle = options.transition_angle,
              .min_radius_nm = static_cast<double>(strategy.TransitionThickness(0)) / 2});
  std::vector<BeadCount> counts =
      PlanBeadCounts(strategy, ForCounts(options, graph.origin), graph, central);
  const std::vector<NodeBeading> field = BeadingField(
      strategy, static_cast<double>(options.transition_length_nm), graph, counts, central);
  for (const BeadLine& line :
       TraceBeads(graph, central, field, {static_cast<double>(options.min_middle_width_nm)})) {
    ThickLine bead = SimplifyThickLine(AsThickLine(line, graph.origin), options.tolerance_nm);
    if (line.is_marker) {
      if (bead.points.size() >= 3) markers.push_back(std::move(bead.points));
    } else if (bead.points.size() >= 2) {
      // Traced beads have their ring on the left, but walls need it on the right.
      if (bead.closed && !line.is_middle) Reverse(bead);
      walls.lines.push_back({line.inset, line.is_middle, std::move(bead)});
    }
  }
}

}  // namespace

std::optional<std::vector<SkeletalGraph>> MakeSkeletons(const PolygonWithHoles& island,
                                                        const VariableWallOptions& options) {
  const SkeletalOptions for_graph = ForGraph(options);
  auto graphs = MakeGraphs({island}, for_graph);
  return graphs ? std::move(graphs) : MakeGraphs(Offset({island}, -kOpenNm), for_graph);
}

VariableWalls WallsAlong(std::vector<SkeletalGraph> skeletons, const BeadingStrategy& strategy,
                         const VariableWallOptions& options) {
  VariableWalls walls;
  std::vector<Polygon> markers;
  for (SkeletalGraph& graph : skeletons)
    AddBeads(std::move(graph), strategy, options, walls, markers);
  if (!markers.empty()) walls.fill_area = Union(markers, FillRule::kEvenOdd);
  return walls;
}

std::optional<VariableWalls> MakeVariableWalls(const PolygonWithHoles& island,
                                               const BeadingStrategy& strategy,
                                               const VariableWallOptions& options) {
  auto skeletons = MakeSkeletons(island, options);
  if (!skeletons) return std::nullopt;
  return WallsAlong(*std::move(skeletons), strategy, options);
}

}  // namespace slicefarm::beading
