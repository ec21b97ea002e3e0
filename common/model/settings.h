#pragma once

#include "common/model/beading_options.h"
#include "common/model/infill_options.h"
#include "common/model/motion_options.h"
#include "common/model/ordering_options.h"
#include "common/model/slicing_options.h"

namespace slicefarm {

/// What a job is to be made with: one struct a stage, complete and validated (common/config does
/// both at the edge).
struct JobSettings {
  SlicingOptions slicing;
  BeadingOptions beading;
  InfillOptions infill;
  OrderingOptions ordering;
  MotionOptions motion;

  friend bool operator==(const JobSettings&, const JobSettings&) = default;
};

/// Neighbours on each side that a layer's result depends on.
int32_t HaloLayers(const JobSettings& settings);

/// Of those, how many the walls depend on.
int32_t BeadingHaloLayers(const JobSettings& settings);

}  // namespace slicefarm
