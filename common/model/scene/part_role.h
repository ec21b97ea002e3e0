#pragma once

#include <cstdint>


namespace slicefarm {

/// What a part is for.
enum class PartRole : uint8_t {
  kSolid,            ///< is printed
  kNegative,         ///< is cut out of the object's solid parts
  kModifier,         ///< gives what lies inside it settings of its own
  kSupportEnforcer,  ///< is supported from below
  kSupportBlocker,   ///< is not
  kSeamEnforcer,     ///< loops start inside it where they can
  kSeamBlocker,      ///< loops start outside of it where they can
};

}  // namespace slicefarm
