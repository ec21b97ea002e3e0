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

/// Returns the files of an archive that may have presets (MayHavePresets), in the archive's order.
/// The paths of these files begin with the archive's path. Errors: SETTING_MALFORMED for a damaged
/// or encrypted archive; REQUEST_TOO_LARGE beyond the limits on files, bytes and compression. The
/// limits are checked before any file is expanded.
absl::StatusOr<std::vector<PresetFile>> UnpackArchive(const PresetFile& archive);

}  // namespace slicefarm::config::presets
