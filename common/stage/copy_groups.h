#pragma once

#include <span>
#include <vector>

#include "common/model/scene/scene.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm {

/// Copies of an object that differ by a shift along the bed alone.
struct CopyGroup {
  Transform to_plate;  ///< without x and y
  std::vector<const Instance*> instances;
};

/// The printable copies of an object, in the order in which they come; their instances are those of
/// the argument.
std::vector<CopyGroup> GroupsOf(std::span<const Instance> instances);

/// Where the copies of a group stand.
std::vector<CopyInput> CopiesOf(const CopyGroup& group);

}  // namespace slicefarm
