#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "common/model/path.h"

namespace slicefarm {

/// What a print takes, by what it is spent on. Times in s.
struct PrintTimes {
  std::array<double, kFeatureCount> feature_s = {};  ///< by Feature
  double travel_s = 0;   ///< what moves without printing
  double retract_s = 0;  ///< filament alone
  double custom_s = 0;   ///< moves of the settings' own G-code
  double dwell_s = 0;    ///< G4
  double heating_s = 0;  ///< waits for heat, by the settings' heating rates
  // What takes a time that no program tells: counted as 0 s.
  int64_t homings = 0;
  int64_t heat_waits = 0;  ///< those without a rate
  int64_t tool_changes = 0;
  // All of it, once more: before the layers, by layer of the program, after them.
  double before_s = 0;
  std::vector<double> layer_s;
  double after_s = 0;

  double TotalS() const {
    const double printing_s = std::accumulate(feature_s.begin(), feature_s.end(), 0.0);
    return printing_s + travel_s + retract_s + custom_s + dwell_s + heating_s;
  }
  friend bool operator==(const PrintTimes&, const PrintTimes&) = default;
};

}  // namespace slicefarm
