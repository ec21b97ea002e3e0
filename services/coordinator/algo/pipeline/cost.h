#pragma once

#include <string>

namespace slicefarm::coordinator {

/// What a farm charges. Money is in units of `currency`.
struct Rates {
  std::string currency = {};    ///< empty: nobody has said; filament_cost of profiles has none
  double setup = 0;             ///< a job
  double machine_per_hour = 0;  ///< while it prints
  double energy_per_kwh = 0;
  double printer_power_w = 0;  ///< while it prints, on average
  double filament_per_kg = 0;  ///< of filaments whose settings name no cost

  friend bool operator==(const Rates&, const Rates&) = default;
};

struct Cost {
  std::string currency;
  double setup = 0;
  double machine = 0;
  double energy = 0;
  double filament = 0;

  double Total() const { return setup + machine + energy + filament; }
  friend bool operator==(const Cost&, const Cost&) = default;
};

/// `filament_per_kg`: the settings' filament_cost; 0: that of the rates.
Cost CostOf(const Rates& rates, double print_time_s, double filament_g, double filament_per_kg);

}  // namespace slicefarm::coordinator
