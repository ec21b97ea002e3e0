#pragma once

#include <optional>

#include "services/milling/algo/motion/entry.h"
#include "services/milling/algo/motion/move_builder.h"
#include "services/milling/algo/strategy/level_passes.h"

namespace slicefarm::milling {

/// Cuts the passes of levels' areas, one area after the other. REQUIRES: all areas of higher levels
/// that an area overlaps are cut before it (cut_order.h).
///
/// A pass that meets no stock is left out. A pass begins at its nearest point to the tip. The tip
/// moves straight to this point if the line stays in the area, otherwise by rapid moves above the
/// stock. The tip enters stock by a helix or along the pass; outside the stock it goes straight
/// down. Finishing passes begin and end with arcs if the arcs stay in the area.
class StockCutter {
 public:
  StockCutter(const MillingOptions& options, MoveBuilder& moves, const CancelToken& cancel)
      : options_(options), moves_(moves), cancel_(cancel) {}

  /// Cuts the passes of an area and returns their number. `area` must outlive the next call. After
  /// cancellation nothing is cut, so callers must check the token.
  int Cut(const CutArea& area, double z_mm, MillPhase phase);

 private:
  bool MeetsStock(const ClosedPath& pass, double z_mm) const;
  ClosedPath Approach(ClosedPath pass, const ClosedPath* air, double z_mm, MillPhase phase);
  bool LinkTo(const Eigen::Vector2d& start, double z_mm);
  bool EnterFromAir(const Eigen::Vector2d& start, const ClosedPath& air, double z_mm);
  bool LeadIn(const ClosedPath& pass, double z_mm);
  ClosedPath GoDown(const ClosedPath& pass, double z_mm, MillPhase phase);
  void RapidTo(const Eigen::Vector2d& place, double z_mm);

  const MillingOptions& options_;
  MoveBuilder& moves_;
  const CancelToken& cancel_;
  const PolygonWithHoles* area_ = nullptr;  ///< area being cut
  /// area that was cut last, in which the tip is; null before the first cut
  const PolygonWithHoles* last_ = nullptr;
  std::optional<LeadArcs> leave_;  ///< arcs by which the tip may leave the last pass
};

}  // namespace slicefarm::milling
