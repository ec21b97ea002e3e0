#include "common/model/options/height_code.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/base/text.h"
#include "common/model/limits.h"

namespace slicefarm {
namespace {

using HeightJson = nlohmann::ordered_json;

constexpr std::pair<HeightCodeKind, std::string_view> kKinds[] = {
    {HeightCodeKind::kColorChange, "color_change"},
    {HeightCodeKind::kPause, "pause"},
    {HeightCodeKind::kTemplate, "template"},
    {HeightCodeKind::kCustom, "custom"},
    {HeightCodeKind::kRetractLength, "retract_length"}};

absl::Status BadCode(std::string_view why) {
  return absl::InvalidArgumentError(
      fmt::format(R"(a list as [{{"z":1.2,"type":"pause","text":"..."}}]: {})", why));
}

absl::StatusOr<HeightCodeKind> KindOf(const HeightJson& entry) {
  const auto type = entry.find("type");
  if (type != entry.end() && type->is_string())
    for (const auto& [kind, name] : kKinds)
      if (type->get_ref<const std::string&>() == name) return kind;
  return BadCode("type must be color_change, pause, template, custom or retract_length");
}

absl::StatusOr<Coord> HeightOf(const HeightJson& entry) {
  const auto z = entry.find("z");
  const double most_mm = ToMm(static_cast<double>(limits::kMaxPrintHeight));
  const bool good =
      z != entry.end() && z->is_number() && z->get<double>() > 0 && z->get<double>() <= most_mm;
  if (!good) return BadCode(fmt::format("z must be in mm, above 0 and up to {}", most_mm));
  return FromMm(z->get<double>());
}

/// Returns true if a text contains no control characters except line ends and tabs.
bool IsClean(std::string_view text) {
  return std::ranges::none_of(
      text, [](char c) { return IsControl(c) && c != '\n' && c != '\r' && c != '\t'; });
}

absl::StatusOr<HeightCode> CodeOf(const HeightJson& entry) {
  if (!entry.is_object()) return BadCode("each item must be an object");
  for (const auto& [key, value] : entry.items())
    if (key != "z" && key != "type" && key != "text")
      return BadCode(fmt::format("unknown entry '{:.40}'", key));
  const auto kind = KindOf(entry);
  if (!kind.ok()) return kind.status();
  const auto height = HeightOf(entry);
  if (!height.ok()) return height.status();
  HeightCode code{*height, *kind, {}};
  const auto text = entry.find("text");
  if (text == entry.end() && code.kind != HeightCodeKind::kRetractLength) return code;
  if (text == entry.end() || !text->is_string() || !IsClean(text->get_ref<const std::string&>()))
    return BadCode("text must be a string without control characters");
  code.text = text->get<std::string>();
  const bool lines = code.text.find_first_of("\r\n") != std::string::npos;
  if (lines && code.kind != HeightCodeKind::kCustom)
    return BadCode("text must be one line, except for type custom");
  if (code.kind == HeightCodeKind::kRetractLength && !RetractLengthMm(code))
    return BadCode(fmt::format("text of retract_length must be a length from 0 to {} mm",
                               kMaxRetractLengthMm));
  return code;
}

}  // namespace

std::optional<double> RetractLengthMm(const HeightCode& code) {
  const auto length = ToNumber(code.text);
  const bool good = length && *length >= 0 && *length <= kMaxRetractLengthMm;
  return good ? length : std::nullopt;
}

absl::StatusOr<std::vector<HeightCode>> ParseHeightCodes(std::string_view text) {
  std::vector<HeightCode> codes;
  if (Trim(text).empty()) return codes;
  // A list of codes has no deeper nesting. The limit stops texts that are nested a million times.
  const auto is_flat = [](int depth, HeightJson::parse_event_t, const HeightJson&) {
    return depth <= 2;
  };
  const HeightJson list =
      HeightJson::parse(text.begin(), text.end(), is_flat, /*allow_exceptions=*/false);
  if (!list.is_array()) return BadCode("it must be a JSON list");
  if (list.size() > kMaxHeightCodes)
    return BadCode(
        fmt::format("the list has {} items, at most {} are allowed", list.size(), kMaxHeightCodes));
  for (const HeightJson& entry : list) {
    auto code = CodeOf(entry);
    if (!code.ok()) return code.status();
    codes.push_back(*std::move(code));
  }
  std::ranges::stable_sort(codes, {}, &HeightCode::print_z_nm);
  return codes;
}

std::string PrintHeightCodes(const std::vector<HeightCode>& codes) {
  if (codes.empty()) return {};
  HeightJson list = HeightJson::array();
  for (const HeightCode& code : codes) {
    const auto kind = std::ranges::find(kKinds, code.kind, [](const auto& k) { return k.first; });
    HeightJson entry = {{"z", ToMm(static_cast<double>(code.print_z_nm))}, {"type", kind->second}};
    if (!code.text.empty()) entry["text"] = code.text;
    list.push_back(std::move(entry));
  }
  return list.dump(-1, ' ', /*ensure_ascii=*/false, HeightJson::error_handler_t::replace);
}

}  // namespace slicefarm
