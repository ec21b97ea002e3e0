#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/pipeline/cost.h"

namespace slicefarm::coordinator {

/// Reads rates from JSON: `{"currency": "EUR", "setup": 1.5, "machine_per_hour": 2,
/// "energy_per_kwh": 0.3, "printer_power_w": 120, "filament_per_kg": 25}`. The rate of a missing
/// key is 0. Errors: InvalidArgument with a key that is unknown, not a number, or negative.
absl::StatusOr<Rates> ParseRates(std::string_view json);

/// Reads rates from a file. Errors: as in ParseRates; also if the file cannot be read.
absl::StatusOr<Rates> ReadRates(const std::string& path);

}  // namespace slicefarm::coordinator
