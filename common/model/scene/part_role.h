#pragma once

#include <cstdint>

namespace slicefarm {

/// Purpose of a part of an object.
enum class PartRole : uint8_t {
  kSolid,            ///< volume that is printed
  kNegative,         ///< volume that is cut out of the object's solid parts
  kModifier,         ///< volume in which parts of the object have other settings
  kSupportEnforcer,  ///< volume that gets supports
  kSupportBlocker,   ///< volume that gets no supports
  kSeamEnforcer,     ///< volume in which loops preferably start
  kSeamBlocker,      ///< volume in which loops preferably do not start
};

}  // namespace slicefarm
