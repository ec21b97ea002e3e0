#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/beading/algo/beads/island_beads.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm {
struct BeadingOptions;
}  // namespace slicefarm

namespace slicefarm::beading {

/// An island, and the options of its walls. Distances to neighbouring layers also have an
/// influence.
struct IslandKey {
  const BeadingOptions* options = nullptr;  ///< compared by address
  WallPlan plan;
  Coord layer_height_nm = 0;
  PolygonWithHoles outline;

  friend bool operator==(const IslandKey&, const IslandKey&) = default;
};

/// Walls of an island that were made before.
struct KnownIsland {
  IslandBeads beads;
  int32_t plain_islands = 0;  ///< 1 if constant-width walls replaced impossible variable ones
};

/// Memory of the islands of the current layer and the layer before it. In parts with vertical
/// walls, many layers have the same islands. An island is known if its key is the same and if all
/// questions about the neighbouring layers that its walls depended on have the same answers. The
/// result is therefore the same with and without a memo. Not thread-safe.
class IslandMemo {
 public:
  /// Same as CountOptions::deciding_radius, for positions in the plane.
  using RadiusOf = std::function<double(double x, double y, double radius_nm)>;

  /// Returns a function with the answers of `ask`, which notes each answer for the next Keep.
  RadiusOf Noting(RadiusOf ask);

  /// Returns the island if it is known; `ask` answers its questions again. Otherwise returns
  /// nullptr and forgets the answers that were noted: the caller makes the walls and calls Keep.
  /// The result is valid until the next call.
  const KnownIsland* Find(const IslandKey& key, const RadiusOf& ask);
  void Keep(IslandKey key, KnownIsland island);

  /// Forgets the islands that the layer before the current one had and the current one had not.
  void NextLayer();

 private:
  struct Answer {
    double x, y, radius_nm;
    double deciding_nm;
  };
  struct Entry {
    IslandKey key;
    std::vector<Answer> answers;
    KnownIsland island;
  };
  /// Digest of the outline -> islands.
  using Entries = std::unordered_multimap<uint64_t, Entry>;

  static const KnownIsland* FindIn(Entries& entries, const IslandKey& key, const RadiusOf& ask,
                                   Entries& found);

  Entries current_, before_;
  std::vector<Answer> answers_;  ///< answers for the island that is being made
};

}  // namespace slicefarm::beading
