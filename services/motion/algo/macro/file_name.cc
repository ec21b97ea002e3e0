#include "services/motion/algo/macro/file_name.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "common/base/text.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion {
namespace {

constexpr size_t kMostNameBytes = 240;  // the limit of file systems is 255
constexpr std::string_view kArchiveEnding = ".gcode.3mf";
constexpr std::string_view kBinaryEnding = ".bgcode";
constexpr std::string_view kTextEnding = ".gcode";
constexpr std::string_view kEndings[] = {kArchiveEnding, kBinaryEnding, kTextEnding};

/// Returns true if all file systems accept the character in a name.
bool MayStandInName(char c) {
  return !IsControl(c) && std::string_view("/\\:*?\"<>|").find(c) == std::string_view::npos;
}

bool EndsWithAnyCase(std::string_view text, std::string_view ending) {
  if (text.size() < ending.size()) return false;
  text.remove_prefix(text.size() - ending.size());
  for (size_t i = 0; i < text.size(); ++i) {
    const char c =
        text[i] >= 'A' && text[i] <= 'Z' ? static_cast<char>(text[i] - 'A' + 'a') : text[i];
    if (c != ending[i]) return false;
  }
  return true;
}

/// Removes the last bytes, without splitting a character.
void Shorten(size_t most, std::string& text) {
  if (text.size() <= most) return;
  while (most > 0 && (text[most] & 0xc0) == 0x80) --most;
  text.resize(most);
}

}  // namespace

std::string ShortTime(double seconds) {
  const auto whole = static_cast<int64_t>(std::floor(seconds));
  if (whole < 60) return std::to_string(whole) + "s";
  const int64_t minutes = (whole + 30) / 60;
  const std::string rest = std::to_string(minutes % 60) + "m";
  if (minutes < 60) return rest;
  const int64_t hours = minutes / 60;
  if (hours < 24) return std::to_string(hours) + "h" + rest;
  return std::to_string(hours / 24) + "d" + std::to_string(hours % 24) + "h" + rest;
}

std::string FileName(std::string_view filled_in, const WritingOptions& writing) {
  std::string name(Trim(filled_in));
  for (char& c : name)
    if (!MayStandInName(c)) c = '_';
  std::string ending(writing.archive  ? kArchiveEnding
                     : writing.binary ? kBinaryEnding
                                      : kTextEnding);
  const auto known = std::ranges::find_if(
      kEndings, [&](std::string_view each) { return EndsWithAnyCase(name, each); });
  if (known != std::end(kEndings)) {
    name.resize(name.size() - known->size());
  } else if (const size_t dot = name.rfind('.');
             dot != std::string::npos && dot > 0 && dot + 1 < name.size()) {
    ending = name.substr(dot);
    name.resize(dot);
  }
  Shorten(kMostNameBytes - std::min(ending.size(), kMostNameBytes / 2), name);
  Shorten(kMostNameBytes / 2, ending);
  if (name.empty() || name == "." || name == "..") name = "print";
  return name + ending;
}

}  // namespace slicefarm::motion
