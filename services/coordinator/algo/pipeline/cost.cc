#include "services/coordinator/algo/pipeline/cost.h"

namespace slicefarm::coordinator {

Cost CostOf(const Rates& rates, double print_time_s, double filament_g, double filament_per_kg) {
  const double hours = print_time_s / 3600;
  const double per_kg = filament_per_kg > 0 ? filament_per_kg : rates.filament_per_kg;
  Cost cost;
  cost.currency = rates.currency;
  cost.setup = rates.setup;
  cost.machine = hours * rates.machine_per_hour;
  cost.energy = hours * rates.printer_power_w / 1000 * rates.energy_per_kwh;
  cost.filament = filament_g / 1000 * per_kg;
  return cost;
}

}  // namespace slicefarm::coordinator
