#pragma once

#include <cstdint>
#include <vector>

#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Overhang of one layer of the part over the layer below.
struct Overhang {
  /// Area that needs support: farther from the layer below than the threshold (OverhangThreshold),
  /// or enforced. Bridges and blocked areas are excluded.
  MultiPolygon steep;
  /// Area that supports may touch: the underside around `steep`, up to the layer below.
  MultiPolygon contact;

  friend bool operator==(const Overhang&, const Overhang&) = default;
};

/// Returns the distance in nm by which a layer may extend beyond the one below without support.
/// With a threshold angle it is the layers' distance divided by the tangent of the angle. Otherwise
/// it is half a wall's width, or two thirds of a wall's width for branches. For branches each step
/// of a slope needs a row of tips, and slopes between a half and two thirds print well without
/// tips. threshold_overlap replaces both shares.
Coord OverhangThreshold(const SupportOptions& options, Coord height_nm, Coord below_height_nm);

/// Returns the overhang of layer `index` of the part. The first layer has none, because it is on
/// the bed.
///
/// Distances from the layer below are exact to 0.01 mm, with round joins. Overhangs of less than
/// 0.02 mm2 are left out, except for islands that start in the air. If supports are not automatic,
/// only enforced areas count: enforcers, and the lowest enforced_layers layers. In enforced areas
/// an overhang of 0.05 mm is steep. With critical_only only islands in the air and areas connected
/// to a place more than 3 mm beyond the layer below are steep. Cost: a boolean operation for each
/// layer, and an offset if something is steep.
Overhang OverhangOf(const SupportProblem& problem, size_t index, const SupportOptions& options);

/// Replaces the steep area of an overhang by a part of it, and reduces the contact accordingly.
void KeepSteep(const SupportProblem& problem, size_t index, const SupportOptions& options,
               MultiPolygon steep, Overhang& overhang);

/// Returns the islands of layer `index` of the part that do not touch the layer below.
MultiPolygon IslandsInAirOf(const SupportProblem& problem, size_t index);

}  // namespace slicefarm::planning
