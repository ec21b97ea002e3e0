#pragma once

#include <map>
#include <string>
#include <string_view>

namespace slicefarm::cli {

/// How the lines of one id of a CLI file are exposed.
struct LineStyle {
  std::string kind;       ///< "contour", "upskin" ...: the label's words before the power
  double power_w = 0;     ///< 0: not known
  double speed_mm_s = 0;  ///< 0: not known
  double point_distance_um = 0;  ///< of pulsed light; 0: a continuous line
  double point_time_us = 0;

  /// What a mm of way gets, in J; 0: not known.
  double EnergyJPerMm() const;
};

/// The styles by id that a CLI header's labels tell. The format itself has no power and no speed:
/// slicefarm says them in the labels ("$$LABEL/2,hatch 200 W 800 mm/s"), which others pass over. A
/// label without "W" and "mm/s" tells nothing.
std::map<int, LineStyle> StylesOf(std::string_view cli_header);

}  // namespace slicefarm::cli
