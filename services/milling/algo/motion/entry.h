#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/milling/algo/motion/move_builder.h"

namespace slicefarm::milling {

/// Closed pass in mm, without repeating its first point.
using ClosedPath = std::vector<Eigen::Vector2d>;

/// Two quarter circles at the start of a pass: one leads tangentially into the pass, the other
/// leads out of it.
struct LeadArcs {
  Eigen::Vector2d from{0, 0};
  Eigen::Vector2d start{0, 0};
  Eigen::Vector2d to{0, 0};
  Eigen::Vector2d centre{0, 0};
  bool clockwise = false;
};

/// Returns the lead-in and lead-out arcs of a finishing pass, on the side without the part. Returns
/// nullopt if the arcs would leave the area or radius_mm is 0.
std::optional<LeadArcs> LeadArcsOf(const ClosedPath& pass, const PolygonWithHoles& area,
                                   double radius_mm, CutDirection direction);

/// Lowers the tip from its position above a pass's first point to z, in whole loops of a helix on
/// the left side of the pass. Each half loop is one arc. Returns false if the helix would leave the
/// area.
bool HelixDown(const ClosedPath& pass, const PolygonWithHoles& area, double z_mm,
               const MillingOptions& options, MoveBuilder& moves);

/// Lowers the tip from a pass's first point to z in a ramp along the pass, in several rounds if
/// necessary. Returns the pass, beginning at the tip's final position.
ClosedPath RampDown(const ClosedPath& pass, double z_mm, const MillingOptions& options,
                    MoveBuilder& moves);

}  // namespace slicefarm::milling
