#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/beading/algo/arachne/variable_walls.h"

namespace slicefarm::lab {

/// Outlines as text: two numbers that are not used, then for each ring its number of points and
/// their x and y in mm; the region by the even-odd rule. (The format of the data set of Hornus et
/// al. 2020 and Kuipers et al. 2020.) Errors: kMeshMalformed.
absl::StatusOr<MultiPolygon> ParseOutlines(std::string_view text);

/// The .txt files of a directory by name. Errors: kRequestMalformed, also if there is none.
absl::StatusOr<std::vector<std::filesystem::path>> OutlineFiles(const std::string& directory);

/// Errors are ReadFile's and ParseOutlines', with the file's name.
absl::StatusOr<MultiPolygon> ReadOutlines(const std::filesystem::path& file);

/// Beads as text, a line each: inset, 1 if it runs along the middle, 1 if it is closed, number of
/// points, then x, y and width of each in mm.
std::string PrintBeads(const std::vector<beading::WallLine>& lines);

}  // namespace slicefarm::lab
