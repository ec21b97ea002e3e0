#pragma once

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "common/model/setting.h"

namespace slicefarm::cli {

enum class FieldKind : uint8_t { kDensity, kStress, kMaterials };

/// Reads a field from a JSON file and returns it as a setting. The setting includes files that the
/// JSON file names: raw numbers of a grid, and PNG pictures, which become grids
/// (common/model/fields/README.md).
///
/// Errors, with the file's name: REQUEST_MALFORMED for files that cannot be read; SETTING_MALFORMED
/// for an invalid field, with the broken rule; REQUEST_TOO_LARGE above limits::kMaxFieldBytes.
absl::StatusOr<Setting> ReadFieldFile(const std::string& path, FieldKind kind);

}  // namespace slicefarm::cli
