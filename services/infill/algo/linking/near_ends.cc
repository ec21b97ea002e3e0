#include "services/infill/algo/linking/near_ends.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace slicefarm::infill {
namespace {

constexpr size_t kMostPaths = 24;
/// Largest number of links that an end moves past.
constexpr int kReach = 4;

struct PathEnds {
  Point from, to;

  double DistanceTo(const PathEnds& other) const {
    return std::min({Distance(from, other.from), Distance(from, other.to), Distance(to, other.from),
                     Distance(to, other.to)});
  }
};

/// Returns the length of the shortest tree that joins all paths at their ends (Prim's algorithm).
double TreeOf(const std::vector<PathEnds>& paths) {
  double tree = 0;
  std::vector<double> path(paths.size(), std::numeric_limits<double>::max());
  std::vector<char> in_tree(paths.size(), 0);
  size_t last = 0;
  for (size_t count = 1; count < paths.size(); ++count) {
    in_tree[last] = 1;
    size_t nearest = paths.size();
    for (size_t i = 0; i < paths.size(); ++i) {
      if (in_tree[i] != 0) continue;
      path[i] = std::min(path[i], paths[last].DistanceTo(paths[i]));
      if (nearest == paths.size() || path[i] < path[nearest]) nearest = i;
    }
    tree += path[nearest];
    last = nearest;
  }
  return tree;
}

class Mover {
 public:
  Mover(const EdgeEnds& ends, Links links, double max_link_nm)
      : ends_(ends), max_link_nm_(max_link_nm), links_(std::move(links)) {}

  Links Run() {
    std::vector<int32_t> loose;
    for (int32_t end = 0; end < ends_.size(); ++end)
      if (LinkedTo(ends_, links_, end) == kNoEnd) loose.push_back(end);
    if (loose.size() < 4 || loose.size() > 2 * kMostPaths) return std::move(links_);
    least_ = PathsBetween(ends_, links_).value_or(0);
    for (int32_t& end : loose)
      for (const bool forward : {true, false})
        if (ends_.IsOnEdge(end)) end = Moved(end, forward);
    return std::move(links_);
  }

 private:
  /// Moves a loose end to the position, at most kReach links away, at which `least_` becomes
  /// smallest. Returns the end that is then loose.
  int32_t Moved(int32_t end, bool forward) {
    const auto neighbour = [&](int32_t of) {
      return forward ? ends_.Next(of) : ends_.Previous(of);
    };
    const auto span = [&](int32_t of) { return forward ? of : ends_.Previous(of); };
    flipped_.clear();
    size_t keep = 0;
    double longer_nm = 0;  // added length of links
    int32_t best_end = end;
    for (int step = 0; step < kReach; ++step) {
      const int32_t near = neighbour(end);
      if (near == end || ends_.LinkLength(span(end)) > max_link_nm_) break;
      const int32_t far = LinkedTo(ends_, links_, near);
      if (far == kNoEnd || far != neighbour(near)) break;
      longer_nm += ends_.LinkLength(span(end)) - ends_.LinkLength(span(near));
      Flip(span(near));
      Flip(span(end));
      end = far;
      const std::optional<double> routes = PathsBetween(ends_, links_);
      if (!routes || *routes + longer_nm >= least_) continue;
      least_ = *routes + longer_nm;
      best_end = end;
      keep = flipped_.size();
    }
    TakeBack(keep);
    return best_end;
  }

  void Flip(int32_t span) {
    links_[static_cast<size_t>(span)] = !links_[static_cast<size_t>(span)];
    flipped_.push_back(span);
  }

  /// Reverts all flips except the first `keep`.
  void TakeBack(size_t keep) {
    for (; flipped_.size() > keep; flipped_.pop_back()) {
      const auto last = static_cast<size_t>(flipped_.back());
      links_[last] = !links_[last];
    }
  }

  const EdgeEnds& ends_;
  const double max_link_nm_;
  Links links_;
  std::vector<int32_t> flipped_;  ///< flipped edge parts, in order
  double least_ = 0;              ///< smallest sum of path distances and added link lengths
};

}  // namespace

std::optional<double> PathsBetween(const EdgeEnds& ends, const Links& links) {
  std::vector<PathEnds> paths;
  std::vector<char> seen(static_cast<size_t>(ends.PieceCount()), 0);
  int32_t pieces = 0;
  for (int32_t end = 0; end < ends.size(); ++end) {
    if (seen[static_cast<size_t>(end / 2)] != 0 || LinkedTo(ends, links, end) != kNoEnd) continue;
    int32_t out = end;
    for (int32_t at = end; at != kNoEnd; at = LinkedTo(ends, links, out)) {
      seen[static_cast<size_t>(at / 2)] = 1;
      ++pieces;
      out = at ^ 1;
    }
    paths.push_back({ends.PositionOf(end), ends.PositionOf(out)});
  }
  if (pieces < ends.PieceCount()) return std::nullopt;
  return TreeOf(paths);
}

Links BringEndsTogether(const EdgeEnds& ends, Links links, double max_link_nm) {
  return Mover(ends, std::move(links), max_link_nm).Run();
}

}  // namespace slicefarm::infill
