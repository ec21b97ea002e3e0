#pragma once

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {

/// Parameters of the ironing of a region.
struct IroningFill {
  double angle_rad = 0;      ///< direction of the ironed lines; ironing has the same direction
  Coord width_nm = 450'000;  ///< width of the ironed beads
  Coord height_nm = 200'000;
  IroningOptions ironing = {};
};

/// Returns lines that pass over a printed region again, close together, with `flow` of the plastic
/// that would fill the layer: section of a bead = flow * spacing * height. The lines end half a
/// spacing before the region's edge, are joined back and forth, and keep their order. The ordering
/// service prints them after all other paths of the island. Errors: the errors of CutLines. Cost:
/// as CutLines.
absl::StatusOr<FillGroup> IronedLines(const MultiPolygon& region, const IroningFill& fill);

}  // namespace slicefarm::infill
