#pragma once

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "common/model/setting.h"

namespace slicefarm::cli {

enum class FieldKind : uint8_t { kDensity, kStress, kMaterials };

/// A field of a JSON file, as the setting it is. What lies in files beside it is taken in: raw
/// numbers of a grid, and PNG pictures, which become grids (common/model/fields/README.md).
///
/// Errors: REQUEST_MALFORMED for files that cannot be read; SETTING_MALFORMED for what is no field,
/// with the rule it breaks; REQUEST_TOO_LARGE past limits::kMaxFieldBytes. All with the file's name.
absl::StatusOr<Setting> ReadFieldFile(const std::string& path, FieldKind kind);

}  // namespace slicefarm::cli
