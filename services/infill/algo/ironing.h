#pragma once

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {

struct IroningFill {
  double angle_rad = 0;      ///< of the lines that are ironed: ironing runs the same way
  Coord width_nm = 450'000;  ///< of the beads that are ironed
  Coord height_nm = 200'000;
  IroningOptions ironing = {};
};

/// Lines that go over a printed region once more, close together, with `flow` of the plastic that
/// would fill the layer: section of a bead = flow * spacing * height. They end half a spacing
/// before the region's edge, are joined back and forth, and keep their order; ordering prints them
/// after all else of the island.
/// Errors: those of CutLines. Cost: as CutLines.
absl::StatusOr<FillGroup> IronedLines(const MultiPolygon& region, const IroningFill& fill);

}  // namespace slicefarm::infill
