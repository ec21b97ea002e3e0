#pragma once

#include <map>
#include <vector>

#include "common/model/layers/layer.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/section/regions.h"

namespace slicefarm::slicing {

/// The section of one part of an object.
struct PartSection {
  PartRole role = PartRole::kSolid;
  int32_t settings = 0;                             ///< of solid parts: their row
  const std::map<int32_t, int32_t>* changes = nullptr;  ///< of modifiers: row inside by row outside
  MultiPolygon outlines;
};

/// An object's section, and its partition by settings.
struct PartitionedSection {
  MultiPolygon whole;           ///< empty where there is one region at most
  std::vector<Region> regions;  ///< disjoint, by ascending row; none empty
  std::vector<Mark> marks;      ///< by ascending role, those of a role together; none empty
};

/// Puts the sections of an object's parts together. Of solid parts that overlap, the later one's
/// settings count; negative parts are cut out of all of them; modifiers then change the rows inside
/// of them, one after the other. What marks seams and supports goes along. `edits` move the
/// outlines of the whole, and regions with them.
///
/// Invariant: the regions tile the edited whole, to rounding. Free of cost for a single solid part.
PartitionedSection Partition(std::vector<PartSection> parts, const RegionEdits& edits,
                             Coord resolution_nm);

}  // namespace slicefarm::slicing
