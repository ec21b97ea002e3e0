#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "common/model/path.h"

namespace slicefarm {

/// Time of a print by activity, in s.
struct PrintTimes {
  std::array<double, kFeatureCount> feature_s = {};  ///< time of beads per Feature
  double travel_s = 0;                               ///< time of moves without extrusion
  double retract_s = 0;                              ///< time of moves of the filament alone
  double custom_s = 0;                               ///< time of moves in custom G-code
  double dwell_s = 0;                                ///< time of G4 commands
  /// waiting time for heaters, estimated from the heating rates of the settings
  double heating_s = 0;
  // Numbers of actions of unknown duration; each adds 0 s to the total.
  int64_t homings = 0;
  int64_t heat_waits = 0;  ///< number of waits for heaters without a heating rate
  int64_t tool_changes = 0;
  // Total time again, divided by position: before the layers, in each layer of the program, and
  // after the layers.
  double before_s = 0;
  std::vector<double> layer_s;
  double after_s = 0;
  /// Part of the total time that belongs to each copy of the job: see CopyUse. The rest is shared.
  std::vector<double> copy_s = {};

  double TotalS() const {
    const double printing_s = std::accumulate(feature_s.begin(), feature_s.end(), 0.0);
    return printing_s + travel_s + retract_s + custom_s + dwell_s + heating_s;
  }
  friend bool operator==(const PrintTimes&, const PrintTimes&) = default;
};

}  // namespace slicefarm
