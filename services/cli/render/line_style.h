#pragma once

#include <map>
#include <string>
#include <string_view>

namespace slicefarm::cli {

/// Exposure parameters of the lines with one id in a CLI file.
struct LineStyle {
  std::string kind;       ///< text before the power in the label, such as "contour" or "upskin"
  double power_w = 0;     ///< power of the beam; 0: not known
  double speed_mm_s = 0;  ///< scanning speed; 0: not known
  double point_distance_um = 0;  ///< distance of pulses; 0: a continuous line
  double point_time_us = 0;

  /// Returns the energy per mm, in J; 0: not known.
  double EnergyJPerMm() const;
};

/// Returns the styles, keyed by id, from the labels in a CLI header. The CLI format has no fields
/// for power and speed. slicefarm writes them into the labels ("$$LABEL/2,hatch 200 W 800 mm/s"),
/// and other programs ignore them. A label without "W" and "mm/s" gives no style.
std::map<int, LineStyle> StylesOf(std::string_view cli_header);

}  // namespace slicefarm::cli
