#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/shared/shared_text.h"
#include "common/model/fields/density_field.h"
#include "common/model/fields/material_field.h"
#include "common/model/fields/stress_field.h"

namespace slicefarm {

/// Fields as settings have them: JSON on one line, as common/model/fields/README.md describes it.
/// Errors: InvalidArgument that says which entry is missing, unknown, of the wrong kind, not
/// finite or out of range, or how many values there are and must be.
absl::StatusOr<DensityField> ParseDensityField(std::string_view text);
absl::StatusOr<StressField> ParseStressField(std::string_view text);
absl::StatusOr<MaterialField> ParseMaterialField(std::string_view text);

/// The same of a text that many have, read once for all of them.
const absl::StatusOr<DensityField>& DensityFieldOf(const SharedText& text);

/// The inverse, in canonical form: numbers have six digits, and what has its standard is left out.
std::string PrintDensityField(const DensityField& field);
std::string PrintStressField(const StressField& field);
std::string PrintMaterialField(const MaterialField& field);

}  // namespace slicefarm
