#pragma once

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "common/model/setting.h"

namespace slicefarm::cli {

enum class FieldKind : uint8_t { kDensity, kStress, kMaterials };

/// Reads a field from a JSON file and returns it as a setting. Files beside it are included: raw
/// numbers of a grid, and PNG pictures, which become grids (common/model/fields/README.md).
///
/// Errors: REQUEST_MALFORMED for files that cannot be read; SETTING_MALFORMED with the broken rule
/// for an invalid field; REQUEST_TOO_LARGE above limits::kMaxFieldBytes. All have the file's name.
absl::StatusOr<Setting> ReadFieldFile(const std::string& path, FieldKind kind);

}  // namespace slicefarm::cli
