#pragma once

#include <string>
#include <vector>

namespace slicefarm::coordinator {

/// What contradicts itself in the database of jobs in a file: pages that do not fit together, rows
/// that refer to no row, a job without its events or with others, a request_id without its job.
std::vector<std::string> DatabaseContradictions(const std::string& path);

}  // namespace slicefarm::coordinator
