#include "services/infill/algo/linking/linked_paths.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "common/geometry/edge_index.h"
#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/lines/shortened.h"
#include "services/infill/algo/linking/all_links.h"
#include "services/infill/algo/linking/edge_ends.h"
#include "services/infill/algo/linking/link_choice.h"
#include "services/infill/algo/linking/link_shape.h"
#include "services/infill/algo/linking/near_ends.h"
#include "services/infill/algo/linking/spliced_paths.h"

namespace slicefarm::infill {
namespace {

struct Plan {
  Links links;
  std::vector<LinkShape> shapes;
  double flow = 1;
  double net_nm = 0;
};

double NetOf(const std::vector<LinkShape>& shapes, double flow) {
  return std::accumulate(shapes.begin(), shapes.end(), 0.0,
                         [flow](double sum, const LinkShape& s) { return sum + s.Net(flow); });
}

/// The flow at which the links come to the budget; beyond any where they take nothing.
double FlowFor(const std::vector<LinkShape>& shapes, double budget_nm) {
  const double length = NetOf(shapes, 1) - NetOf(shapes, 0);
  return length > 0 ? (budget_nm - NetOf(shapes, 0)) / length : 1e9;
}

/// Leaves out the links that cost most, until the others come to the budget.
void DropLongest(double budget_nm, Plan& plan) {
  std::stable_sort(plan.shapes.begin(), plan.shapes.end(),
                   [&](const LinkShape& a, const LinkShape& b) {
                     return a.Net(plan.flow) < b.Net(plan.flow);
                   });
  double net = NetOf(plan.shapes, plan.flow);
  while (!plan.shapes.empty() && net > budget_nm && plan.shapes.back().Net(plan.flow) > 0) {
    net -= plan.shapes.back().Net(plan.flow);
    plan.links[static_cast<size_t>(plan.shapes.back().stretch)] = false;
    plan.shapes.pop_back();
  }
}

Plan MakePlan(const EdgeEnds& ends, Links links, const EdgeIndex& edges,
              const LinkOptions& options) {
  Plan plan;
  plan.links = std::move(links);
  for (const double cut : {0.0, options.most_cut_nm / 2, options.most_cut_nm}) {
    plan.shapes = ShapeLinks(ends, plan.links, edges, cut);
    plan.flow = FlowFor(plan.shapes, options.aim_nm);
    if (plan.flow >= options.most_flow || options.most_cut_nm <= 0) break;
  }
  plan.flow = std::clamp(plan.flow, options.least_flow, options.most_flow);
  DropLongest(options.budget_nm, plan);
  plan.net_nm = NetOf(plan.shapes, plan.flow);
  return plan;
}

bool AreStraight(std::span<const Piece> pieces) {
  return std::ranges::all_of(pieces, [](const Piece& piece) {
    return piece.points.size() == 2 && !piece.closed;
  });
}

/// Puts paths together from pieces, links and anchors.
class Assembler {
 public:
  Assembler(const EdgeEnds& ends, const Plan& plan, const LinkOptions& options)
      : ends_(ends),
        plan_(plan),
        options_(options),
        left_nm_(options.aim_nm - plan.net_nm),
        link_of_(static_cast<size_t>(ends.size()), nullptr),
        cut_(static_cast<size_t>(ends.size()), 0),
        done_(static_cast<size_t>(ends.PieceCount()), false) {
    const auto spacing = static_cast<double>(Spacing(options.width_nm, options.height_nm));
    link_width_nm_ = plan.flow == 1 ? options.width_nm
                                    : WidthToFill(std::llround(plan.flow * spacing),
                                                  options.height_nm);
    for (const LinkShape& shape : plan.shapes) {
      const int32_t next = ends.Next(shape.stretch);
      link_of_[static_cast<size_t>(shape.stretch)] = link_of_[static_cast<size_t>(next)] = &shape;
      cut_[static_cast<size_t>(shape.stretch)] = shape.from_cut_nm;
      cut_[static_cast<size_t>(next)] = shape.to_cut_nm;
    }
  }

  std::vector<Path> Run() {
    std::vector<Path> paths;
    for (int32_t end = 0; end < ends_.size(); ++end) {
      if (done_[static_cast<size_t>(end / 2)]) continue;
      const Piece& piece = ends_.PieceAt(end / 2);
      if (!piece.closed && LinkedTo(ends_, plan_.links, end) != kNoEnd) continue;
      Keep(piece.closed ? Loop(end) : Follow(end), paths);
    }
    for (int32_t end = 0; end < ends_.size(); ++end)
      if (!done_[static_cast<size_t>(end / 2)]) Keep(FollowRing(end), paths);
    return paths;
  }

 private:
  Path Loop(int32_t end) {
    done_[static_cast<size_t>(end / 2)] = true;
    Path path;
    path.closed = true;
    path.points = ends_.PieceAt(end / 2).points;
    path.widths_nm = {options_.width_nm};
    return path;
  }

  void Keep(Path path, std::vector<Path>& paths) const {
    if (link_width_nm_ == options_.width_nm) path.widths_nm = {options_.width_nm};
    if (PathLength(path) >= options_.min_length_nm) paths.push_back(std::move(path));
  }

  /// The path that begins with a loose end.
  Path Follow(int32_t end) {
    Path path;
    Polyline anchor = Anchor(end);
    std::reverse(anchor.begin(), anchor.end());
    Append(anchor, link_width_nm_, path);
    Append(Anchor(FollowLinks(end, path)), link_width_nm_, path);
    return path;
  }

  /// The path of a ring without loose ends.
  Path FollowRing(int32_t end) {
    Path path;
    path.closed = true;
    FollowLinks(end, path);
    if (path.points.back() == path.points.front() &&
        path.widths_nm.back() == path.widths_nm.front()) {
      path.points.pop_back();
      path.widths_nm.pop_back();
    }
    return path;
  }

  /// Appends pieces and links from an end on until the ring is closed, or up to a loose end, which
  /// it returns.
  int32_t FollowLinks(int32_t end, Path& path) {
    while (true) {
      done_[static_cast<size_t>(end / 2)] = true;
      const int32_t out = end ^ 1;
      Append(PiecePoints(end), options_.width_nm, path);
      end = LinkedTo(ends_, plan_.links, out);
      if (end == kNoEnd) return out;
      const LinkShape& link = *link_of_[static_cast<size_t>(out)];
      Polyline way = link.way;
      if (link.stretch != out) std::reverse(way.begin(), way.end());
      Append(way, link_width_nm_, path);
      if (done_[static_cast<size_t>(end / 2)]) return out;
    }
  }

  /// A piece from one end to the other, less what its links cut off.
  Polyline PiecePoints(int32_t from) const {
    const int32_t start = from & ~1;
    const Polyline& points = ends_.PieceAt(from / 2).points;
    Polyline left = Shortened(points, Length(points), cut_[static_cast<size_t>(start)],
                              cut_[static_cast<size_t>(start + 1)]);
    if (from % 2 != 0) std::reverse(left.begin(), left.end());
    return left;
  }

  /// The way along the edge by which a loose end is borne, from the end on: half of the longer
  /// stretch beside it at most. Empty where nothing is left for it.
  Polyline Anchor(int32_t end) {
    if (!ends_.IsOnEdge(end) || options_.anchor_nm <= 0) return {};
    const int32_t previous = ends_.Previous(end);
    const auto room = [this](int32_t stretch) {
      return plan_.links[static_cast<size_t>(stretch)] ? 0 : ends_.StretchLength(stretch);
    };
    const bool forward = room(end) >= room(previous);
    const int32_t stretch = forward ? end : previous;
    const double length = std::min(options_.anchor_nm, room(stretch) / 2);
    if (length * plan_.flow > left_nm_ || length < static_cast<double>(options_.width_nm))
      return {};
    left_nm_ -= length * plan_.flow;
    Polyline way = ends_.StretchPoints(stretch);
    if (!forward) std::reverse(way.begin(), way.end());
    const double all = Length(way);
    return Shortened(way, all, 0, all - length);
  }

  /// Appends a run of one width. Points of a path differ from their neighbours, but where the width
  /// steps.
  void Append(const Polyline& run, Coord width_nm, Path& path) const {
    const bool steps = link_width_nm_ != options_.width_nm;
    for (size_t i = 0; i < run.size(); ++i) {
      const bool same = !path.points.empty() && path.points.back() == run[i] &&
                        !(steps && i == 0 && path.widths_nm.back() != width_nm);
      if (same) continue;
      path.points.push_back(run[i]);
      path.widths_nm.push_back(width_nm);
    }
  }

  const EdgeEnds& ends_;
  const Plan& plan_;
  const LinkOptions& options_;
  double left_nm_;
  Coord link_width_nm_;
  std::vector<const LinkShape*> link_of_;  ///< by end
  std::vector<double> cut_;                ///< by end
  std::vector<bool> done_;                 ///< by piece
};

/// Paths with loose ends, which lie near to those of other paths where that costs no path: links
/// may be longer there and come to more than the budget, and dots be joined to what was long
/// enough.
std::vector<Path> OpenPaths(const EdgeEnds& ends, const EdgeIndex& edges,
                            const LinkOptions& options) {
  const Plan plan = MakePlan(ends, ChooseLinks(ends, options.max_link_nm), edges, options);
  std::vector<Path> paths = Assembler(ends, plan, options).Run();
  Links near = BringEndsTogether(ends, plan.links, options.max_link_nm);
  if (near == plan.links) return paths;
  const Plan moved = MakePlan(ends, std::move(near), edges, options);
  std::vector<Path> nearer = Assembler(ends, moved, options).Run();
  return nearer.size() <= paths.size() ? nearer : paths;
}

}  // namespace

std::vector<Path> LinkedPaths(const MultiPolygon& region, std::span<const Piece> pieces,
                              const LinkOptions& options) {
  if (pieces.empty()) return {};
  const EdgeEnds ends(region, pieces);
  const EdgeIndex edges(region, std::max<Coord>(1, std::llround(options.most_cut_nm)));
  std::vector<Path> rings;
  if (options.max_link_nm > 0 && AreStraight(pieces)) {
    const Plan plan = MakePlan(ends, LinkAllEnds(ends, options.max_link_nm), edges, options);
    rings =
        SplicedPaths(Assembler(ends, plan, options).Run(), static_cast<double>(options.width_nm));
    if (rings.size() == 1) return rings;
  }
  std::vector<Path> lines = OpenPaths(ends, edges, options);
  return !rings.empty() && rings.size() <= lines.size() ? rings : lines;
}

}  // namespace slicefarm::infill
