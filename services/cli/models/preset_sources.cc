#include "services/cli/models/preset_sources.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "common/base/error.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/job_presets.h"
#include "common/config/presets/preset_file.h"
#include "common/config/presets/read_presets.h"
#include "services/cli/console/files.h"

namespace slicefarm::cli {
namespace {

namespace presets = config::presets;

/// Reads files of presets within the limits of all sources together.
class PresetFileReader {
 public:
  absl::Status Read(const std::string& source) {
    std::error_code error;
    if (!std::filesystem::is_directory(source, error)) return Add(source);
    std::filesystem::recursive_directory_iterator at(source, error);
    const std::filesystem::recursive_directory_iterator end;
    while (!error && at != end) {
      const std::string path = at->path().string();
      if (presets::MayHavePresets(path) && at->is_regular_file(error))
        if (absl::Status added = Add(path); !added.ok()) return added;
      at.increment(error);
    }
    if (!error) return absl::OkStatus();
    return Malformed(fmt::format("cannot read {}: {}", source, error.message()));
  }

  std::vector<presets::PresetFile> Take() && { return std::move(files_); }

 private:
  absl::Status Add(const std::string& path) {
    auto bytes = ReadFile(path, presets::kMaxPresetFileBytes);
    if (!bytes.ok()) return bytes.status();
    bytes_ += static_cast<int64_t>(bytes->size());
    files_.push_back({path, *std::move(bytes)});
    if (std::ssize(files_) > presets::kMaxPresetFiles)
      return LimitError(Reason::kRequestTooLarge, "files of presets", presets::kMaxPresetFiles,
                        std::ssize(files_));
    if (bytes_ > presets::kMaxPresetBytes)
      return LimitError(Reason::kRequestTooLarge, "bytes of presets", presets::kMaxPresetBytes,
                        bytes_);
    return absl::OkStatus();
  }

  std::vector<presets::PresetFile> files_;
  int64_t bytes_ = 0;
};

}  // namespace

absl::StatusOr<std::vector<presets::PresetFile>> ReadPresetFiles(
    const std::vector<std::string>& sources) {
  PresetFileReader reader;
  for (const std::string& source : sources)
    if (absl::Status read = reader.Read(source); !read.ok()) return read;
  return std::move(reader).Take();
}

absl::StatusOr<presets::PresetSet> ReadPresetSources(const std::vector<std::string>& sources) {
  auto files = ReadPresetFiles(sources);
  if (!files.ok()) return files.status();
  return presets::ReadPresets(*std::move(files));
}

presets::PresetNames NamesOf(const PresetOptions& options) {
  return {options.printer, options.process, options.filament};
}

presets::PresetNames FullNames(const presets::ChosenPresets& chosen) {
  return {chosen.printer->name, chosen.process->name, chosen.filament->name};
}

absl::Status TakePresets(const presets::PresetSet& set, const PresetOptions& options,
                         GivenPlate& plate) {
  auto chosen = presets::ChoosePresets(set, NamesOf(options));
  if (!chosen.ok()) return chosen.status();
  const auto job = presets::SettingsOfPresets(set, *chosen);
  if (!job.ok()) return job.status();
  plate.presets = FullNames(*chosen);
  std::ranges::copy(job->settings, std::back_inserter(plate.settings));
  std::ranges::move(chosen->notes, std::back_inserter(plate.warnings));
  std::ranges::copy(job->sources, std::back_inserter(plate.sources));
  AddUnused(job->of_print, job->others, plate);
  return absl::OkStatus();
}

void AddUnused(const std::vector<std::string>& of_print, const std::vector<std::string>& others,
               GivenPlate& plate) {
  for (const std::string& line : of_print) plate.warnings.push_back(line + ": not supported yet");
  std::ranges::copy(of_print, std::back_inserter(plate.without_effect));
  std::ranges::copy(others, std::back_inserter(plate.without_effect));
}

}  // namespace slicefarm::cli
