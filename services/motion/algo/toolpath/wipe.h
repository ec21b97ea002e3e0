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

/// Returns the wipe: at wipe_speed, with the length wipe_distance; without this setting, with the
/// length that the retraction speed needs, as in PrusaSlicer.
Wipe WipeOf(const MotionOptions& options);

/// Returns the points of the wipe after the end of the path. A loop is followed once more, which
/// smears the material at its seam. Any other path is followed back. The wipe ends after
/// `length_mm`, or with the path. Steps are at least 0.2 mm: corners of shorter edges are skipped,
/// and a shorter last step is left out.
std::vector<PlaceUm> WipePath(const Path& path, double length_mm);

}  // namespace slicefarm::motion
