#pragma once

#include <cstdint>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm {

/// What an outline is part of.
enum class Role : uint8_t {
  kPart,  ///< what the job is about
  kBrim,
  kRaft,
  kRaftInterface,  ///< the layers of a raft that carry the part
  kSupport,
  kSupportInterface,  ///< the layers of supports next to the part
};
inline constexpr int kRoleCount = 6;

/// What beads of a role are called, whatever they are for within it; of kPart: `feature`.
constexpr Feature FeatureFor(Role role, Feature feature) {
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

/// Outlines that are walled and filled alike.
struct Region {
  Role role = Role::kPart;
  int32_t settings = 0;  ///< index into the job's tables of region settings
  int32_t tool = 0;      ///< 0: others are refused until tools exist
  MultiPolygon outlines;

  friend bool operator==(const Region&, const Region&) = default;
};

}  // namespace slicefarm
