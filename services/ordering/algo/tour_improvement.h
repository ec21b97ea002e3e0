#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// An order of legs that 2-opt and Or-opt moves shorten.
///
/// The ends of leg k have the numbers 2k (start) and 2k + 1 (end); the journey's fixed ends come
/// after those of the legs. Between the legs at positions i and i + 1 lies a travel. A 2-opt move
/// turns round a run of legs; an Or-opt move takes a run of up to three out and puts it, either way
/// round, between two others. Only moves that bring an end next to one of its near neighbours are
/// tried, and of these only those whose first step gains. When no move gains any more, two runs
/// near each other change places and all starts again around them; what that does not shorten is
/// undone. Source: J. L. Bentley, "Fast Algorithms for Geometric Traveling Salesman Problems", ORSA
/// J. Computing 4 (1992): neighbour lists, don't-look bits; D. S. Johnson, L. A. McGeoch, "The
/// Traveling Salesman Problem: a Case Study in Local Optimization" (1997): iterated search with
/// local double bridges.
class TourImprovement {
 public:
  TourImprovement(const Journey& journey, std::span<const Leg> legs, std::vector<Visit> visits);

  /// Makes moves until none gains, then a number of exchanges in proportion to the legs, or until
  /// the budget is spent.
  void Improve(WorkBudget& budget);

  /// Makes moves that begin at the travels that cross `barrier`, as long as they gain; a crossing
  /// counts as kCrossingNm.
  void AvoidCrossing(const Barrier& barrier, WorkBudget& budget);

  const std::vector<Visit>& visits() const { return visits_; }

 private:
  struct Place {
    double x;
    double y;
  };
  struct Neighbour {
    uint32_t end;
    double distance;
  };
  /// Positions first .. last.
  struct Run {
    int first;
    int last;

    int size() const { return last - first + 1; }
    bool Contains(int position) const { return first <= position && position <= last; }
  };
  /// Puts a run between the positions `after` and `after` + 1, which are outside it or at its
  /// border.
  struct Shift {
    int after;
    bool reversed;
  };

  std::vector<Point> AddEnds(const Journey& journey, std::span<const Leg> legs);
  void FindNeighbours(const std::vector<Point>& ends);
  std::span<const Neighbour> NeighboursOf(uint32_t end) const;

  uint32_t EntryAt(int position) const;  ///< the end's number; that of journey.to past the last
  uint32_t ExitAt(int position) const;  ///< the end's number; that of journey.from before the first
  bool IsExit(uint32_t end) const;      ///< as the legs lie now
  int PositionOf(uint32_t end) const;
  double Distance(uint32_t a, uint32_t b) const;
  /// The distance, and what a crossing costs if that matters by now.
  double Cost(uint32_t a, uint32_t b) const {
    return barrier_ == nullptr ? Distance(a, b) : Distance(a, b) + CrossingCost(a, b);
  }
  double CrossingCost(uint32_t a, uint32_t b) const;
  bool Reversible(Run run) const;

  /// Works through the queue: the gain in nm.
  double ImproveQueued(WorkBudget& budget);
  /// Lets the runs [a, b) and [b, c) change places: the gain in nm, which may be negative.
  double Exchange(int a, int b, int c);
  /// Tries the moves that begin at the leg, and makes the first that gains: the gain in nm, 0 if
  /// none.
  double ImproveLeg(uint32_t leg, WorkBudget& budget);
  double TryTurnAfter(int position, WorkBudget& budget);
  double TryTurnBefore(int position, WorkBudget& budget);
  double TryShift(Run run, WorkBudget& budget);
  /// The shift that brings the run's `head` (else its tail) next to `neighbour`.
  Shift ShiftTo(uint32_t neighbour, bool head) const;
  double ShiftCost(Run run, Shift shift) const;

  void Turn(Run run, WorkBudget& budget);
  void Make(Run run, Shift shift, WorkBudget& budget);
  void Renumber(Run run);
  void Wake(int position);

  int count_;
  const Barrier* barrier_ = nullptr;
  mutable std::unordered_map<uint64_t, bool> parted_;  ///< known answers of the barrier
  bool all_reversible_ = true;
  std::vector<Place> ends_;          ///< by number
  std::vector<uint8_t> reversible_;  ///< by leg
  std::vector<Visit> visits_;        ///< by position
  std::vector<int> position_;        ///< by leg
  std::vector<Neighbour> neighbours_;
  std::vector<uint32_t> neighbour_begin_;  ///< by the end's number, and one more
  std::vector<uint32_t> queue_;            ///< legs to look at; a ring
  size_t queue_head_ = 0;
  size_t queue_size_ = 0;
  std::vector<uint8_t> queued_;  ///< by leg
};

}  // namespace slicefarm::ordering
