#include "services/cli/job/joined_plates.h"

#include <fmt/core.h>

#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "common/gcode/archive/gcode_archive.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"

namespace slicefarm::cli {
namespace {

constexpr int64_t kMaxArchiveBytes = int64_t{2} << 30;

}  // namespace

std::string OutputOf(const JobOptions& options, const std::string& path, size_t plate) {
  if (!options.plates || path.empty()) return path;
  const std::filesystem::path given(path);
  const bool archive = path.ends_with(kArchiveEnding);
  const std::string ending = archive ? std::string(kArchiveEnding) : given.extension().string();
  std::string name = given.filename().string();
  name.resize(name.size() - ending.size());
  return (given.parent_path() / fmt::format("{}-{}{}", name, plate + 1, ending)).string();
}

absl::Status JoinPlates(const JobOptions& options, const std::string& output, size_t plates) {
  if (!options.plates || !output.ends_with(kArchiveEnding)) return absl::OkStatus();
  std::vector<std::string> archives;
  for (size_t i = 0; i < plates; ++i) {
    auto archive = ReadFile(OutputOf(options, output, i), kMaxArchiveBytes);
    if (!archive.ok()) return archive.status();
    archives.push_back(*std::move(archive));
  }
  const auto joined = gcode::JoinedArchive(archives);
  if (!joined.ok())
    return Malformed(fmt::format("{}: {}", output, std::string(joined.status().message())));
  if (absl::Status written = WriteFile(output, *joined); !written.ok()) return written;
  for (size_t i = 0; i < plates; ++i) std::filesystem::remove(OutputOf(options, output, i));
  if (!options.quiet) Print(fmt::format("{}: {} plates\n", output, plates));
  return absl::OkStatus();
}

}  // namespace slicefarm::cli
