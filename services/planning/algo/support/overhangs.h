#pragma once

#include <cstdint>
#include <vector>

#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// What hangs over the layer below, in one layer of the part.
struct Overhang {
  /// What has to be carried: farther from the layer below than the threshold, or enforced; no
  /// bridges, nothing blocked.
  MultiPolygon steep;
  /// What supports lie against: the underside around `steep`, up to the layer below.
  MultiPolygon contact;

  friend bool operator==(const Overhang&, const Overhang&) = default;
};

/// How far a layer may reach beyond the one below without support, nm: of a threshold, the layers'
/// distance over its tangent; else half a wall, or two thirds of it for branches: each step of a slope
/// takes a row of tips, and slopes between the two print well without.
Coord OverhangThreshold(const SupportOptions& options, Coord height_nm, Coord below_height_nm);

/// The overhangs of layer `index`; none of the first, which lies on the bed.
///
/// Distances from the layer below are true ones (round joins, exact to 0.01 mm). Overhangs of less
/// than 0.02 mm2 are left out, islands that start in the air never. Where supports are not
/// automatic only enforced places count. Enforced are: enforcers, and the lowest enforced_layers;
/// there half a tenth of a millimetre is steep.
/// Cost: a boolean operation for each layer, an offset where something is steep.
Overhang OverhangOf(const SupportProblem& problem, size_t index, const SupportOptions& options);

/// The islands of layer `index` that do not touch the layer below.
MultiPolygon IslandsInAirOf(const SupportProblem& problem, size_t index);

}  // namespace slicefarm::planning
