#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/milling/algo/motion/move_builder.h"

namespace slicefarm::milling {

/// A closed way in mm, without repeating its first point.
using ClosedWay = std::vector<Eigen::Vector2d>;

/// A quarter of a circle that meets a way tangentially where it starts, and one that leaves it
/// there.
struct LeadArcs {
  Eigen::Vector2d from{0, 0};
  Eigen::Vector2d start{0, 0};
  Eigen::Vector2d to{0, 0};
  Eigen::Vector2d centre{0, 0};
  bool clockwise = false;
};

/// Lead arcs on the free side of a finishing way; empty if they would leave the area.
std::optional<LeadArcs> LeadArcsOf(const ClosedWay& way, const PolygonWithHoles& area,
                                   double radius_mm, CutDirection direction);

/// Takes the tip, which is above a way's first point, down to z in whole and half turns beside it,
/// or tells that the area has no place for a circle there.
bool HelixDown(const ClosedWay& way, const PolygonWithHoles& area, double z_mm,
               const MillingOptions& options, MoveBuilder& moves);

/// Takes the tip, which is at a way's first point, down to z along the way, as often round as it
/// takes. The result is the same way, from where the tip is then.
ClosedWay RampDown(const ClosedWay& way, double z_mm, const MillingOptions& options,
                   MoveBuilder& moves);

}  // namespace slicefarm::milling
