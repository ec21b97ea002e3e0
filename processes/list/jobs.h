#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/stage/stage_list.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm {

/// Returns the processes that can make jobs with the given stages, in the order of Process.
/// `spool_directory`: directory for programs that wait for other programs (SpoolFile::Make).
std::vector<std::unique_ptr<coordinator::JobProcess>> JobsOver(const Stages& stages,
                                                               const std::string& spool_directory);

/// Returns the services that the coordinator calls for a job of the process, besides the workers.
std::vector<Stage> JobStagesOf(Process process);

}  // namespace slicefarm
