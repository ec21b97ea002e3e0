#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace slicefarm::texture {

/// Stroke of a letter: points connected by straight lines. A letter is in a box 4 wide and 6 high,
/// without a unit.
using Stroke = std::vector<Eigen::Vector2d>;

inline constexpr double kGlyphWidth = 4;
inline constexpr double kGlyphHeight = 6;
inline constexpr double kGlyphAdvance = 6;  ///< distance from one letter to the next

/// Returns true if the font has this character: A to Z, 0 to 9, blank, and some signs.
bool HasGlyph(char c);

/// Returns the strokes of a character. REQUIRES: HasGlyph(c).
std::vector<Stroke> GlyphOf(char c);

}  // namespace slicefarm::texture
