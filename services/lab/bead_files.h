#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/beading/algo/arachne/variable_walls.h"

namespace slicefarm::lab {

/// Reads outlines from a text in the format of the data set of Hornus et al. 2020 and Kuipers et
/// al. 2020. The text has two unused numbers, then for each ring its number of points and their x
/// and y in mm. The region follows the even-odd rule. Errors: kMeshMalformed.
absl::StatusOr<MultiPolygon> ParseOutlines(std::string_view text);

/// Returns the .txt files of a directory, sorted by name. Errors: kRequestMalformed if the
/// directory cannot be read or has no such file.
absl::StatusOr<std::vector<std::filesystem::path>> OutlineFiles(const std::string& directory);

/// Reads the outlines of a file. Errors: see ReadFile and ParseOutlines, with the file's name.
absl::StatusOr<MultiPolygon> ReadOutlines(const std::filesystem::path& file);

/// Returns beads as text, one bead per line. The columns are: index of its inset; 1 if the bead is
/// along the middle of the part, else 0; 1 if it is closed, else 0; number of points; then x, y and
/// width in mm of each point.
std::string PrintBeads(const std::vector<beading::WallLine>& lines);

}  // namespace slicefarm::lab
