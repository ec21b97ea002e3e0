#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace slicefarm::texture {

/// A stroke of a letter: points joined by straight lines, in a box 4 wide and 6 high.
using Stroke = std::vector<Eigen::Vector2d>;

inline constexpr double kGlyphWidth = 4;
inline constexpr double kGlyphHeight = 6;
inline constexpr double kGlyphAdvance = 6;  ///< from one letter to the next

/// Whether there is a letter: A to Z, 0 to 9, blank, and some signs.
bool HasGlyph(char c);

/// Its strokes. REQUIRES: HasGlyph(c).
std::vector<Stroke> GlyphOf(char c);

}  // namespace slicefarm::texture
