#pragma once

#include <array>
#include <string>

namespace slicefarm {

/// Properties of an object's orientation on the bed.
struct Lying {
  double contact_mm2 = 0;   ///< area of faces in contact with the bed
  double overhang_mm2 = 0;  ///< area of faces that need support, projected from above
  double height_mm = 0;
  bool stable = false;  ///< true if the centre of mass is above the contact area

  friend bool operator==(const Lying&, const Lying&) = default;
};

/// Recommendation to rotate an object, because another orientation is better for printing.
struct OrientationAdvice {
  std::string object;  ///< name of the object
  /// Rotation that should replace Placement::rotate_deg.
  std::array<double, 3> rotate_deg = {0, 0, 0};
  Lying asked;
  Lying advised;

  friend bool operator==(const OrientationAdvice&, const OrientationAdvice&) = default;
};

}  // namespace slicefarm
