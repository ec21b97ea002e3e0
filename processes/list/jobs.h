#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm {

/// The processes whose jobs can be made of the stages, in the order of Process. `spool_directory`:
/// where programs wait for each other (SpoolFile::Make).
std::vector<std::unique_ptr<coordinator::JobProcess>> JobsOver(const Stages& stages,
                                                               const std::string& spool_directory);

}  // namespace slicefarm
