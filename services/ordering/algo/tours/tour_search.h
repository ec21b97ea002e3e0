#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/array_tour.h"
#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/neighbours.h"
#include "services/ordering/algo/tours/tour_rules.h"
#include "services/ordering/algo/tours/work_budget.h"

namespace slicefarm::ordering {

/// What a length does not tell of an edge.
class Surcharge {
 public:
  virtual ~Surcharge() = default;
  /// At least 0. REQUIRES: symmetric.
  virtual int64_t Of(int32_t a, int32_t b) const = 0;
};

enum class SearchDepth : uint8_t {
  kNone,
  kTwoOptAndOrOpt,  ///< turns of a stretch, shifts of up to three nodes
  kThreeOpt,        ///< also shifts and turns of any length
  kChains,          ///< also chains of these whose first links do not gain (Lin-Kernighan)
};

/// A closed tour that gets shorter and keeps its rules.
///
/// A move takes two or three edges out and puts the stretches between together otherwise. Only
/// moves are tried that bring a node next to one of its near neighbours and that gain from the
/// first edge on; a node whose edges lead to no gain is not looked at again before one of them has
/// changed. When no move gains any more, two neighbouring short stretches change places and all
/// begins again around them; what that does not shorten is undone.
///
/// Deterministic for a seed. Cost: O(1) to judge a move, O(n) to make one, O(rules.before) to see
/// whether it may be made. Sources: S. Lin, B. W. Kernighan, "An Effective Heuristic Algorithm for
/// the Traveling-Salesman Problem", Operations Research 21 (1973); J. L. Bentley, "Fast Algorithms
/// for Geometric Traveling Salesman Problems", ORSA J. Computing 4 (1992): neighbour lists,
/// don't-look bits; D. S. Johnson, L. A. McGeoch, "The Traveling Salesman Problem: a Case Study in
/// Local Optimization" (1997): iterated search with local double bridges; K. Helsgaun, "An
/// Effective Implementation of the Lin-Kernighan Traveling Salesman Heuristic", EJOR 126 (2000):
/// chains whose links are 3-opt moves.
class TourSearch {
 public:
  /// `costs`, `neighbours` and `rules` must outlive the search. REQUIRES: the tour keeps the rules.
  TourSearch(const Costs& costs, const Neighbours& neighbours, const TourRules& rules, Tour tour,
             SearchDepth depth, uint32_t seed);

  /// Makes moves from the nodes that are awake (in the beginning, all) until none gains or the
  /// budget is spent.
  void Improve(WorkBudget& budget);

  /// Exchanges and improves around them, `exchanges` times or until the budget is spent. REQUIRES:
  /// no node is awake.
  void Iterate(int64_t exchanges, WorkBudget& budget);

  /// From now on, `surcharge` counts too (null: no more). It must outlive its use.
  void Charge(const Surcharge* surcharge) { surcharge_ = surcharge; }
  void Wake(int32_t node);

  const Tour& tour() const { return tour_.order(); }
  int64_t gained() const { return gained_; }  ///< since the beginning

 private:
  /// How the first two of three stretches that make up the way from `first` are put together.
  enum class Join : uint8_t { kTurnFirst, kSwapTurned, kSwapTurningFirst, kSwap, kTurnBoth };
  /// Of the way that begins at `first` and goes on all around, forward or backward in memory: the
  /// stretches 0 .. cut1 and cut1 + 1 .. cut2.
  struct Move {
    int64_t gain = 0;
    int64_t open_gain = 0;  ///< without the edge that closes the tour
    int32_t cut1 = 0;
    int32_t cut2 = 0;
    Join join = Join::kTurnFirst;
  };
  /// The tour as a path that begins with the node `first` and ends with the one before it.
  struct Way {
    int32_t first;
    bool forward;
    int32_t start;  ///< position of `first`
  };
  struct Found {
    Move gaining;
    Move opening;  ///< the greatest open_gain
  };

  int64_t Cost(int32_t a, int32_t b) const {
    return surcharge_ == nullptr ? costs_(a, b) : costs_(a, b) + surcharge_->Of(a, b);
  }
  int64_t Cost(int32_t a, const Neighbour& b) const {
    return surcharge_ == nullptr ? b.length : b.length + surcharge_->Of(a, b.node);
  }

  Way WayFrom(int32_t first, bool forward) const {
    return {first, forward, tour_.PositionOf(first)};
  }
  int32_t IndexOf(const Way& way, int32_t node) const {
    const int32_t steps =
        way.forward ? tour_.PositionOf(node) - way.start : way.start - tour_.PositionOf(node);
    return steps < 0 ? steps + tour_.size() : steps;
  }
  int32_t At(const Way& way, int32_t index) const {
    int32_t position = way.forward ? way.start + index : way.start - index;
    if (position >= tour_.size()) position -= tour_.size();
    if (position < 0) position += tour_.size();
    return tour_.At(position);
  }

  int64_t ImproveFrom(int32_t node, WorkBudget& budget);
  int64_t ImproveAlong(Way way, WorkBudget& budget);
  Found Search(const Way& way, int64_t gain, WorkBudget& budget) const;
  void SearchTurned(const Way& way, int32_t cut, int64_t gain, Found& found,
                    WorkBudget& budget) const;
  void SearchSplit(const Way& way, int32_t cut, int64_t gain, Found& found,
                   WorkBudget& budget) const;
  void Judge(const Way& way, const Move& move, Found& found) const;
  bool ShortEnough(const Move& move) const;

  bool Allowed(const Way& way, const Move& move) const;
  /// Makes the move; the way that leads on from the node before `way.first` afterwards.
  Way Make(const Way& way, const Move& move, WorkBudget& budget);
  /// Turns the stretch from index `from` to `to` of the way round.
  Way Turned(const Way& way, int32_t from, int32_t to, WorkBudget& budget);
  void Undo(size_t turns);

  /// Lets two stretches change places: whether that was allowed.
  bool Exchange(WorkBudget& budget, int64_t* gain);
  int32_t Below(int32_t limit);

  const Costs& costs_;
  const Neighbours& neighbours_;
  const TourRules& rules_;
  const FixedEdges fixed_;
  const SearchDepth depth_;
  const Surcharge* surcharge_ = nullptr;
  ArrayTour tour_;
  int64_t gained_ = 0;
  std::mt19937 random_;
  std::vector<Turn> turns_;     ///< what was done since the last exchange
  std::vector<int32_t> queue_;  ///< nodes to look at; a ring
  size_t queue_head_ = 0;
  size_t queue_size_ = 0;
  std::vector<uint8_t> queued_;  ///< by node
};

}  // namespace slicefarm::ordering
