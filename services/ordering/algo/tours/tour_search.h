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

/// Extra cost of an edge in addition to its length.
class Surcharge {
 public:
  virtual ~Surcharge() = default;
  /// Returns the extra cost of the edge ab, at least 0. REQUIRES: Of(a, b) == Of(b, a).
  virtual int64_t Of(int32_t a, int32_t b) const = 0;
};

/// Kinds of moves that a search tries. Each value includes the moves of the previous values.
enum class SearchDepth : uint8_t {
  kNone,
  kTwoOptAndOrOpt,  ///< reversals of a section, shifts of up to three nodes
  kThreeOpt,        ///< shifts and reversals of sections of any length
  /// Chains of moves. The first moves of a chain need not have a gain (Lin-Kernighan).
  kChains,
};

/// Local search that shortens a closed tour and keeps its rules.
///
/// A move removes two or three edges and joins the sections between them in another order. The
/// search tries only moves that put a node next to one of its near neighbours. Each partial sum of
/// the gains of a move's edges must be positive. A node without a gaining move is not tried again
/// until one of its edges has changed. When no move gains any more, two short adjacent sections are
/// exchanged, and the search restarts around them. An exchange that does not shorten the tour is
/// undone.
///
/// Deterministic for a seed. Cost: O(1) to judge a move, O(n) to make one (n nodes),
/// O(rules.before) to test whether it is permitted. Sources: S. Lin, B. W. Kernighan, "An Effective
/// Heuristic Algorithm for the Traveling-Salesman Problem", Operations Research 21 (1973); J. L.
/// Bentley, "Fast Algorithms for Geometric Traveling Salesman Problems", ORSA J. Computing 4
/// (1992): neighbour lists, don't-look bits; D. S. Johnson, L. A. McGeoch, "The Traveling Salesman
/// Problem: a Case Study in Local Optimization" (1997): iterated search with local double bridges;
/// K. Helsgaun, "An Effective Implementation of the Lin-Kernighan Traveling Salesman Heuristic",
/// EJOR 126 (2000): chains of links that are 3-opt moves.
class TourSearch {
 public:
  /// Prepares a search from `tour`. `costs`, `neighbours` and `rules` must outlive the search.
  /// REQUIRES: the tour keeps the rules.
  TourSearch(const Costs& costs, const Neighbours& neighbours, const TourRules& rules, Tour tour,
             SearchDepth depth, uint32_t seed);

  /// Makes moves from the awake nodes (Wake) until no move gains or the budget is spent. After
  /// construction, all nodes are awake.
  void Improve(WorkBudget& budget);

  /// Exchanges two short sections and improves the tour around them. Repeats this `exchanges` times
  /// or until the budget is spent. REQUIRES: no node is awake.
  void Iterate(int64_t exchanges, WorkBudget& budget);

  /// Adds `surcharge` to the cost of edges from now on; null removes the surcharge. The surcharge
  /// must outlive its use.
  void Charge(const Surcharge* surcharge) { surcharge_ = surcharge; }
  /// Marks a node as awake, so that Improve tries moves from it.
  void Wake(int32_t node);

  const Tour& tour() const { return tour_.order(); }
  int64_t gained() const { return gained_; }  ///< cost saved since the beginning

 private:
  /// New order and directions of the first two sections of a path. The third section does not
  /// change.
  enum class Join : uint8_t { kTurnFirst, kSwapTurned, kSwapTurningFirst, kSwap, kTurnBoth };
  /// Move on the path from `first` that visits all nodes, forward or backward in memory. The path's
  /// three sections have the indices 0 .. cut1, cut1 + 1 .. cut2, and cut2 + 1 .. n - 1.
  struct Move {
    int64_t gain = 0;
    int64_t open_gain = 0;  ///< gain without the edge that closes the tour
    int32_t cut1 = 0;
    int32_t cut2 = 0;
    Join join = Join::kTurnFirst;
  };
  /// The tour as a path from the node `first` to the node before it.
  struct TourPath {
    int32_t first;
    bool forward;
    int32_t start;  ///< position of `first`
  };
  struct Found {
    Move gaining;
    Move opening;  ///< move with the greatest open_gain
  };

  int64_t Cost(int32_t a, int32_t b) const {
    return surcharge_ == nullptr ? costs_(a, b) : costs_(a, b) + surcharge_->Of(a, b);
  }
  int64_t Cost(int32_t a, const Neighbour& b) const {
    return surcharge_ == nullptr ? b.length : b.length + surcharge_->Of(a, b.node);
  }

  TourPath PathFrom(int32_t first, bool forward) const {
    return {first, forward, tour_.PositionOf(first)};
  }
  int32_t IndexOf(const TourPath& path, int32_t node) const {
    const int32_t steps =
        path.forward ? tour_.PositionOf(node) - path.start : path.start - tour_.PositionOf(node);
    return steps < 0 ? steps + tour_.size() : steps;
  }
  int32_t At(const TourPath& path, int32_t index) const {
    int32_t position = path.forward ? path.start + index : path.start - index;
    if (position >= tour_.size()) position -= tour_.size();
    if (position < 0) position += tour_.size();
    return tour_.At(position);
  }

  int64_t ImproveFrom(int32_t node, WorkBudget& budget);
  int64_t ImproveAlong(TourPath path, WorkBudget& budget);
  Found Search(const TourPath& path, int64_t gain, WorkBudget& budget) const;
  void SearchTurned(const TourPath& path, int32_t cut, int64_t gain, Found& found,
                    WorkBudget& budget) const;
  void SearchSplit(const TourPath& path, int32_t cut, int64_t gain, Found& found,
                   WorkBudget& budget) const;
  void Judge(const TourPath& path, const Move& move, Found& found) const;
  bool ShortEnough(const Move& move) const;

  bool Allowed(const TourPath& path, const Move& move) const;
  /// Makes the move. Returns the new path, on which the next move of a chain is searched: it begins
  /// at the node before `path.first`.
  TourPath Make(const TourPath& path, const Move& move, WorkBudget& budget);
  /// Reverses the nodes from index `from` to index `to` of `path`. Returns the new path. Does
  /// nothing if from >= to.
  TourPath Turned(const TourPath& path, int32_t from, int32_t to, WorkBudget& budget);
  void Undo(size_t turns);

  /// Exchanges two adjacent sections and writes the gain, which may be negative. Returns false if
  /// the exchange is not permitted.
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
  std::vector<Reversal> turns_;  ///< reversals since the last exchange
  std::vector<int32_t> queue_;   ///< awake nodes, in a ring buffer
  size_t queue_head_ = 0;
  size_t queue_size_ = 0;
  std::vector<uint8_t> queued_;  ///< 1 if a node is in the queue, indexed by node
};

}  // namespace slicefarm::ordering
