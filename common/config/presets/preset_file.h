#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::config::presets {

/// Limits on files of presets, which users send. OrcaSlicer's own folder has 7,900 files of 12 MB.
inline constexpr int64_t kMaxPresetFiles = 50'000;
inline constexpr int64_t kMaxPresetFileBytes = 16 << 20;
inline constexpr int64_t kMaxPresetBytes = 256 << 20;  ///< bytes of all files, expanded

/// File with presets, in memory.
struct PresetFile {
  std::string path;  ///< path with `/` between folders, relative to the source
  std::string bytes;
};

/// Returns true if a file of this name may have presets: .json, .ini, or an archive of them.
bool MayHavePresets(std::string_view path);

/// Returns the file's name without folders and ending.
std::string FileStem(std::string_view path);

/// Returns true for the bytes of a ZIP archive: .orca_printer, .orca_filament, .bbscfg, .bbsflmt.
bool IsArchive(std::string_view bytes);

/// Returns the files of an archive that may have presets, in its order. Their paths begin with the
/// archive's path. Errors: SETTING_MALFORMED for a damaged or encrypted archive; REQUEST_TOO_LARGE
/// beyond the limits on files, bytes and compression, which are checked before anything is
/// expanded.
absl::StatusOr<std::vector<PresetFile>> UnpackArchive(const PresetFile& archive,
                                                      int64_t max_bytes = kMaxPresetBytes);

/// Returns a ZIP archive with the files, in their order; equal files give equal bytes. Errors:
/// INTERNAL if libzip fails.
absl::StatusOr<std::string> PackArchive(const std::vector<PresetFile>& files);

}  // namespace slicefarm::config::presets
