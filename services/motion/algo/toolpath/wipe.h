#pragma once

#include <vector>

#include "common/geometry/arc_fit.h"
#include "common/model/path.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Movement of the nozzle away from a path while the filament is retracted (setting `wipe`).
struct Wipe {
  double speed_mm_s = 0;
  double length_mm = 0;  ///< length of the movement; 0: no wipe
};

/// Returns the wipe of the settings: its speed is wipe_speed, its length wipe_distance. If
/// wipe_distance is 0, the wipe lasts as long as the retraction at its speed, as in PrusaSlicer.
Wipe WipeOf(const MotionOptions& options);

/// Returns the points of the wipe after the end of the path. Along a loop, the nozzle continues
/// over the loop's beginning, which smears the material at the seam. Along any other path, it goes
/// back. The wipe ends after `length_mm`, or with the path. Steps are at least 0.2 mm: corners of
/// shorter edges are skipped, and a shorter last step is left out. `shift_nm`: distance by which
/// the wipe is shifted to the left of its direction; 0: none. A shifted wipe first moves to the
/// point beside the end of the path.
std::vector<PointUm> WipePath(const Path& path, double length_mm, double shift_nm = 0);

}  // namespace slicefarm::motion
