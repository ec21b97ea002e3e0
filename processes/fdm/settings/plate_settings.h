#pragma once

#include "absl/status/status.h"
#include "common/config/process_settings.h"

namespace slicefarm::config::fdm {

/// Adds the rows of the object's brim and raft, which its settings name then.
absl::Status AddAdhesionRows(JobRows& object, RegionRows& rows);

/// Adds the row of the skirt, and room for brims between copies that are arranged. `job`: the
/// settings of the job.
absl::Status FinishPlate(const JobRows& job, RegionRows& rows, JobSettings& plate);

}  // namespace slicefarm::config::fdm
