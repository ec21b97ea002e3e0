#include "tests/bench/polygon_folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "services/cli/console/files.h"

namespace slicefarm::bench {

namespace fs = std::filesystem;

std::vector<PolygonFile> PolygonsIn(const std::string& directory) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<PolygonFile> files;
  for (const fs::path& path : paths) {
    const auto text = cli::ReadFile(path.string(), 64 << 20);
    auto poly = text.ok() ? lab::ParsePoly(*text) : text.status();
    if (poly.ok()) files.push_back({path.stem().string(), *std::move(poly)});
  }
  return files;
}

}  // namespace slicefarm::bench
