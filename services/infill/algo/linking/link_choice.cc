#include "services/infill/algo/linking/link_choice.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "common/base/disjoint_sets.h"

namespace slicefarm::infill {
namespace {

/// Number of steps along paths for moving loose ends, per end.
constexpr int64_t kWorkPerEnd = 400;
constexpr int kRounds = 4;
/// Number of times that a growing path may reverse a part of itself.
constexpr int kTurnsOfItself = 8;

enum class Direction { kForward, kBackward };

class Chooser {
 public:
  Chooser(const EdgeEnds& ends, double max_link_nm)
      : ends_(ends), max_link_nm_(max_link_nm), links_(static_cast<size_t>(ends.size()), false) {}

  Links Run() {
    LinkShortestFirst();
    MoveLooseEnds();
    OpenRings();
    return std::move(links_);
  }

 private:
  int32_t Partner(int32_t end) const { return LinkedTo(ends_, links_, end); }
  bool IsLoose(int32_t end) const { return ends_.IsOnEdge(end) && Partner(end) == kNoEnd; }
  int32_t Neighbour(int32_t end, Direction path) const {
    return path == Direction::kForward ? ends_.Next(end) : ends_.Previous(end);
  }
  /// Returns the edge part from an end to its neighbour.
  int32_t SpanTo(int32_t end, Direction path) const {
    return path == Direction::kForward ? end : ends_.Previous(end);
  }

  void LinkShortestFirst() {
    std::vector<int32_t> spans = ends_.OnEdge();
    std::erase_if(spans, [this](int32_t s) {
      return ends_.LinkLength(s) > max_link_nm_ || ends_.Next(s) == s;
    });
    std::stable_sort(spans.begin(), spans.end(), [this](int32_t a, int32_t b) {
      return ends_.LinkLength(a) < ends_.LinkLength(b);
    });
    DisjointSets paths(ends_.PieceCount());
    for (const int32_t span : spans) {
      const int32_t next = ends_.Next(span);
      if (Partner(span) != kNoEnd || Partner(next) != kNoEnd) continue;
      if (paths.Join(span / 2, next / 2)) links_[static_cast<size_t>(span)] = true;
    }
  }

  void MoveLooseEnds() {
    work_left_ = kWorkPerEnd * ends_.size();
    for (int round = 0; round < kRounds; ++round) {
      bool better = false;
      for (const int32_t end : ends_.OnEdge()) {
        for (const Direction path : {Direction::kForward, Direction::kBackward}) {
          if (work_left_ <= 0) return;
          if (IsLoose(end) && Move(end, path)) better = true;
          if (IsLoose(end) && Grow(end, path)) better = true;
        }
      }
      if (!better) return;
    }
  }

  void Flip(int32_t span, std::vector<int32_t>& flipped) {
    links_[static_cast<size_t>(span)] = !links_[static_cast<size_t>(span)];
    flipped.push_back(span);
  }

  /// Reverts all flips except the first `keep`.
  void Undo(const std::vector<int32_t>& flipped, size_t keep) {
    for (size_t i = flipped.size(); i-- > keep;)
      links_[static_cast<size_t>(flipped[i])] = !links_[static_cast<size_t>(flipped[i])];
  }

  /// Grows the path that ends at the loose end `end`, step by step (StepKind), until it joins a
  /// path at a loose end or a ring. Steps before this take pieces from other paths or reverse a
  /// part of the path. Returns true if the number of paths is reduced; otherwise nothing changes.
  bool Grow(int32_t end, Direction first) {
    const int32_t tail = EndOfPath(end);
    const Direction second =
        first == Direction::kForward ? Direction::kBackward : Direction::kForward;
    std::vector<int32_t> flipped;
    int turns_left = kTurnsOfItself;
    while (work_left_ > 0) {
      std::optional<Step> best;
      for (const Direction path : {first, second}) {
        const std::optional<Step> step = StepFrom(end, tail, path);
        if (step && (!best || step->kind < best->kind)) best = step;
      }
      if (!best || (best->kind == StepKind::kTurns && turns_left-- == 0)) break;
      if (best->kind != StepKind::kMeets) Flip(best->lost, flipped);
      Flip(best->made, flipped);
      if (best->kind == StepKind::kMeets || best->kind == StepKind::kOpens) return true;
      end = best->end;
    }
    Undo(flipped, 0);
    return false;
  }

  /// Effect of linking a loose end with a neighbour.
  enum class StepKind {
    kMeets,  ///< the neighbour is loose: two paths become one
    kOpens,  ///< the neighbour is in a ring: ring and path become one
    kTakes,  ///< the neighbour is in another path, and is taken with the rest of that path
    kTurns,  ///< the neighbour is in the same path, and a part of the path is reversed
  };
  struct Step {
    StepKind kind = StepKind::kMeets;
    int32_t made = 0;  ///< edge part that becomes a link
    int32_t lost = 0;  ///< edge part that is no longer a link
    int32_t end = 0;   ///< new end of the path
  };

  /// Returns the step from a loose end, or nothing if the edge part is too long or a ring would
  /// result. `tail`: the path's other end.
  std::optional<Step> StepFrom(int32_t end, int32_t tail, Direction path) {
    const int32_t near = Neighbour(end, path);
    const int32_t made = SpanTo(end, path);
    if (near == end || ends_.LinkLength(made) > max_link_nm_) return std::nullopt;
    const int32_t far = Partner(near);
    if (far == kNoEnd) {
      if (near == tail) return std::nullopt;
      return Step{StepKind::kMeets, made};
    }
    const int32_t lost = SpanTo(near, path);
    for (int32_t at = near;;) {
      --work_left_;
      const int32_t out = at ^ 1;
      if (out == far) return Step{StepKind::kOpens, made, lost};
      if (out == end) return std::nullopt;
      if (out == tail) return Step{StepKind::kTurns, made, lost, far};
      const int32_t next = Partner(out);
      if (next == kNoEnd)
        return ends_.IsOnEdge(out) ? std::optional(Step{StepKind::kTakes, made, lost, out})
                                   : std::nullopt;
      at = next;
    }
  }

  /// Moves a loose end along its ring to the position with the fewest paths. Returns true if the
  /// number of paths is reduced; otherwise nothing changes.
  bool Move(int32_t end, Direction path) {
    std::vector<int32_t> flipped;  // edge parts, in order
    size_t best_flips = 0;
    int paths = 0, fewest = 0;  // differences from the current number
    const int32_t start = end;
    do {
      const int32_t span = SpanTo(end, path);
      const int32_t near = Neighbour(end, path);
      if (near == end || ends_.LinkLength(span) > max_link_nm_) break;
      const int32_t far = Partner(near);
      if (far == kNoEnd) {
        if (EndOfPath(end) == near) break;
        Flip(span, flipped);
        --paths;
      } else {
        paths += ChangeByMoving(end, near, far);
        Flip(SpanTo(near, path), flipped);
        Flip(span, flipped);
      }
      if (paths < fewest) fewest = paths, best_flips = flipped.size();
      if (far == kNoEnd) break;
      end = far;
    } while (end != start && work_left_ > 0);
    Undo(flipped, best_flips);
    return fewest < 0;
  }

  /// Returns the other end of the path that begins with a loose end, or `end` itself in a ring.
  int32_t EndOfPath(int32_t end) {
    for (int32_t at = end;;) {
      --work_left_;
      const int32_t next = Partner(at ^ 1);
      if (next == kNoEnd || next == end) return at ^ 1;
      at = next;
    }
  }

  /// Returns the change of the number of paths when a loose end takes `near` from `far`.
  int ChangeByMoving(int32_t end, int32_t near, int32_t far) {
    for (int32_t at = end;;) {
      --work_left_;
      const int32_t out = at ^ 1;
      if (out == near) return 1;  // the part up to `near` becomes a ring
      if (out == far) return 0;   // reverses the part between
      const int32_t next = Partner(out);
      if (next == kNoEnd) break;
      at = next;
    }
    // The neighbour is in another path, which is cut in two, or in a ring, which is opened.
    for (int32_t at = near;;) {
      --work_left_;
      const int32_t out = at ^ 1;
      if (out == far) return -1;
      const int32_t next = Partner(out);
      if (next == kNoEnd) return 0;
      at = next;
    }
  }

  /// Opens each ring at its longest link.
  void OpenRings() {
    std::vector<bool> seen(static_cast<size_t>(ends_.PieceCount()), false);
    const auto follow = [&](int32_t from, auto visit) {
      for (int32_t at = from;;) {
        seen[static_cast<size_t>(at / 2)] = true;
        const int32_t next = Partner(at ^ 1);
        if (next == kNoEnd) return;
        visit(ends_.Next(at ^ 1) == next && links_[static_cast<size_t>(at ^ 1)] ? (at ^ 1) : next);
        if (next == from) return;
        at = next;
      }
    };
    for (int32_t end = 0; end < ends_.size(); ++end)
      if (Partner(end) == kNoEnd && !seen[static_cast<size_t>(end / 2)])
        follow(end, [](int32_t) {});
    for (int32_t piece = 0; piece < ends_.PieceCount(); ++piece) {
      if (seen[static_cast<size_t>(piece)]) continue;
      int32_t longest = kNoEnd;
      follow(2 * piece, [&](int32_t link) {
        if (longest == kNoEnd || ends_.LinkLength(link) > ends_.LinkLength(longest)) longest = link;
      });
      if (longest != kNoEnd) links_[static_cast<size_t>(longest)] = false;
    }
  }

  const EdgeEnds& ends_;
  const double max_link_nm_;
  Links links_;
  int64_t work_left_ = 0;
};

}  // namespace

int32_t LinkedTo(const EdgeEnds& ends, const Links& links, int32_t end) {
  if (!ends.IsOnEdge(end)) return kNoEnd;
  if (links[static_cast<size_t>(end)]) return ends.Next(end);
  const int32_t previous = ends.Previous(end);
  return links[static_cast<size_t>(previous)] ? previous : kNoEnd;
}

Links ChooseLinks(const EdgeEnds& ends, double max_link_nm) {
  return Chooser(ends, max_link_nm).Run();
}

}  // namespace slicefarm::infill
