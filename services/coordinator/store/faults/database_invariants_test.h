#pragma once

#include <string>
#include <vector>

namespace slicefarm::coordinator {

/// Returns the contradictions in a database file of jobs: inconsistent pages, references to missing
/// rows, jobs without their events or with other events, a request_id without its job.
std::vector<std::string> DatabaseContradictions(const std::string& path);

}  // namespace slicefarm::coordinator
