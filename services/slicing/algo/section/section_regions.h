#pragma once

#include <map>
#include <vector>

#include "common/model/layers/layer.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/section/regions.h"

namespace slicefarm::slicing {

/// Section of one part of an object.
struct PartSection {
  PartRole role = PartRole::kSolid;
  int32_t settings = 0;  ///< index of the part's region settings, for solid parts
  /// only for modifiers. Key: index of the region settings outside the modifier; value: index
  /// inside it
  const std::map<int32_t, int32_t>* changes = nullptr;
  MultiPolygon outlines;
};

/// Section of an object, and its partition by settings.
struct PartitionedSection {
  MultiPolygon whole;           ///< union of all regions; empty if there is at most one region
  std::vector<Region> regions;  ///< disjoint regions, sorted by settings index; none is empty
  std::vector<Mark> marks;      ///< marks, sorted by role; none is empty
};

/// Combines the sections of an object's parts. If solid parts overlap, the settings of the later
/// part are used. Negative parts are subtracted from all solid parts. Modifiers then change the
/// region settings inside of them, one after the other. Sections of marks for seams and supports
/// are returned as marks. `edits` move the outlines of the whole, and the regions with them.
///
/// Invariant: the regions together fill the edited whole without overlap, except for rounding. For
/// a single solid part, the function moves the section without a boolean operation.
PartitionedSection Partition(std::vector<PartSection> parts, const RegionEdits& edits,
                             Coord resolution_nm);

}  // namespace slicefarm::slicing
