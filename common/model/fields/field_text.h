#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/shared/shared_text.h"
#include "common/model/fields/density_field.h"
#include "common/model/fields/material_field.h"
#include "common/model/fields/stress_field.h"

namespace slicefarm {

/// Parses a field from a setting: JSON on one line, as common/model/fields/README.md describes it.
/// Errors: InvalidArgument for an entry that is missing, unknown, of the wrong type, not finite or
/// out of range; the message names the entry. If the number of values is wrong, the message has the
/// required number.
absl::StatusOr<DensityField> ParseDensityField(std::string_view text);
absl::StatusOr<StressField> ParseStressField(std::string_view text);
absl::StatusOr<MaterialField> ParseMaterialField(std::string_view text);

/// Returns the parsed field of a shared text. The text is parsed only once for all its users.
const absl::StatusOr<DensityField>& DensityFieldOf(const SharedText& text);

/// Returns a field as JSON in canonical form: numbers have six digits, and entries with default
/// values are left out.
std::string PrintDensityField(const DensityField& field);
std::string PrintStressField(const StressField& field);
std::string PrintMaterialField(const MaterialField& field);

}  // namespace slicefarm
