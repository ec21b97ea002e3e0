#pragma once

#include <array>
#include <string>

namespace slicefarm {

/// How an object lies on the bed.
struct Lying {
  double contact_mm2 = 0;   ///< faces that lie on the bed
  double overhang_mm2 = 0;  ///< faces that need support, seen from above
  double height_mm = 0;
  bool stable = false;  ///< its centre of mass is over what touches the bed

  friend bool operator==(const Lying&, const Lying&) = default;
};

/// A better way round to print an object than the one that was asked for.
struct OrientationAdvice {
  std::string object;                            ///< its name
  std::array<double, 3> rotate_deg = {0, 0, 0};  ///< in place of Placement::rotate_deg
  Lying asked;
  Lying advised;

  friend bool operator==(const OrientationAdvice&, const OrientationAdvice&) = default;
};

}  // namespace slicefarm
