#pragma once

#include <cstdint>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm {

/// Kind of structure to which an outline belongs.
enum class Role : uint8_t {
  kPart,  ///< the object to be made
  kBrim,
  kRaft,
  kRaftInterface,  ///< layers of a raft directly below the part
  kSupport,
  kSupportInterface,  ///< layers of supports next to the part
};
inline constexpr int kRoleCount = 6;

/// Returns the feature under which the beads of a structure are reported. For kPart it is
/// `feature`; each other role has one fixed feature, except for ironing.
constexpr Feature FeatureFor(Role role, Feature feature) {
  if (feature == Feature::kIroning) return feature;
  switch (role) {
    case Role::kPart:
      return feature;
    case Role::kBrim:
      return Feature::kSkirt;
    case Role::kRaft:
    case Role::kSupport:
      return Feature::kSupport;
    case Role::kRaftInterface:
    case Role::kSupportInterface:
      return Feature::kSupportInterface;
  }
  return feature;
}

/// Outlines with the same settings for walls and infill.
struct Region {
  Role role = Role::kPart;
  int32_t settings = 0;  ///< index into the job's tables of region settings
  /// Index of the tool. Only 0 is accepted, because several tools are not supported yet.
  int32_t tool = 0;
  MultiPolygon outlines;

  friend bool operator==(const Region&, const Region&) = default;
};

}  // namespace slicefarm
