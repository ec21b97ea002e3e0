#pragma once

#include <span>
#include <vector>

#include "common/model/path.h"

namespace slicefarm::ordering {

/// The least point of a path: where a loop starts does not matter to it.
Point LeastPoint(const Path& path);

/// The order of the paths by what they are and not by how they came, so that what follows does not
/// depend on the order of its input: indices into `paths`. Cost: O(points + n log n).
std::vector<size_t> OrderByGeometry(std::span<Path* const> paths);

/// The paths in that order.
std::vector<Path*> SortedByGeometry(std::span<Path* const> paths);

}  // namespace slicefarm::ordering
