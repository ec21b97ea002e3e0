#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/gcode/archive/archived_plate.h"

namespace slicefarm::gcode {

/// Returns a .gcode.3mf archive, the form in which Bambu Lab's printers take programs over the
/// network: an OPC package with a program, its MD5, pictures and facts for each plate. Plates are
/// numbered from 1. The project has the settings of the first plate. The bytes depend on
/// the plates only. Cost: O(bytes). REQUIRES: at least one plate. Sources: archives of Bambu Studio
/// 2.4; ECMA-376 part 2.
absl::StatusOr<std::string> GcodeArchive(const std::vector<ArchivedPlate>& plates);

/// Returns true if the file begins like an archive.
bool IsGcodeArchive(std::string_view file);

/// Returns the numbers of the plates with a program, in ascending order. Errors: InvalidArgument
/// for an archive that cannot be read or has no program.
absl::StatusOr<std::vector<int>> PlatesOf(std::string_view archive);

/// Plate of an archive: the only one, the first one, or a number from 1.
inline constexpr int kOnlyPlate = 0;
inline constexpr int kFirstPlate = -1;

/// Returns the program of a plate. Errors: InvalidArgument for an archive that cannot be read, a
/// plate that does not exist, `kOnlyPlate` with several plates, and a program that does not match
/// its MD5. Expands at most twice the limits of ZipData.
absl::StatusOr<std::string> TextOfPlate(std::string_view archive, int plate);

/// Returns one archive with the plates of several archives that GcodeArchive made, numbered from 1
/// in their order. Errors: InvalidArgument for other archives.
absl::StatusOr<std::string> JoinedArchive(const std::vector<std::string>& archives);

}  // namespace slicefarm::gcode
