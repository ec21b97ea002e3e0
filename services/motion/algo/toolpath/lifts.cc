#include "services/motion/algo/toolpath/lifts.h"

#include "services/motion/algo/toolpath/travel_ramp.h"

namespace slicefarm::motion {

bool LiftsIn(const RetractionOptions& retraction, const LayerFrame& frame) {
  const double z_mm = ToMm(static_cast<double>(frame.print_z_nm));
  return LiftOf(retraction) > 0 && retraction.length_mm > 0 && z_mm >= retraction.lift_above_mm &&
         (retraction.lift_below_mm == 0 || z_mm <= retraction.lift_below_mm);
}

bool RisesAfter(LiftAfter after, bool first_layer, bool top) {
  switch (after) {
    case LiftAfter::kAll:
      return true;
    case LiftAfter::kTop:
      return top;
    case LiftAfter::kBottom:
      return first_layer;
    case LiftAfter::kTopAndBottom:
      return top || first_layer;
  }
  return true;
}

bool LiftsToStart(const RetractionOptions& retraction, const LayerFrame& frame) {
  return LiftsIn(retraction, frame) &&
         RisesAfter(retraction.lift_after, frame.index == 0, /*top=*/false);
}

}  // namespace slicefarm::motion
