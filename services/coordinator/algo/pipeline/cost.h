#pragma once

#include <string>

namespace slicefarm::coordinator {

/// Prices of a farm, in units of `currency`.
struct Rates {
  /// Currency code. Empty if no rates are set, because the `filament_cost` of a profile has no
  /// currency.
  std::string currency = {};
  double setup = 0;             ///< price per job
  double machine_per_hour = 0;  ///< price per hour of printing
  double energy_per_kwh = 0;
  double printer_power_w = 0;  ///< average power while printing, in W
  double filament_per_kg = 0;  ///< price of filament if the settings have no filament cost

  friend bool operator==(const Rates&, const Rates&) = default;
};

/// Cost of a job by item, in units of `currency`.
struct Cost {
  std::string currency;
  double setup = 0;
  double machine = 0;
  double energy = 0;
  double filament = 0;

  /// Returns the sum of all items.
  double Total() const { return setup + machine + energy + filament; }
  friend bool operator==(const Cost&, const Cost&) = default;
};

/// Returns the cost of a job. `filament_per_kg`: the settings' `filament_cost`; if 0, the price of
/// the rates is used.
Cost CostOf(const Rates& rates, double print_time_s, double filament_g, double filament_per_kg);

}  // namespace slicefarm::coordinator
