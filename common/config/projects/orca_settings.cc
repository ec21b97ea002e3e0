#include "common/config/projects/orca_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "common/base/text.h"
#include "common/config/projects/orca_dialect.h"
#include "common/config/projects/orca_gcode.h"
#include "common/config/projects/orca_legacy.h"
#include "common/config/projects/orca_mesh.h"
#include "common/config/projects/orca_pairs.h"
#include "common/config/projects/orca_percent.h"
#include "common/config/projects/orca_placeholders.h"
#include "common/config/projects/orca_weights.h"
#include "common/config/table/known_keys.h"
#include "common/config/table/orca_table.h"
#include "common/config/table/settings_table.h"
#include "common/config/table/value.h"

namespace slicefarm::config {
namespace {

using ByKey = std::map<std::string_view, const Setting*>;

/// Returns the items of a list in OrcaSlicer's form, or nullopt if the text is not a list.
std::optional<std::vector<std::string>> ItemsOf(std::string_view text) {
  if (!text.starts_with('[')) return std::nullopt;
  const auto list = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
  if (!list.is_array()) return std::nullopt;
  std::vector<std::string> items;
  for (const auto& item : list)
    items.push_back(item.is_string() ? Escape(item.get_ref<const std::string&>()) : item.dump());
  return items;
}

/// Returns a single value, or the item at `index` of a list. Returns the first item if there is
/// none at `index`, and nullopt for an empty list.
std::optional<std::string> ItemOf(std::string_view text, size_t index) {
  const std::optional<std::vector<std::string>> items = ItemsOf(text);
  if (!items) return std::string(text);
  if (items->empty()) return std::nullopt;
  return (*items)[index < items->size() ? index : 0];
}

std::optional<std::string> FirstOf(std::string_view text) { return ItemOf(text, 0); }

std::string Joined(std::string_view text, std::string_view separator) {
  const std::optional<std::vector<std::string>> items = ItemsOf(text);
  if (!items) return std::string(text);
  std::string joined;
  for (const std::string& item : *items)
    joined.append(joined.empty() ? "" : separator).append(item);
  return joined;
}

/// Removes quotes from pairs of numbers. They may be quoted in a list that is a single text.
std::string WithoutQuotes(std::string text) {
  std::erase(text, '"');
  return text;
}

/// Returns a point as `XxY`.
std::string PointOf(std::string text) {
  if (text.find('x') == text.npos) std::ranges::replace(text, ',', 'x');
  return text;
}

/// Value in PrusaSlicer's form, with a flag for exact equivalence.
struct Converted {
  std::optional<std::string> text;
  bool exact = true;
};

class OrcaReader {
 public:
  OrcaReader(std::span<const Setting> settings, size_t filament) : filament_(filament) {
    for (const Setting& setting : settings) by_key_[setting.key] = &setting;
    TakeTemperaturesOfBed();
  }

  void Apply(const OrcaRow& row) {
    const auto found = by_key_.find(row.from);
    if (found == by_key_.end()) return;
    const Setting& setting = *found->second;
    known_.emplace(row.from);
    const Converted value = ConvertAll(row, setting.value);
    if (!value.exact || !value.text) inexact_.emplace(row.from);
    const bool chosen = row.value == OrcaValue::kChoice && !row.to.starts_with("support_material");
    if (chosen && (!value.exact || !value.text)) stand_ins_.emplace(row.from);
    if (value.text && !value.text->empty()) Set(row.to, *value.text, setting.source);
    // An empty text is a valid value for G-code and similar settings. A choice without a value is
    // ignored.
    if (value.text && value.text->empty() &&
        (row.value == OrcaValue::kSame || row.value == OrcaValue::kGcode))
      Set(row.to, "", setting.source);
  }

  std::vector<Setting> Take() && { return std::move(settings_); }

  OrcaUnused Unused(std::span<const Setting> settings) const {
    OrcaUnused unused;
    for (const Setting& setting : settings) {
      if (by_key_.find(setting.key)->second != &setting) continue;  // a later one wins
      const bool known = known_.contains(setting.key);
      const OrcaWeight weight = known ? OrcaWeight::kDetail : WeightOf(setting.key, setting.value);
      if (stand_ins_.contains(setting.key) || weight == OrcaWeight::kPrint)
        unused.of_print.push_back(setting.key + " = " + ShortValue(setting.value));
      else if (inexact_.contains(setting.key))
        unused.others.push_back(setting.key + " = " + ShortValue(setting.value) +
                                ": no exact counterpart");
      else if (!known && weight == OrcaWeight::kDetail)
        unused.others.push_back(setting.key + ": " + std::string(WhyIdle(setting.key)));
    }
    return unused;
  }

  /// Converts settings that depend on a second setting.
  void TakePairs() {
    TakeDialect();
    TakeSlopes();
    TakeOrganicTrees();
    for (const std::string_view key : {"pressure_advance", "enable_pressure_advance"})
      if (by_key_.contains(key)) known_.emplace(key);
    const auto advance = by_key_.find("pressure_advance");
    if (advance != by_key_.end() && IsOn("enable_pressure_advance"))
      if (const auto first = FirstOf(advance->second->value); first && !first->empty())
        Set("pressure_advance", *first, advance->second->source);
    TakeAddedGcode();
    TakePairedSettings();
  }

 private:
  OrcaLookup Lookup() {
    return [this](std::string_view key) -> std::optional<std::string> {
      const auto found = by_key_.find(key);
      if (found == by_key_.end()) return std::nullopt;
      known_.emplace(key);
      return ItemOf(found->second->value, filament_);
    };
  }

  /// Adds settings for output that the project's program writes without a setting.
  void TakeDialect() {
    for (const Setting& setting : DialectOf(Lookup()))
      Set(setting.key, setting.value, setting.source);
  }

  /// Adds the lines that the project's program writes because of settings for fans and cameras.
  void TakeAddedGcode() {
    for (const AddedGcode& added : AddedGcodeOf(Lookup()))
      Set(added.key, WithGcode(Given(added.key), added),
          by_key_.find(added.because)->second->source);
  }

  /// Converts settings that follow from several settings.
  void TakePairedSettings() {
    for (const PairedSetting& paired : PairedSettingsOf(Lookup()))
      Set(paired.key, paired.value, by_key_.find(paired.because)->second->source);
  }

  /// Returns the converted value of a setting so far, or an empty text.
  std::string Given(std::string_view key) const {
    const auto found = index_.find(key);
    return found == index_.end() ? "" : settings_[found->second].value;
  }

  /// Returns the effective kind of lift: the filament's own kind, or else the machine's kind.
  std::string LiftType() const {
    for (const std::string_view key : {"filament_z_hop_types", "z_hop_types"}) {
      const auto found = by_key_.find(key);
      if (found == by_key_.end()) continue;
      std::string type = FirstOf(found->second->value).value_or("");
      if (!type.empty() && type != kNotSet) return type;
    }
    return "";
  }

  /// Converts slope lifts, which rise by z_hop at travel_slope (default 3 degrees), and automatic
  /// lifts, which are slopes where the nozzle meets nothing and steeper elsewhere. Spiral lifts
  /// rise on a circle with this slope.
  void TakeSlopes() {
    const std::string type = LiftType();
    for (const std::string_view key : {"z_hop_types", "filament_z_hop_types", "travel_slope"}) {
      const auto found = by_key_.find(key);
      if (found == by_key_.end()) continue;
      known_.emplace(key);
    }
    if (type != "Slope Lift" && type != "Auto Lift" && type != "Spiral Lift") return;
    constexpr Source kSource = Source::kProfile;
    if (type == "Auto Lift") Set("travel_lift_before_obstacle", "1", kSource);
    if (type == "Spiral Lift") Set("travel_spiral_lift", "1", kSource);
    Set("travel_ramping_lift", "1", kSource);
    Set("travel_slope", PrintNumber(NumberOf("travel_slope").value_or(3)), kSource);
    for (const auto& [from, to] : {std::pair{"z_hop", "travel_max_lift"},
                                   std::pair{"filament_z_hop", "filament_travel_max_lift"}})
      if (const auto height = NumberOf(from)) Set(to, PrintNumber(*height), kSource);
  }

  /// Returns true if tree supports are organic, which is the default.
  bool HasOrganicTrees() const {
    const auto style = by_key_.find("support_style");
    if (style == by_key_.end()) return true;
    const std::string name = FirstOf(style->second->value).value_or("");
    return name != "tree_slim" && name != "tree_strong" && name != "tree_hybrid";
  }

  /// Converts the settings of organic trees. OrcaSlicer has some settings twice: with the ending
  /// `_organic` for organic trees, and without it for other trees. Projects of Bambu Studio only
  /// have the settings without the ending, for both. An object or part that chooses the style also
  /// gets the matching settings.
  void TakeOrganicTrees() {
    constexpr std::pair<std::string_view, std::string_view> kTwice[] = {
        {"tree_support_branch_angle", "support_tree_angle"},
        {"tree_support_branch_diameter", "support_tree_branch_diameter"},
        {"tree_support_branch_distance", "support_tree_branch_distance"}};
    const auto style = by_key_.find("support_style");
    const bool styled = style != by_key_.end() && style->second->source == Source::kRequest;
    for (const auto& [plain, to] : kTwice) {
      const auto organic = by_key_.find(std::string(plain) + "_organic");
      if (organic == by_key_.end()) continue;
      known_.emplace(organic->first);
      const auto used = HasOrganicTrees() ? organic : by_key_.find(plain);
      if (used == by_key_.end()) continue;
      const std::string value = FirstOf(used->second->value).value_or("");
      if (!value.empty()) Set(to, value, styled ? Source::kRequest : used->second->source);
    }
  }

  bool IsOn(std::string_view key) const {
    const auto found = by_key_.find(key);
    return found != by_key_.end() && FirstOf(found->second->value) == "1";
  }

  /// Returns a value, shortened for a line of the report.
  static std::string ShortValue(std::string_view value) {
    constexpr size_t kMost = 60;
    const std::string text = Joined(value, ",");
    return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
  }

  /// Converts a value. A list with one item per extruder is converted as a whole, in PrusaSlicer's
  /// form of a list.
  Converted ConvertAll(const OrcaRow& row, std::string_view text) const {
    const int to = FindSetting(row.to, Process::kFdm);
    const bool is_list = to >= 0 && SettingsTable(Process::kFdm)[to].list == List::kPerExtruder;
    const std::optional<std::vector<std::string>> items = ItemsOf(text);
    if (!is_list || !items || items->empty()) return Convert(row, text);
    const Kind kind = SettingsTable(Process::kFdm)[to].kind;
    const bool is_text = kind == Kind::kText || kind == Kind::kGcode;
    Converted all = {""};
    for (size_t i = 0; i < items->size(); ++i) {
      Converted one = Convert(row, (*items)[i]);
      if (!one.text) return one;
      all.exact = all.exact && one.exact;
      if (i > 0) *all.text += is_text ? ";" : ",";
      *all.text += is_text ? QuoteText(Unescape(*one.text)) : *one.text;
    }
    return all;
  }

  Converted Convert(const OrcaRow& row, std::string_view text) const {
    if (row.value == OrcaValue::kWhole) return {std::string(text)};
    if (row.value == OrcaValue::kPoints) return {Joined(text, ",")};
    if (row.value == OrcaValue::kPairs) return {WithoutQuotes(Joined(text, ";"))};
    const std::optional<std::string> first = FirstOf(text);
    if (!first) return {};
    switch (row.value) {
      case OrcaValue::kPercent:
        return {first->empty() || first->ends_with('%') ? *first : *first + "%"};
      case OrcaValue::kPercentOf:
        return {PercentOf(*first, row.detail)};
      case OrcaValue::kShareOf:
        return {ShareOf(*first, NumberOf(row.detail))};
      case OrcaValue::kOrAuto:
        return ToNumber(*first).value_or(0) < 0 || *first == row.detail ? Converted{""}
                                                                        : Converted{first};
      case OrcaValue::kRest:
        return {RestOf(*first)};
      case OrcaValue::kNot:
        return {*first == "0" ? "1" : "0"};
      case OrcaValue::kPoint:
        return {PointOf(*first)};
      case OrcaValue::kChoice:
        return Choice(row.to, *first);
      case OrcaValue::kGcode:
        return {Escape(WithBedMesh(
            ReplacePlaceholders(Unescape(*first),
                                [this](std::string_view name) { return MeaningOf(name); }),
            MeshOfBed()))};
      case OrcaValue::kSame:
      case OrcaValue::kWhole:
      case OrcaValue::kPoints:
      case OrcaValue::kPairs:
        break;
    }
    return {first};
  }

  /// Reads a point `x,y` in OrcaSlicer's form.
  void TakePoint(std::string_view key, std::array<double, 2>& point) const {
    const auto found = by_key_.find(key);
    if (found == by_key_.end()) return;
    const std::string text = FirstOf(found->second->value).value_or("");
    const size_t comma = std::min(text.find_first_of(",x"), text.size());
    const auto x = ToNumber(Trim(std::string_view(text).substr(0, comma)));
    const auto y = ToNumber(Trim(std::string_view(text).substr(std::min(comma + 1, text.size()))));
    if (x && y) point = {*x, *y};
  }

  BedMesh MeshOfBed() const {
    BedMesh mesh;
    TakePoint("bed_mesh_min", mesh.min);
    TakePoint("bed_mesh_max", mesh.max);
    TakePoint("bed_mesh_probe_distance", mesh.probe_distance);
    mesh.margin = NumberOf("adaptive_bed_mesh_margin").value_or(0);
    const auto flavor = by_key_.find("gcode_flavor");
    mesh.klipper = flavor != by_key_.end() && flavor->second->value == "klipper";
    return mesh;
  }

  /// Returns a flush value of Bambu Studio: the first of both settings that has a positive number.
  std::optional<Placeholder> FlushOf(std::string_view own, std::string_view otherwise) const {
    for (const std::string_view key : {own, otherwise})
      if (const auto number = NumberOf(key, filament_); number && *number > 0)
        return ValuePlaceholder(PrintNumber(*number));
    return std::nullopt;
  }

  /// Returns the replacement of a placeholder. A setting that has an effect in slicefarm is
  /// referred to by its name, because another setting of the job may override its value.
  std::optional<Placeholder> MeaningOf(std::string_view name) const {
    if (name == "outer_wall_volumetric_speed") return OuterWallFlow();
    if (name == "during_print_exhaust_fan_speed_num") return ExhaustFan();
    if (name == "in_head_wrap_detect_zone") return HeadWrap();
    if (name == "chamber_cooling_mode") return ChamberCooling();
    if (name == "flush_volumetric_speeds")
      return FlushOf("filament_flush_volumetric_speed", "filament_max_volumetric_speed");
    if (name == "flush_temperatures")
      return FlushOf("filament_flush_temp", "nozzle_temperature_range_high");
    for (const OrcaVariable& variable : OrcaVariables()) {
      if (variable.from != name) continue;
      return MeaningOf(variable.to).value_or(Placeholder{std::string(variable.to)});
    }
    for (const OrcaRow& row : OrcaRows()) {
      const bool same = row.from == name && row.value == OrcaValue::kSame;
      if (same && (FindSetting(row.to, Process::kFdm) >= 0 || FindKnownKey(row.to) != nullptr))
        return Placeholder{std::string(row.to)};
    }
    if (const auto found = by_key_.find(name); found != by_key_.end())
      return ValuePlaceholder(Unescape(ItemOf(found->second->value, filament_).value_or("")));
    for (const OrcaStandard& standard : OrcaStandards())
      if (standard.key == name) return ValuePlaceholder(standard.value);
    return std::nullopt;
  }

  /// Returns the fan speed in the steps of M106, rounded down.
  std::optional<Placeholder> ExhaustFan() const {
    const double percent = NumberOf("during_print_exhaust_fan_speed", filament_).value_or(60);
    return ValuePlaceholder(PrintNumber(std::floor(percent / 100 * 255)));
  }

  std::optional<Placeholder> HeadWrap() const {
    const auto zone = by_key_.find("head_wrap_detect_zone");
    if (zone == by_key_.end()) return std::nullopt;
    return Placeholder{HeadWrapExpression(Joined(zone->second->value, ",")), false};
  }

  /// Returns the chamber cooling of Snapmaker's U1: 2 if the filament softens at 50 C, 1 at 70 C.
  std::optional<Placeholder> ChamberCooling() const {
    const auto soft_c = NumberOf("temperature_vitrification", filament_);
    const bool hot = NumberOf("filament_is_high_temperature", filament_).value_or(0) != 0;
    if (!soft_c || hot) return ValuePlaceholder("0");
    return ValuePlaceholder(*soft_c <= 50 ? "2" : *soft_c <= 70 ? "1" : "0");
  }

  /// Returns the outer wall's flow, in mm3/s, limited by the filament's maximum.
  std::optional<Placeholder> OuterWallFlow() const {
    const auto speed = NumberOf("outer_wall_speed");
    const auto width = NumberOf("outer_wall_line_width");
    const auto height = NumberOf("layer_height");
    if (!speed || !width || !height) return std::nullopt;
    const double flow = *speed * *height * (*width - *height * (1 - std::numbers::pi / 4));
    const double most = NumberOf("filament_max_volumetric_speed", filament_).value_or(0);
    return ValuePlaceholder(PrintNumber(Quantise(most > 0 ? std::min(flow, most) : flow)));
  }

  /// Returns a setting as a number. Percentages refer to the nozzle diameter.
  std::optional<double> NumberOf(std::string_view key, size_t index = 0) const {
    const auto found = by_key_.find(key);
    if (found == by_key_.end()) return std::nullopt;
    const std::optional<std::string> first = ItemOf(found->second->value, index);
    const std::optional<std::string> text =
        first ? PercentOf(*first, "nozzle_diameter") : std::nullopt;
    return text ? ToNumber(*text) : std::nullopt;
  }

  std::optional<std::string> PercentOf(std::string_view text, std::string_view whole) const {
    if (!text.ends_with('%')) return std::string(text);
    text.remove_suffix(1);
    const std::optional<double> percent = ToNumber(Trim(text));
    const auto found = by_key_.find(whole);
    if (!percent || found == by_key_.end()) return std::nullopt;
    const std::optional<std::string> of = FirstOf(found->second->value);
    const std::optional<double> number = of ? ToNumber(*of) : std::nullopt;
    if (!number) return std::nullopt;
    return PrintNumber(Quantise(*percent / 100 * *number));
  }

  static Converted Choice(std::string_view row, std::string_view text) {
    const std::span<const OrcaChoice> all = OrcaChoices();
    const auto found = std::find_if(all.begin(), all.end(), [&](const OrcaChoice& choice) {
      return choice.row == row && choice.from == text;
    });
    if (found == all.end()) return {};
    return {std::string(found->to), found->exact};
  }

  /// Converts the bed temperatures. Each kind of bed has two temperatures; only the kind that is in
  /// the printer counts.
  void TakeTemperaturesOfBed() {
    struct Bed {
      std::string_view type, key;
    };
    constexpr Bed kBeds[] = {{"High Temp Plate", "hot_plate_temp"},
                             {"Cool Plate", "cool_plate_temp"},
                             {"Engineering Plate", "eng_plate_temp"},
                             {"Textured PEI Plate", "textured_plate_temp"},
                             {"Textured Cool Plate", "textured_cool_plate_temp"},
                             {"Supertack Plate", "supertack_plate_temp"}};
    const auto type = by_key_.find("curr_bed_type");
    const std::string in_printer =
        type == by_key_.end() ? "" : FirstOf(type->second->value).value_or("");
    const Bed* chosen = &kBeds[0];
    for (const Bed& bed : kBeds) {
      if (bed.type == in_printer) chosen = &bed;
      for (const std::string_view ending : {"", "_initial_layer"}) {
        const auto found = by_key_.find(std::string(bed.key) + std::string(ending));
        if (found != by_key_.end()) known_.emplace(found->first);
      }
    }
    known_.insert("curr_bed_type");
    if (!in_printer.empty()) Set("curr_bed_type", in_printer, type->second->source);
    TakeTemperature(std::string(chosen->key), "bed_temperature");
    TakeTemperature(std::string(chosen->key) + "_initial_layer", "first_layer_bed_temperature");
  }

  void TakeTemperature(const std::string& from, std::string_view to) {
    const auto found = by_key_.find(from);
    if (found == by_key_.end()) return;
    if (const std::string all = Joined(found->second->value, ","); !all.empty())
      Set(to, all, found->second->source);
  }

  void Set(std::string_view key, const std::string& value, Source source) {
    const auto [at, first] = index_.emplace(key, settings_.size());
    if (first) settings_.emplace_back();
    settings_[at->second] = {std::string(key), value, source};
  }

  const size_t filament_;
  ByKey by_key_;
  std::vector<Setting> settings_;
  std::map<std::string, size_t, std::less<>> index_;  ///< index of each key in settings_
  std::set<std::string, std::less<>> known_, inexact_;
  /// Settings with a substitute that changes the print.
  std::set<std::string, std::less<>> stand_ins_;
};

}  // namespace

std::string_view KeyOfUnused(std::string_view line) {
  return line.substr(0, line.find_first_of(" :"));
}

std::vector<Setting> FromOrca(std::span<const Setting> settings, OrcaUnused* unused,
                              size_t filament) {
  std::vector<Setting> modern;
  for (const Setting& setting : settings) modern.push_back(Modernized(setting));
  OrcaReader reader(modern, filament);
  for (const OrcaRow& row : OrcaRows()) reader.Apply(row);
  reader.TakePairs();
  if (unused != nullptr) *unused = reader.Unused(modern);
  return std::move(reader).Take();
}

}  // namespace slicefarm::config
