#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/model/job_facts.h"
#include "common/model/layers/filament_use.h"
#include "services/coordinator/algo/pipeline/cost.h"

namespace slicefarm::coordinator {

/// Part of a print: time in s, and filament.
struct PrintShare {
  double time_s = 0;
  FilamentUse filament;

  friend bool operator==(const PrintShare&, const PrintShare&) = default;
};

/// Shares of the copies of one object.
struct ObjectShares {
  std::string name;
  std::vector<PrintShare> copies;

  /// Returns the sum over the copies.
  PrintShare Total() const;
  friend bool operator==(const ObjectShares&, const ObjectShares&) = default;
};

/// Division of a print into shares of copies and a shared rest.
///
/// A copy owns its beads, its supports, a brim and a raft of its own, the travels within the copy,
/// and its retractions and wipes. All else is shared: the text before and after the layers with its
/// heating, travels from one copy to another, and structures of the plate such as skirts.
///
/// The sum of all shares equals the total of the print as doubles, in any order of addition: shares
/// of copies are multiples of 2^-20, and `shared` is the exact remainder.
struct PrintShares {
  std::vector<ObjectShares> objects;  ///< objects in the order of the job; empty: no division
  PrintShare shared;

  friend bool operator==(const PrintShares&, const PrintShares&) = default;
};

/// Returns the division of a print. `names` and `shares`: one per copy. A sum of shares above the
/// total, which only rounding can cause, is taken from the largest share. Cost: O(copies).
/// REQUIRES: amounts are at least 0 and below 2^32.
PrintShares DividePrint(std::span<const CopyName> names, std::vector<PrintShare> shares,
                        const PrintShare& total);

/// Division of a cost, with one cost per copy in the order of PrintShares.
struct CostShares {
  std::vector<Cost> copies;
  Cost shared;              ///< remainder of each item; contains the whole setup
  double shared_total = 0;  ///< exact remainder of the total

  friend bool operator==(const CostShares&, const CostShares&) = default;
};

/// Returns the division of a cost: machine and energy by time, filament by mass. The sums are equal
/// to the cost, as in PrintShares.
CostShares DivideCost(const Cost& cost, const PrintShares& shares, const PrintShare& total);

}  // namespace slicefarm::coordinator
