#include "common/config/presets/overlay_names.h"

#include <fmt/core.h>

#include "absl/strings/ascii.h"

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

std::vector<std::string> OverlayNames(std::string_view printer, std::string_view filament) {
  return {OverlayName(printer), OverlayName(printer, filament)};
}

}  // namespace slicefarm::config::presets
