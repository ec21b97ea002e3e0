#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/pipeline/cost.h"

namespace slicefarm::coordinator {

/// Rates as JSON: `{"currency": "EUR", "setup": 1.5, "machine_per_hour": 2, "energy_per_kwh": 0.3,
/// "printer_power_w": 120, "filament_per_kg": 25}`; what is left out is free. Errors:
/// InvalidArgument naming a key that is unknown, no number, or negative.
absl::StatusOr<Rates> ParseRates(std::string_view json);

/// Those of a file. Errors: also if it cannot be read.
absl::StatusOr<Rates> ReadRates(const std::string& path);

}  // namespace slicefarm::coordinator
