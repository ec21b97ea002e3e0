#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace slicefarm::cli {

/// Point in mm.
using SolidPoint = std::array<float, 3>;

/// Solid that is the union of boxes and prisms. They may overlap: slicing unites them.
class SolidBuilder {
 public:
  /// Adds a box between two opposite corners. REQUIRES: low < high on each axis.
  void AddBox(const SolidPoint& low, const SolidPoint& high);

  /// Adds a convex prism between two heights along an axis (0: x, 1: y, 2: z). `outline`: corners
  /// in the two other axes, in their order (y z, x z, x y), counter-clockwise.
  void AddPrism(const std::vector<std::array<float, 2>>& outline, int axis, float low, float high);

  /// Adds raised text on a wall that faces -y, between y - `depth` and y + an overlap with the
  /// wall. `x` and `z`: lower left corner of the text. Characters of KnownCharacters only.
  void AddTextOnFront(std::string_view text, const SolidPoint& corner, float height, float depth);

  /// Adds raised text on a level surface, between z - an overlap and z + `depth`.
  void AddTextOnTop(std::string_view text, const SolidPoint& corner, float height, float depth);

  /// Returns the solid as a binary STL file.
  std::string Stl() const;

 private:
  struct Face {
    SolidPoint a, b, c;
  };
  std::vector<Face> faces_;
  int solids_ = 0;
};

/// Characters that have a shape: digits, point and signs.
inline constexpr std::string_view kKnownCharacters = "0123456789.-+";

/// Returns the width of a text of this height, in mm.
float TextWidth(std::string_view text, float height);

}  // namespace slicefarm::cli
