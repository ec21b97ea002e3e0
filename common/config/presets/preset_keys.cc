#include "common/config/presets/preset_keys.h"

#include <array>
#include <set>

#include "common/base/text.h"
#include "common/config/presets/orca_defaults.h"
#include "common/config/presets/prusa_keys.h"

namespace slicefarm::config::presets {
namespace {

constexpr std::array kKinds = {PresetKind::kPrinter, PresetKind::kProcess, PresetKind::kFilament};

using KeySet = std::set<std::string_view>;
using KeysByKind = std::array<KeySet, kKinds.size()>;

std::string_view OrcaLines(PresetKind kind) {
  switch (kind) {
    case PresetKind::kPrinter:
      return OrcaPrinterDefaults();
    case PresetKind::kProcess:
      return OrcaProcessDefaults();
    case PresetKind::kFilament:
      return OrcaFilamentDefaults();
  }
  return "";
}

const KeysByKind& OrcaKeys() {
  static const auto* const keys = [] {
    auto* made = new KeysByKind;
    for (const PresetKind kind : kKinds)
      for (const std::string_view line : Split(OrcaLines(kind), "\n"))
        (*made)[static_cast<size_t>(kind)].insert(Trim(line.substr(0, line.find('='))));
    return made;
  }();
  return *keys;
}

const KeysByKind& KeysOfPrusa() {
  static const auto* const keys = [] {
    auto* made = new KeysByKind;
    for (const PresetKind kind : kKinds)
      for (const std::string_view key : Split(PrusaKeys(kind), " "))
        (*made)[static_cast<size_t>(kind)].insert(key);
    return made;
  }();
  return *keys;
}

}  // namespace

bool MayHaveKey(PresetKind kind, PresetDialect dialect, std::string_view key) {
  const KeysByKind& keys = dialect == PresetDialect::kOrca ? OrcaKeys() : KeysOfPrusa();
  if (keys[static_cast<size_t>(kind)].contains(key)) return true;
  for (const KeySet& each : keys)
    if (each.contains(key)) return false;
  return true;
}

const std::vector<std::pair<std::string_view, std::string_view>>& OrcaDefaultsOf(PresetKind kind) {
  using Defaults = std::vector<std::pair<std::string_view, std::string_view>>;
  static const auto* const defaults = [] {
    auto* made = new std::array<Defaults, kKinds.size()>;
    for (const PresetKind each : kKinds) {
      for (const std::string_view line : Split(OrcaLines(each), "\n")) {
        const size_t equals = line.find('=');
        if (equals != std::string_view::npos)
          (*made)[static_cast<size_t>(each)].emplace_back(Trim(line.substr(0, equals)),
                                                          Trim(line.substr(equals + 1)));
      }
    }
    return made;
  }();
  return (*defaults)[static_cast<size_t>(kind)];
}

}  // namespace slicefarm::config::presets
