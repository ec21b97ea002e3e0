#include "services/cli/job/output_name.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <vector>

#include "common/base/text.h"
#include "common/config/process_settings.h"
#include "common/config/table/settings_table.h"
#include "common/config/table/suggest.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {
namespace {

struct OtherFile {
  std::string_view endings;  ///< separated by spaces
  std::string_view what;
};

constexpr OtherFile kOtherFiles[] = {
    {".3mf .stl .obj .ply .amf .step .stp .iges .igs .off .gltf .glb", "a model"},
    {".slm .sli .sl1 .sl1s .ctb .cbddlp .photon .goo .pwmo .pws .lys", "a file of layers"},
    {".x3g .makerbot .ufp", "a file for another firmware"},
    {".zip .gz .bz2 .xz .7z .tar", "an archive"},
    {".png .jpg .jpeg .gif .pdf", "a picture"},
    {".json .ini .toml .yaml .yml .xml .html .md", "a document"},
};

std::string LowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string EndingsOf(Process process) {
  std::string all;
  for (const config::FileFormat& format : config::SettingsOf(process).FileFormats())
    all += fmt::format("{}{}", all.empty() ? "" : ", ", format.suffix.substr(1));
  return all;
}

bool HasEnding(Process process, std::string_view name) {
  return std::ranges::any_of(config::SettingsOf(process).FileFormats(),
                             [&](const auto& format) { return name.ends_with(format.suffix); });
}

/// Returns the only process with files of such a name; with `any`, the first process with such
/// files.
const ProcessInfo* OwnerOf(std::string_view name, bool any) {
  for (const ProcessInfo& info : kProcesses)
    for (const config::FileFormat& format : config::SettingsOf(info.process).FileFormats())
      if ((any || format.alone) && name.ends_with(format.suffix)) return &info;
  return nullptr;
}

/// Returns the value of a setting among `key = value` lines; empty if it is missing.
std::string_view ValueOf(std::string_view settings_text, std::string_view key) {
  constexpr std::string_view kEquals = " = ";
  for (const std::string_view line : Split(settings_text, "\n"))
    if (line.starts_with(key) && line.substr(key.size()).starts_with(kEquals))
      return line.substr(key.size() + kEquals.size());
  return "";
}

/// Returns the default value of a setting.
std::string_view StandardOf(std::string_view key, Process process) {
  const int index = config::FindSetting(key, process);
  return config::SettingsTable(process)[static_cast<size_t>(index)].standard;
}

absl::Status Contradiction(const std::string& output, std::string_view what,
                           std::string_view made) {
  return Malformed(
      fmt::format("--output {}: the name means {}, but the job makes {}: choose another name, or "
                  "state the format with --format",
                  output, what, made));
}

}  // namespace

absl::Status CheckEnding(const std::string& output, Process process) {
  const std::string name = LowerCase(output);
  if (HasEnding(process, name)) return absl::OkStatus();
  if (const ProcessInfo* owner = OwnerOf(name, /*any=*/false))
    return Malformed(
        fmt::format("--output {}: files with this ending need --machine {}", output, owner->name));
  for (const OtherFile& other : kOtherFiles) {
    std::string_view rest = other.endings;
    while (!rest.empty()) {
      const std::string_view ending = rest.substr(0, rest.find(' '));
      rest.remove_prefix(std::min(rest.size(), ending.size() + 1));
      if (name.ends_with(ending)) return Contradiction(output, other.what, EndingsOf(process));
    }
  }
  return absl::OkStatus();
}

absl::Status CheckFormat(const std::string& output, Process process,
                         std::string_view settings_text) {
  const std::string name = LowerCase(output);
  const std::vector<config::FileFormat> formats = config::SettingsOf(process).FileFormats();
  // The settings may select several formats, such as *.ngc and *.nc of a mill. If the first one is
  // an archive, only it is made.
  const auto is_made = [&](const config::FileFormat& format) {
    return ValueOf(settings_text, format.key) == format.value;
  };
  const auto made = std::ranges::find_if(formats, is_made);
  if (made == formats.end()) return absl::OkStatus();
  const config::FileFormat* other = nullptr;
  for (const config::FileFormat& format : formats) {
    if (!name.ends_with(format.suffix)) continue;
    if (&format == &*made || (is_made(format) && !made->archive)) return absl::OkStatus();
    other = &format;
  }
  if (other == nullptr) return absl::OkStatus();
  return Contradiction(output, fmt::format("{} = {}", other->key, other->value),
                       fmt::format("{} = {} (a file *{})", made->key, made->value, made->suffix));
}

absl::StatusOr<std::vector<config::Setting>> FormatSettings(const std::string& format,
                                                            Process process) {
  std::vector<std::string_view> names;
  const std::vector<config::FileFormat> formats = config::SettingsOf(process).FileFormats();
  for (const config::FileFormat& each : formats) {
    names.push_back(each.suffix.substr(1));
    if (names.back() != format) continue;
    std::vector<config::Setting> settings;
    const auto set = [&](std::string_view key, std::string_view value) {
      if (std::ranges::find(settings, key, &config::Setting::key) == settings.end())
        settings.push_back({std::string(key), std::string(value), config::Source::kRequest});
    };
    set(each.key, each.value);
    for (const config::FileFormat& other : formats) set(other.key, StandardOf(other.key, process));
    return settings;
  }
  if (const ProcessInfo* owner = OwnerOf("." + format, /*any=*/true))
    return Malformed(
        fmt::format("--format {}: this format needs --machine {}", format, owner->name));
  const std::string nearest = config::Nearest(format, names);
  return Malformed(fmt::format("--format {}: unknown format{}; --machine {} makes {}", format,
                               nearest.empty() ? "" : fmt::format("; do you mean {}?", nearest),
                               ProcessName(process), EndingsOf(process)));
}

}  // namespace slicefarm::cli
