#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/model/options/height_code.h"

namespace slicefarm::cli {

/// Shape of the line that is printed for each value.
enum class LineShape {
  kStraight,  ///< one layer: slow, fast, slow
  kCorner,    ///< several layers: three lines with a right angle, at one speed
};

/// Value to which a line belongs.
struct ValueLine {
  std::string label;
  std::string code;  ///< G-code that sets the value
};

/// Settings of the machine and of the beads. Lengths in mm, speeds in mm/s.
struct LineSettings {
  double first_layer_mm = 0.2;
  double layer_mm = 0.2;
  double width_mm = 0.45;
  double flow = 1;            ///< factor of the filament
  double filament_mm2 = 2.4;  ///< section of the filament
  double slow = 20;
  double fast = 100;
  double travel = 120;
  double retract_mm = 0;
  double retract_speed = 40;
  double restart_speed = 40;
  std::array<double, 2> middle = {};  ///< middle of the bed
  std::string code_after;             ///< G-code that restores the value; may be empty
};

/// Print of lines within a frame, with a plate of raised labels beside them.
struct LinePrint {
  std::string stl;                ///< frame and labels; its middle is at LineSettings::middle
  std::vector<HeightCode> codes;  ///< G-code of the lines, for each layer. It uses relative E.
};

/// Number of layers of LineShape::kCorner.
inline constexpr int kCornerLayers = 4;

/// Returns the print. The code of a layer begins and ends with a retracted filament, at the
/// height of the layer. Cost: O(lines).
LinePrint MakeLinePrint(LineShape shape, const std::vector<ValueLine>& lines,
                        const LineSettings& settings);

}  // namespace slicefarm::cli
