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

/// The paths printed so far, and where they leave the nozzle.
class Route {
 public:
  explicit Route(Point entry) : at_(entry) {}

  Point at() const { return at_; }
  /// From here on.
  Journey To(std::optional<Point> next = {}) const { return {at_, next, barrier_}; }
  /// What lies between places from here on; must outlive its use. None: nullptr.
  void Set(const Barrier* barrier) { barrier_ = barrier; }
  const std::vector<Path>& paths() const { return paths_; }
  std::vector<Path> TakePaths() { return std::move(paths_); }

  void Print(Path path, bool reversed = false);
  void PrintLoop(Path loop, LoopPlace start);

 private:
  Point at_;
  const Barrier* barrier_ = nullptr;
  std::vector<Path> paths_;
};

}  // namespace slicefarm::ordering
