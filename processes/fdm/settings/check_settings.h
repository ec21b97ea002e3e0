#pragma once

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config::fdm {

/// What settings ask of each other, once derived (derive.h): layers no higher than the nozzle is
/// wide, beads at least as wide as their layer is high and narrower than three nozzles
/// (PrusaSlicer's rules), a speed for retractions, gaps from narrow to wide. Errors:
/// SETTING_OUT_OF_RANGE naming both settings, with metadata `setting`, `value`, `min`, `max`.
absl::Status CheckSettings(const Draft& draft);

}  // namespace slicefarm::config::fdm
