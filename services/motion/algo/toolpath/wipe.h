#pragma once

#include <vector>

#include "common/geometry/arc_fit.h"
#include "common/model/path.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// How the nozzle leaves a path while the filament is pulled back (setting `wipe`).
struct Wipe {
  double speed_mm_s = 0;
  double length_mm = 0;  ///< over which all that is pulled back on the way is; 0: no wipe
};

/// As PrusaSlicer does it: at 0.8 of the travels' speed, so far that the filament has its own.
Wipe WipeOf(const MotionOptions& options);

/// Where the nozzle goes from the end of the path, without that end: along a loop once more, which
/// smears what its seam leaves; back along any other path. It ends after `length_mm`, or with the
/// path. Steps are 0.2 mm at least: shorter edges are cut across, and a shorter rest is left out.
std::vector<PlaceUm> WipeWay(const Path& path, double length_mm);

}  // namespace slicefarm::motion
