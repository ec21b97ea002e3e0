#pragma once

#include <span>
#include <vector>

#include "common/model/scene/scene.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm {

/// Copies of an object that differ only by a shift in x and y.
struct CopyGroup {
  Transform to_plate;  ///< transform of each copy, with the shift in x and y set to 0
  std::vector<const Instance*> instances;
};

/// Returns the printable copies of an object in groups, in the order of their first copies. The
/// groups contain pointers to elements of `instances`.
std::vector<CopyGroup> GroupsOf(std::span<const Instance> instances);

/// Returns the positions of a group's copies, in the order of CopyGroup::instances.
std::vector<CopyInput> CopiesOf(const CopyGroup& group);

}  // namespace slicefarm
