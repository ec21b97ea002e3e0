#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm {

/// Returns the processes that can make jobs with the given stages, in the order of Process.
/// `spool_directory`: directory for programs that wait for other programs (SpoolFile::Make).
std::vector<std::unique_ptr<coordinator::JobProcess>> JobsOver(const Stages& stages,
                                                               const std::string& spool_directory);

}  // namespace slicefarm
