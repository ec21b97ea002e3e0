#pragma once

#include <optional>

#include "services/milling/algo/motion/entry.h"
#include "services/milling/algo/motion/move_builder.h"
#include "services/milling/algo/strategy/level_ways.h"

namespace slicefarm::milling {

/// Cuts the ways of levels' areas, one area after the other. REQUIRES: an area is cut after all
/// that lie above it.
///
/// A way that meets no stock is left out. A way begins nearest to where the tip is; the tip goes
/// straight to it where that stays in the area, else by rapid moves above the stock. Down into
/// stock it goes by a helix or along the way; outside the stock, straight. Finishing ways are met
/// and left by arcs where these are free.
class WayCutter {
 public:
  WayCutter(const MillingOptions& options, MoveBuilder& moves, const CancelToken& cancel)
      : options_(options), moves_(moves), cancel_(cancel) {}

  /// `area` must outlive the next call. The result: how many ways were cut. Once cancelled, none
  /// is: ask the token.
  int Cut(const CutArea& area, double z_mm, MillPhase phase);

 private:
  bool MeetsStock(const ClosedWay& way, double z_mm) const;
  ClosedWay Approach(ClosedWay way, const ClosedWay* air, double z_mm, MillPhase phase);
  bool LinkTo(const Eigen::Vector2d& start, double z_mm);
  bool EnterFromAir(const Eigen::Vector2d& start, const ClosedWay& air, double z_mm);
  bool LeadIn(const ClosedWay& way, double z_mm);
  ClosedWay GoDown(const ClosedWay& way, double z_mm, MillPhase phase);
  void RapidTo(const Eigen::Vector2d& place, double z_mm);

  const MillingOptions& options_;
  MoveBuilder& moves_;
  const CancelToken& cancel_;
  const PolygonWithHoles* area_ = nullptr;  ///< of now
  const PolygonWithHoles* last_ = nullptr;  ///< the one in which the tip is
  std::optional<LeadArcs> leave_;           ///< by which the tip may leave the way that it cut
};

}  // namespace slicefarm::milling
