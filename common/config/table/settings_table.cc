#include "common/config/table/settings_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "absl/strings/str_join.h"
#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/table/suggest.h"
#include "common/gcode/substitutions.h"
#include "common/model/fields/field_text.h"
#include "common/model/limits.h"
#include "common/model/options/advance_model.h"
#include "common/model/options/cutter.h"
#include "common/model/options/cutter_text.h"
#include "common/model/options/fill_angles.h"
#include "common/model/options/flow_table.h"
#include "common/model/options/height_code.h"
#include "common/model/options/layer_heights.h"
#include "common/model/options/solid_layers.h"

namespace slicefarm::config {
namespace {

std::vector<SettingSpec> MakeTable(Process process) {
  std::vector<SettingSpec> table = SpecsOf(process);
  std::sort(table.begin(), table.end(),
            [](const SettingSpec& a, const SettingSpec& b) { return a.key < b.key; });
  return table;
}

std::string Range(const SettingSpec& spec) {
  return fmt::format("{} to {}", PrintNumber(spec.min), PrintNumber(spec.max));
}

absl::Status MalformedError(const SettingSpec& spec, std::string_view text,
                            std::string_view expected) {
  constexpr size_t kQuoted = 60;
  const std::string quoted =
      fmt::format("{}{}", text.substr(0, kQuoted), text.size() > kQuoted ? "..." : "");
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{} = '{}': {}", spec.key, quoted, expected),
                   {{"setting", std::string(spec.key)}, {"value", quoted}});
}

absl::StatusOr<Value> ParseFlag(const SettingSpec& spec, std::string_view text) {
  if (text == "1" || text == "true") return Value{.number = 1};
  if (text == "0" || text == "false") return Value{.number = 0};
  return MalformedError(spec, text, "must be 0 or 1");
}

absl::StatusOr<Value> ParseChoice(const SettingSpec& spec, std::string_view text) {
  for (const Choice& choice : spec.choices) {
    if (choice.name == text) return Value{.number = static_cast<double>(choice.value)};
  }
  std::vector<std::string_view> names;
  for (const Choice& choice : spec.choices)
    if (choice.note.empty()) names.push_back(choice.name);
  const std::string nearest = Nearest(text, names);
  return MalformedError(spec, text,
                        fmt::format("must be {}{}", DescribeRange(spec),
                                    nearest.empty() ? "" : "; do you mean " + nearest + "?"));
}

absl::StatusOr<Value> ParseQuantity(const SettingSpec& spec, std::string_view text) {
  const bool percent = spec.kind == Kind::kPercent || spec.kind == Kind::kNumberOrPercent;
  absl::StatusOr<Value> value = ParseNumber(text, percent);
  const bool whole =
      spec.kind != Kind::kInteger || !value.ok() || value->number == std::floor(value->number);
  if (!value.ok() || !whole) {
    return MalformedError(spec, text,
                          fmt::format("must be a {}{}, {}{}{}", whole ? "number" : "whole number",
                                      percent ? " or a percentage" : "", Range(spec),
                                      spec.unit.empty() ? "" : " ", spec.unit));
  }
  if (spec.kind == Kind::kPercent) value->percent = false;
  if (value->percent) {
    if (value->number < 0) return CheckRange(spec, value->number, text);
    return value;
  }
  if (absl::Status status = CheckRange(spec, value->number, text); !status.ok()) return status;
  return value;
}

/// Control characters would break the line or the G-code that quotes the text.
absl::StatusOr<Value> ParseText(const SettingSpec& spec, std::string text) {
  const bool lines = spec.kind == Kind::kGcode;
  const bool clean = std::none_of(text.begin(), text.end(), [&](char c) {
    return IsControl(c) && !(lines && (c == '\n' || c == '\r' || c == '\t'));
  });
  if (!clean) return MalformedError(spec, text, "must not contain control characters");
  // A line of the effective text cannot preserve blanks at the ends of its value.
  return Value{.text = std::string(Trim(text, " \t"))};
}

template <class T>
absl::StatusOr<Value> Canonical(const SettingSpec& spec, std::string_view text,
                                const absl::StatusOr<T>& parsed, std::string (*print)(const T&)) {
  if (!parsed.ok()) return MalformedError(spec, text, std::string(parsed.status().message()));
  return Value{.text = print(*parsed)};
}

template <class T>
absl::StatusOr<Value> ParseField(const SettingSpec& spec, std::string_view text,
                                 absl::StatusOr<T> (*parse)(std::string_view),
                                 std::string (*print)(const T&)) {
  if (text.empty()) return Value{};
  return Canonical<T>(spec, text, parse(text), print);
}

/// Checks a list of texts. The list is parsed again when G-code is written.
absl::StatusOr<Value> ParseSubstitutions(const SettingSpec& spec, std::string_view text) {
  const std::vector<std::string> items = gcode::TextsOfList(text);
  const auto read = gcode::Substitutions::Of(items);
  if (!read.ok()) return MalformedError(spec, text, std::string(read.status().message()));
  if (std::ranges::any_of(text, IsControl))
    return MalformedError(spec, text, "must not contain control characters");
  std::string list;
  for (const std::string& item : items)
    list += (&item == &items.front() ? "" : ";") + QuoteText(item);
  return Value{.text = std::move(list)};
}

/// Parses a cutter. The message about impossible measures is passed on unchanged.
absl::StatusOr<Value> ParseCutterValue(const SettingSpec& spec, std::string_view text) {
  const absl::StatusOr<Cutter> cutter = ParseCutter(text);
  if (cutter.ok()) return Value{.text = cutter->name()};
  const ErrorDetail detail = DetailOf(cutter.status());
  if (detail.reason != Reason::kSettingMalformed) return cutter.status();
  return MalformedError(spec, text, fmt::format("must be one of {}", kCutterForms));
}

std::string_view FirstItem(const SettingSpec& spec, std::string_view text) {
  if (spec.list == List::kNone) return text;
  return Trim(text.substr(0, text.find_first_of(",;")));
}

}  // namespace

std::span<const SettingSpec> SettingsTable(Process process) {
  static const auto& tables = *new std::vector<std::vector<SettingSpec>>([] {
    std::vector<std::vector<SettingSpec>> made;
    for (const ProcessInfo& info : kProcesses) made.push_back(MakeTable(info.process));
    return made;
  }());
  return tables[static_cast<size_t>(process)];
}

int FindSetting(std::string_view key, Process process) {
  const auto table = SettingsTable(process);
  const auto found =
      std::lower_bound(table.begin(), table.end(), key,
                       [](const SettingSpec& spec, std::string_view k) { return spec.key < k; });
  return found == table.end() || found->key != key ? -1 : static_cast<int>(found - table.begin());
}

absl::StatusOr<Value> ParseValue(const SettingSpec& spec, std::string_view text) {
  text = Trim(text);
  switch (spec.kind) {
    case Kind::kText:
    case Kind::kGcode:
      return ParseText(spec, spec.list == List::kNone ? Unescape(text) : TextOfList(text));
    case Kind::kFlag:
      return ParseFlag(spec, FirstItem(spec, text));
    case Kind::kChoice:
      return ParseChoice(spec, FirstItem(spec, text));
    case Kind::kBedShape:
      return Canonical<Polygon>(spec, text, ParseBedShape(text), PrintBedShape);
    case Kind::kAreas:
      return Canonical<std::vector<Polygon>>(spec, text, ParseAreas(text), PrintAreas);
    case Kind::kPoint:
      return Canonical<Point>(spec, text, ParsePoint(FirstItem(spec, text)), PrintPoint);
    case Kind::kSizes:
      return Canonical<std::vector<ThumbnailSize>>(spec, text, ParseSizes(text), PrintSizes);
    case Kind::kDensityField:
      return ParseField<DensityField>(spec, text, ParseDensityField, PrintDensityField);
    case Kind::kStressField:
      return ParseField<StressField>(spec, text, ParseStressField, PrintStressField);
    case Kind::kMaterialField:
      return ParseField<MaterialField>(spec, text, ParseMaterialField, PrintMaterialField);
    case Kind::kAngles:
      return ParseField<std::vector<AngleStep>>(spec, text, ParseFillAngles, PrintFillAngles);
    case Kind::kSolidLayers:
      return ParseField<std::vector<LayerGroup>>(spec, text, ParseSolidLayers, PrintSolidLayers);
    case Kind::kFlowTable:
      return Canonical<FlowTable>(spec, text, ParseFlowTable(Unescape(text)), PrintFlowTable);
    case Kind::kAdvancePoints:
      return Canonical<std::vector<AdvancePoint>>(spec, text, ParseAdvancePoints(Unescape(text)),
                                                  PrintAdvancePoints);
    case Kind::kHeightCode:
      return Canonical<std::vector<HeightCode>>(spec, text, ParseHeightCodes(text),
                                                PrintHeightCodes);
    case Kind::kLayerHeights:
      return Canonical<std::vector<LayerHeightAt>>(spec, text, ParseLayerHeights(text),
                                                   PrintLayerHeights);
    case Kind::kSubstitutions:
      return ParseSubstitutions(spec, text);
    case Kind::kCutter:
      return ParseCutterValue(spec, text);
    default:
      return ParseQuantity(spec, FirstItem(spec, text));
  }
}

absl::Status CheckRange(const SettingSpec& spec, double number, std::string_view written) {
  if (spec.min <= number && number <= spec.max) return absl::OkStatus();
  const std::string comes_to =
      spec.kind == Kind::kNumberOrPercent && written.ends_with("%") && number >= 0
          ? fmt::format(" (that is, {})", PrintNumber(number))
          : "";
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} = {}{} is out of range: it must be {}{}{}", spec.key, written,
                               comes_to, Range(spec), spec.unit.empty() ? "" : " ", spec.unit),
                   {{"setting", std::string(spec.key)},
                    {"value", std::string(written)},
                    {"min", PrintNumber(spec.min)},
                    {"max", PrintNumber(spec.max)}});
}

std::string PrintValue(const SettingSpec& spec, const Value& value) {
  switch (spec.kind) {
    case Kind::kText:
    case Kind::kGcode:
      return spec.list == List::kNone ? Escape(value.text) : QuoteText(value.text);
    case Kind::kBedShape:
    case Kind::kAreas:
    case Kind::kPoint:
    case Kind::kSizes:
    case Kind::kDensityField:
    case Kind::kStressField:
    case Kind::kMaterialField:
    case Kind::kAngles:
    case Kind::kSolidLayers:
    case Kind::kFlowTable:
    case Kind::kAdvancePoints:
    case Kind::kHeightCode:
    case Kind::kLayerHeights:
    case Kind::kSubstitutions:
    case Kind::kCutter:
      return value.text.str();
    case Kind::kChoice: {
      const auto meant =
          std::find_if(spec.choices.begin(), spec.choices.end(), [&](const Choice& c) {
            return c.note.empty() && c.value == static_cast<int>(value.number);
          });
      return meant == spec.choices.end() ? "" : std::string(meant->name);
    }
    default:
      const bool percent = value.percent || spec.kind == Kind::kPercent;
      return PrintNumber(value.number) + (percent ? "%" : "");
  }
}

bool IsStandard(const SettingSpec& spec, std::string_view written) {
  if (spec.standard == kNotSet) return Trim(written) == kNotSet;
  const auto given = ParseValue(spec, written);
  const auto standard = ParseValue(spec, spec.standard);
  return given.ok() && standard.ok() && *given == *standard;
}

std::string DescribeRange(const SettingSpec& spec) {
  switch (spec.kind) {
    case Kind::kFlag:
      return "0 or 1";
    case Kind::kChoice: {
      std::vector<std::string> names;
      for (const Choice& choice : spec.choices) {
        if (choice.note.empty()) names.emplace_back(choice.name);
      }
      return "one of " + absl::StrJoin(names, ", ");
    }
    case Kind::kText:
      return "text";
    case Kind::kGcode:
      return "G-code, \\n between lines";
    case Kind::kBedShape:
      return "three or more corners XxY";
    case Kind::kAreas:
      return "three or more corners XxY, or none";
    case Kind::kPoint:
      return "XxY";
    case Kind::kSizes:
      return fmt::format(
          "up to {} WIDTHxHEIGHT, WIDTHxHEIGHT/PNG, /JPG, /QOI, /BTT_TFT or /COLPIC, 1 to {} each",
          limits::kMaxThumbnails, limits::kMaxThumbnailPx);
    case Kind::kDensityField:
    case Kind::kStressField:
    case Kind::kMaterialField:
      return "a field as JSON on one line";
    case Kind::kAngles:
      return "angles by layer, as 0,90 or +30 or 45#2";
    case Kind::kSolidLayers:
      return "layers, as 5 or 5#2 or 1,7,9";
    case Kind::kFlowTable:
      return "LENGTH,FACTOR;LENGTH,FACTOR;... from 0 mm up to factor 1";
    case Kind::kAdvancePoints:
      return "ADVANCE,FLOW,ACCELERATION;... in mm3/s and mm/s2, or empty";
    case Kind::kHeightCode:
      return "a JSON list as [{\"z\":1.2,\"type\":\"pause\",\"text\":\"...\"}]";
    case Kind::kLayerHeights:
      return "Z;HEIGHT;Z;HEIGHT;... upwards, mm";
    case Kind::kSubstitutions:
      return "\"pattern\";\"replacement\";\"flags\";\"notes\", and so on";
    case Kind::kCutter:
      return std::string(kCutterForms);
    case Kind::kNumberOrPercent:
      return fmt::format("{}, or % of {}", Range(spec),
                         spec.relative_to.empty() ? spec.percent_of : spec.relative_to);
    default:
      return Range(spec);
  }
}

}  // namespace slicefarm::config
