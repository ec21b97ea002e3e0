#include "services/infill/algo/linking/linked_paths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/covers.h"
#include "common/geometry/edge_index.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/lines/shortened.h"
#include "services/infill/algo/linking/all_links.h"
#include "services/infill/algo/linking/edge_ends.h"
#include "services/infill/algo/linking/inner_ends.h"
#include "services/infill/algo/linking/least_links.h"
#include "services/infill/algo/linking/lifted_ends.h"
#include "services/infill/algo/linking/link_choice.h"
#include "services/infill/algo/linking/near_ends.h"
#include "services/infill/algo/linking/spliced_paths.h"
#include "services/infill/algo/space_filling/ring_links.h"

namespace slicefarm::infill {
namespace {

/// Smallest length of an anchor, in widths. A shorter one does not support the path better than its
/// end does.
constexpr double kLeastAnchor = 1;

bool AreStraight(std::span<const Piece> pieces) {
  return std::ranges::all_of(
      pieces, [](const Piece& piece) { return piece.points.size() == 2 && !piece.closed; });
}

/// Removes the longest links until the total length is within the budget.
Links WithinBudget(const EdgeEnds& ends, Links links, double budget_nm) {
  std::vector<int32_t> linked;
  double length = 0;
  for (const int32_t end : ends.OnEdge()) {
    if (!links[static_cast<size_t>(end)]) continue;
    linked.push_back(end);
    length += ends.SpanLength(end);
  }
  if (length <= budget_nm) return links;
  std::ranges::stable_sort(linked, {}, [&](int32_t end) { return ends.SpanLength(end); });
  for (; !linked.empty() && length > budget_nm; linked.pop_back()) {
    length -= ends.SpanLength(linked.back());
    links[static_cast<size_t>(linked.back())] = false;
  }
  return links;
}

/// Assembly of paths from pieces, links and anchors.
class Assembler {
 public:
  Assembler(const EdgeEnds& ends, const Links& links, const LinkOptions& options)
      : ends_(ends),
        links_(links),
        options_(options),
        done_(static_cast<size_t>(ends.PieceCount()), false) {}

  std::vector<Path> Run() {
    std::vector<Path> paths;
    for (int32_t end = 0; end < ends_.size(); ++end) {
      if (IsDone(end)) continue;
      const Piece& piece = ends_.PieceAt(end / 2);
      if (!piece.closed && LinkedTo(ends_, links_, end) != kNoEnd) continue;
      Keep(piece.closed ? Loop(end) : Follow(end), paths);
    }
    for (int32_t end = 0; end < ends_.size(); ++end)
      if (!IsDone(end)) Keep(FollowRing(end), paths);
    return paths;
  }

 private:
  bool IsDone(int32_t end) const { return done_[static_cast<size_t>(end / 2)]; }

  void Keep(Path path, std::vector<Path>& paths) const {
    path.widths_nm = {options_.width_nm};
    if (path.points.size() >= 2 && PathLength(path) >= options_.min_length_nm)
      paths.push_back(std::move(path));
  }

  Path Loop(int32_t end) {
    done_[static_cast<size_t>(end / 2)] = true;
    Path path;
    path.closed = true;
    path.points = ends_.PieceAt(end / 2).points;
    return path;
  }

  /// Returns the path that begins with a loose end.
  Path Follow(int32_t end) {
    Path path;
    path.points = Anchor(end);
    std::reverse(path.points.begin(), path.points.end());
    Append(Anchor(FollowLinks(end, path)), path);
    return path;
  }

  /// Returns the path of a ring without loose ends.
  Path FollowRing(int32_t end) {
    Path path;
    path.closed = true;
    FollowLinks(end, path);
    if (path.points.back() == path.points.front()) path.points.pop_back();
    return path;
  }

  /// Appends pieces and links from an end until the ring is closed or a loose end is reached.
  /// Returns this end.
  int32_t FollowLinks(int32_t end, Path& path) {
    while (true) {
      done_[static_cast<size_t>(end / 2)] = true;
      const int32_t out = end ^ 1;
      Polyline piece = ends_.PieceAt(end / 2).points;
      if (end % 2 != 0) std::reverse(piece.begin(), piece.end());
      Append(piece, path);
      end = LinkedTo(ends_, links_, out);
      if (end == kNoEnd) return out;
      Append(PathFrom(out, links_[static_cast<size_t>(out)] && ends_.Next(out) == end), path);
      if (IsDone(end)) return out;
    }
  }

  /// Returns the points of the edge part beside an end, beginning at the end.
  Polyline PathFrom(int32_t end, bool forward) const {
    if (forward) return ends_.SpanPoints(end);
    Polyline route = ends_.SpanPoints(ends_.Previous(end));
    std::reverse(route.begin(), route.end());
    return route;
  }

  /// Returns the anchor of a loose end: a path along the boundary that supports the end, in the
  /// direction with more space. The path is empty if there is no space.
  Polyline Anchor(int32_t end) const {
    if (!ends_.IsOnEdge(end) || options_.anchor_nm <= 0) return {};
    const int32_t before = ends_.Previous(end);
    const double ahead = ClearanceFor(end, end, ends_.ClearanceOf(end).ahead_nm, ends_.Next(end));
    const double behind = ClearanceFor(end, before, ends_.ClearanceOf(before).behind_nm, before);
    const double length = std::min(options_.anchor_nm, std::max(ahead, behind));
    if (length < kLeastAnchor * static_cast<double>(options_.width_nm)) return {};
    const Polyline route = PathFrom(end, ahead >= behind);
    const double all = Length(route);
    return Shortened(route, all, 0, all - length);
  }

  /// Returns the length available for an anchor along an edge part, of which `free_nm` are free. If
  /// the edge part's other end is loose too, each anchor gets half of the edge part.
  double ClearanceFor(int32_t end, int32_t span, double free_nm, int32_t neighbour) const {
    if (links_[static_cast<size_t>(span)]) return 0;
    const bool is_shared = neighbour == end || LinkedTo(ends_, links_, neighbour) == kNoEnd;
    const double length = ends_.SpanLength(span);
    return std::min(free_nm, is_shared ? length / 2 : length) -
           static_cast<double>(options_.width_nm);
  }

  static void Append(const Polyline& run, Path& path) {
    for (const Point p : run)
      if (path.points.empty() || path.points.back() != p) path.points.push_back(p);
  }

  const EdgeEnds& ends_;
  const Links& links_;
  const LinkOptions& options_;
  std::vector<bool> done_;  ///< true for pieces already in a path, indexed by piece
};

/// Returns paths with loose ends. The ends are moved near the ends of other paths if this does not
/// increase the number of paths.
std::vector<Path> OpenPaths(const EdgeEnds& ends, const LinkOptions& options) {
  const Links links = WithinBudget(ends, ChooseLinks(ends, options.max_link_nm), options.budget_nm);
  std::vector<Path> paths = Assembler(ends, links, options).Run();
  const Links near =
      WithinBudget(ends, BringEndsTogether(ends, links, options.max_link_nm), options.budget_nm);
  if (near == links) return paths;
  std::vector<Path> nearer = Assembler(ends, near, options).Run();
  return nearer.size() <= paths.size() ? nearer : paths;
}

/// Returns the obstacles of a link across a region: the region's boundary, and the lines as rings
/// without area.
EdgeIndex Fences(const MultiPolygon& region, std::span<const Path> lines, Coord square_nm) {
  MultiPolygon fences = region;
  for (const Path& line : lines) {
    Polygon& ring = fences.emplace_back().outer;
    ring = line.points;
    ring.insert(ring.end(), line.points.rbegin() + 1, line.points.rend() - 1);
  }
  return EdgeIndex(fences, square_nm);
}

/// Returns a small number of paths for lines at even distances: rings, and paths with loose ends.
std::vector<Path> FacingPaths(const MultiPolygon& region, const EdgeEnds& ends,
                              const LinkOptions& options) {
  const Links links = LeastLinks(ends, options.max_link_nm);
  std::vector<Path> paths = Assembler(ends, links, options).Run();
  const auto closed = std::stable_partition(paths.begin(), paths.end(),
                                            [](const Path& path) { return !path.closed; });
  std::vector<StepRing> rings;
  for (auto path = closed; path != paths.end(); ++path)
    rings.push_back({std::move(path->points), 0});
  paths.erase(closed, paths.end());
  const EdgeIndex fences =
      Fences(region, paths, std::max<Coord>(1, std::llround(options.facing_nm)));
  // A link across a bay of the boundary would cross no obstacle, so the link's middle is tested
  // too.
  const auto may_link = [&](Point a, Point b) {
    return !fences.Meets(a, b) && Covers(region, {(a.x + b.x) / 2, (a.y + b.y) / 2});
  };
  for (Polyline& line : LinkRings(rings, options.facing_nm, may_link)) {
    Path& path = paths.emplace_back();
    path.closed = line.size() > 3 && line.front() == line.back();
    if (path.closed) line.pop_back();
    path.points = std::move(line);
    path.widths_nm = {options.width_nm};
  }
  return paths;
}

}  // namespace

std::vector<Path> LinkedPaths(const MultiPolygon& region, std::span<const Piece> pieces,
                              const LinkOptions& options) {
  if (pieces.empty()) return {};
  const bool is_edge_used = options.max_link_nm > 0 || options.anchor_nm > 0;
  if (!is_edge_used || !options.lifts_ends) return OpenPaths(EdgeEnds(region, pieces), options);
  std::vector<Piece> joined;
  if (options.inner.reach_nm > 0) joined = JoinInnerEnds(region, pieces, options.inner);
  const LiftedPieces lifted =
      LiftEnds(region, joined.empty() ? pieces : std::span<const Piece>(joined), options.width_nm);
  EdgeEnds ends(region, lifted.pieces);
  ends.SetTaken(lifted.taken, options.width_nm);
  std::vector<Path> rings;
  const auto margin = static_cast<double>(options.width_nm);
  const bool are_straight = options.max_link_nm > 0 && AreStraight(pieces);
  if (are_straight) {
    const Links links = LinkAllEnds(ends, options.max_link_nm);
    rings = SplicedPaths(Assembler(ends, links, options).Run(), margin);
    if (rings.size() == 1) return rings;
  } else if (options.facing_nm > 0) {
    rings = FacingPaths(region, ends, options);
    if (rings.size() == 1) return rings;
  }
  std::vector<Path> lines = OpenPaths(ends, options);
  if (are_straight && !joined.empty()) lines = SplicedPaths(std::move(lines), margin);
  return !rings.empty() && rings.size() <= lines.size() ? rings : lines;
}

}  // namespace slicefarm::infill
