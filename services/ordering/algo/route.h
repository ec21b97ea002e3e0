#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "common/model/path.h"
#include "services/ordering/algo/loop_start.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Turns a path round; a closed one keeps its start.
void Reverse(Path& path);

/// What lies between places of an island, for the two that ask: the search for an order, and links
/// (near_links.h). Null: the asker looks at nothing, and there are no links.
struct RouteEdges {
  const Barrier* for_order = nullptr;
  const Barrier* for_links = nullptr;
  bool whole_loops = false;  ///< no link takes from an inner loop
};

/// The paths printed so far, and where they leave the nozzle.
class Route {
 public:
  /// `height_nm`: of the layer.
  explicit Route(Point entry, Coord height_nm = 0) : at_(entry), height_nm_(height_nm) {}

  Point at() const { return at_; }
  /// From here on.
  Journey To(std::optional<Point> next = {}) const { return {at_, next, edges_.for_order}; }
  /// An island begins, whose edges must outlive its paths' printing: what is printed next is not
  /// linked to what was printed before.
  void Enter(const RouteEdges& edges);
  const std::vector<Path>& paths() const { return paths_; }
  std::vector<Path> TakePaths() { return std::move(paths_); }

  /// Prints a path, and before it the link to it from the last one where there is one.
  void Print(Path path, bool reversed = false);
  void PrintLoop(Path loop, LoopPlace start);

 private:
  bool IsKeptWhole(const Path& next) const;

  Point at_;
  Coord height_nm_;
  RouteEdges edges_;
  bool is_linkable_ = false;  ///< the last path is of this island
  bool last_is_loop_ = false;
  std::vector<Path> paths_;
};

}  // namespace slicefarm::ordering
