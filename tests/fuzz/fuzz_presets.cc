#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "common/base/text.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/job_presets.h"
#include "common/config/presets/read_presets.h"

namespace {

using slicefarm::config::presets::PresetFile;

/// Returns an archive as one file. Other bytes are files that begin with their path on a line of
/// its own, separated by the byte 1.
std::vector<PresetFile> FilesOf(std::string_view bytes) {
  if (slicefarm::config::presets::IsArchive(bytes)) return {{"a.bbscfg", std::string(bytes)}};
  std::vector<PresetFile> files;
  for (const std::string_view part : slicefarm::Split(bytes, "\x01")) {
    const size_t line = part.find('\n');
    if (line == std::string_view::npos) continue;
    files.push_back({std::string(part.substr(0, line)), std::string(part.substr(line + 1))});
  }
  return files;
}

}  // namespace

// Checks that presets in any files can be flattened or have an error. If presets can be chosen for
// a job, the job must have each setting once.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace presets = slicefarm::config::presets;
  const auto set = presets::ReadPresets(FilesOf({reinterpret_cast<const char*>(data), size}));
  if (!set.ok()) return 0;
  for (const presets::Preset& preset : set->presets()) {
    const bool whole = set->Lineage(preset).ok();
    if (set->Flatten(preset).ok() != whole) std::abort();
    if (preset.kind != presets::PresetKind::kPrinter) continue;
    const auto chosen = presets::ChoosePresets(*set, {preset.name, "", ""});
    if (!chosen.ok()) continue;
    const auto values = presets::CombinePresets(*set, *chosen);
    if (!values.ok()) std::abort();
    for (size_t i = 1; i < values->size(); ++i)
      if ((*values)[i - 1].key >= (*values)[i].key) std::abort();
    if (!presets::SettingsOfPresets(*set, *chosen).ok()) std::abort();
  }
  return 0;
}
