#pragma once

#include "common/geometry/point.h"
#include "common/model/motion_options.h"

namespace slicefarm::motion {

/// Time in s of a travel from rest to rest.
double TravelTime(Point from, Point to, const MotionOptions& options, int32_t layer_index);

/// Time in s of a move straight up or down from rest to rest.
double LiftTime(double height_mm, const MotionOptions& options, int32_t layer_index);

}  // namespace slicefarm::motion
