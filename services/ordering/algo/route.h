#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "common/model/path.h"
#include "services/ordering/algo/loop_start.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Reverses a path. A closed path keeps its start.
void Reverse(Path& path);

/// Obstacles of an island for two uses: the search for an order, and links (near_links.h). If
/// for_order is null, the search ignores obstacles. If for_links is null, there are no links.
struct RouteEdges {
  const Barrier* for_order = nullptr;
  const Barrier* for_links = nullptr;
  bool whole_loops = false;  ///< true if links do not shorten inner loops
};

/// Paths printed so far, and the position of the nozzle after them.
class Route {
 public:
  /// Starts a route at `entry`. `height_nm`: the layer's height.
  explicit Route(Point entry, Coord height_nm = 0) : at_(entry), height_nm_(height_nm) {}

  Point at() const { return at_; }
  /// Returns the journey (travel_order.h) from the nozzle's position to `next`. Without `next`, the
  /// journey may end anywhere.
  Journey To(std::optional<Point> next = {}) const { return {at_, next, edges_.for_order}; }
  /// Begins an island. The next path is not linked to earlier paths. `edges` must outlive the
  /// printing of the island's paths.
  void Enter(const RouteEdges& edges);
  const std::vector<Path>& paths() const { return paths_; }
  /// Returns the printed paths and leaves the route empty.
  std::vector<Path> TakePaths() { return std::move(paths_); }

  /// Prints a path, preceded by the link from the last path if there is one.
  void Print(Path path, bool reversed = false);
  /// Prints a closed path that starts at `start`.
  void PrintLoop(Path loop, LoopPoint start);

 private:
  bool IsKeptWhole(const Path& next) const;

  Point at_;
  Coord height_nm_;
  RouteEdges edges_;
  bool is_linkable_ = false;  ///< true if the last path belongs to this island
  bool last_is_loop_ = false;
  std::vector<Path> paths_;
};

}  // namespace slicefarm::ordering
