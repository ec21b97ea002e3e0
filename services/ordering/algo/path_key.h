#pragma once

#include <span>
#include <vector>

#include "common/model/path.h"

namespace slicefarm::ordering {

/// Returns the path's smallest point in the order of `Point`. The result does not depend on the
/// start of a loop.
Point LeastPoint(const Path& path);

/// Returns indices into `paths`, sorted by the properties of the paths. Later steps therefore do
/// not depend on the order of `paths`. Cost: O(points + n log n), n paths.
std::vector<size_t> OrderByGeometry(std::span<Path* const> paths);

/// Returns the paths in the order of OrderByGeometry.
std::vector<Path*> SortedByGeometry(std::span<Path* const> paths);

}  // namespace slicefarm::ordering
