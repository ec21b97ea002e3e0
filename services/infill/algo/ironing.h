#pragma once

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {

/// Parameters of the ironing of a region.
struct IroningFill {
  /// Direction of the ironed solid lines. The ironing lines have it too, if the options do not turn
  /// them.
  double angle_rad = 0;
  Coord width_nm = 450'000;  ///< width of the beads that are ironed
  Coord height_nm = 200'000;
  IroningOptions ironing = {};
};

/// Returns lines that pass over a printed region again, close together, with `flow` of the plastic
/// that would fill the layer: section of a bead = flow * spacing * height. The lines end half a
/// spacing inside the region's boundary and are joined back and forth, or are loops along it, from
/// the outside to the inside. The group keeps its order.
/// The ordering service prints it after all other paths of the island. Errors: REQUEST_TOO_LARGE
/// (see CutLines and CheckRingSpacing). Cost: the cost of CutLines, or an offset for each loop.
absl::StatusOr<FillGroup> IronedLines(const MultiPolygon& region, const IroningFill& fill);

}  // namespace slicefarm::infill
