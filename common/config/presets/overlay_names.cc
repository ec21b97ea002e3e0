#include "common/config/presets/overlay_names.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "absl/strings/ascii.h"
#include "common/base/revision_ref.h"

namespace slicefarm::config::presets {
namespace {

void Append(std::string_view preset, std::string& name) {
  char before = 0;
  for (const char c : preset) {
    const auto byte = static_cast<unsigned char>(c);
    if (absl::ascii_isalnum(byte) || c == '-' || c == '.') {
      name += c;
    } else if (c == ' ' && before != ' ') {
      name += '_';
    } else {
      name += fmt::format("__{:02X}", byte);
    }
    before = c;
  }
}

}  // namespace

std::string OverlayName(std::string_view printer, std::string_view filament) {
  std::string name = "overlay.";
  Append(printer, name);
  if (filament.empty()) return name;
  name += "__with__";  // `wi` are no hex digits
  Append(filament, name);
  return name;
}

absl::StatusOr<std::vector<std::string>> WithOverlays(const PresetNames& presets,
                                                      std::vector<std::string> profiles,
                                                      const NewestRevision& newest) {
  std::vector<std::string> all;
  for (const std::string_view filament : {std::string_view(), std::string_view(presets.filament)}) {
    const std::string name = OverlayName(presets.printer, filament);
    const auto is_named = [&](const std::string& ref) {
      const auto of = ParseRevisionRef(ref);
      return of.ok() && of->name == name;
    };
    if (std::ranges::any_of(profiles, is_named)) continue;
    const auto revision = newest(name);
    if (absl::IsNotFound(revision.status())) continue;
    if (!revision.ok()) return revision.status();
    all.push_back(fmt::format("{}@{}", name, *revision));
  }
  std::ranges::move(profiles, std::back_inserter(all));
  return all;
}

}  // namespace slicefarm::config::presets
