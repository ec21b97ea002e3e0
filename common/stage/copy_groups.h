#pragma once

#include <span>
#include <vector>

#include "common/model/scene/scene.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm {

/// Copies of an object that differ only by a shift along the bed.
struct CopyGroup {
  Transform to_plate;  ///< common transform of the copies, without the shift in x and y
  std::vector<const Instance*> instances;
};

/// Returns the printable copies of an object in groups, in the order of their first copies. The
/// groups point to the instances of the argument.
std::vector<CopyGroup> GroupsOf(std::span<const Instance> instances);

/// Returns the positions of the copies of a group.
std::vector<CopyInput> CopiesOf(const CopyGroup& group);

}  // namespace slicefarm
