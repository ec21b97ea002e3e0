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
  int32_t settings = 0;  ///< row of the part's settings, for solid parts
  const std::map<int32_t, int32_t>* changes = nullptr;  ///< for modifiers: new row by old row
  MultiPolygon outlines;
};

/// Section of an object, and its partition by settings.
struct PartitionedSection {
  MultiPolygon whole;           ///< empty if there is at most one region
  std::vector<Region> regions;  ///< disjoint, by ascending row; none is empty
  std::vector<Mark> marks;      ///< sorted by ascending role; none is empty
};

/// Combines the sections of an object's parts. If solid parts overlap, the settings of the later
/// part count. Negative parts are subtracted from all of them. Modifiers then change the rows of
/// settings inside of them, one after the other. Marks for seams and supports are kept separately.
/// `edits` move the outlines of the whole, and the regions with them.
///
/// Invariant: the regions tile the edited whole, except for rounding. Costs nothing for a single
/// solid part.
PartitionedSection Partition(std::vector<PartSection> parts, const RegionEdits& edits,
                             Coord resolution_nm);

}  // namespace slicefarm::slicing
