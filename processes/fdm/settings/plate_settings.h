#pragma once

#include "absl/status/status.h"
#include "common/config/process_settings.h"

namespace slicefarm::config::fdm {

/// Adds the rows of the object's brim and raft, and stores the indexes of these rows in the
/// object's settings.
absl::Status AddAdhesionRows(JobRows& object, RegionRows& rows);

/// Adds the row of the skirt, and sets the additional distance that arranged copies need for brims.
/// `job`: the settings of the job.
absl::Status FinishPlate(const JobRows& job, RegionRows& rows, JobSettings& plate);

}  // namespace slicefarm::config::fdm
