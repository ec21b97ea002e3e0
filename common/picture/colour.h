#pragma once

namespace slicefarm {

/// A colour with red, green and blue components.
struct Colour {
  double red = 0;  ///< 0 to 1
  double green = 0;
  double blue = 0;
};

/// Returns the colour between `a` (t = 0) and `b` (t = 1).
Colour Mix(Colour a, Colour b, double t);

/// Returns the colour of a value on a scale: dark blue (0) over green to yellow (1), rising in
/// lightness.
Colour ScaleColour(double fraction);

}  // namespace slicefarm
