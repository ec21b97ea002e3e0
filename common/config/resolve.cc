#include "common/config/resolve.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/check_settings.h"
#include "common/config/derive.h"
#include "common/config/draft.h"
#include "common/config/needs.h"
#include "common/config/suggest.h"
#include "common/config/table/known_keys.h"
#include "common/config/table/setting_limits.h"
#include "common/config/table/settings_table.h"
#include "common/macro/job_code.h"
#include "common/model/bead_section.h"
#include "common/model/fields/field_text.h"
#include "common/model/limits.h"

namespace slicefarm::config {
namespace {

/// A value as a report quotes it: start G-codes and ramming tables are long.
std::string Quoted(std::string_view key, std::string_view value) {
  constexpr size_t kMax = 40;
  return fmt::format("{} = {}{}", key, value.substr(0, kMax), value.size() > kMax ? "..." : "");
}

absl::Status CheckLimits(std::span<const Setting> given) {
  absl::Status status = CheckSettingCount(std::ssize(given));
  for (const Setting& setting : given) {
    status.Update(CheckSettingSize(setting.key, setting.value));
  }
  return status;
}

/// How many tools a machine can have.
constexpr double kMostTools = 255;

/// The tool that prints, from 0: the last `extruder` that is given, 0 being none of its own.
size_t ToolOf(std::span<const Setting> given) {
  size_t tool = 0;
  for (const Setting& setting : given) {
    if (setting.key != "extruder") continue;
    const auto number = ToNumber(Trim(setting.value));
    const bool valid = number && *number >= 1 && *number <= kMostTools;
    tool = valid ? static_cast<size_t>(*number) - 1 : 0;
  }
  return tool;
}

/// Of a list with an item for each extruder, that of `tool`; other values as they are.
std::string ItemOf(const SettingSpec& spec, std::string_view value, size_t tool) {
  if (spec.list != List::kPerExtruder) return std::string(value);
  if (spec.kind == Kind::kText || spec.kind == Kind::kGcode)
    return QuoteText(TextOfList(value, tool));
  const std::vector<std::string_view> items = Split(value, ",;");
  return std::string(Trim(items[tool < items.size() ? tool : 0]));
}

/// How many extruders the machine has, by its nozzles, or as effective settings tell it.
size_t ToolCount(std::span<const Setting> given) {
  size_t nozzles = 1, told = 0;
  for (const Setting& setting : given) {
    if (setting.key == "nozzle_diameter") nozzles = Split(setting.value, ",;").size();
    const auto number = ToNumber(Trim(setting.value));
    if (setting.key == "num_extruders" && number && *number >= 1 && *number <= kMostTools)
      told = static_cast<size_t>(*number);
  }
  return std::max(nozzles, told);
}

/// The last value of each key by source, and what is said about the others.
class Reader {
 public:
  /// `tool`: whose items of lists count.
  Reader(ResolvedSettings& result, Process process, size_t tool)
      : result_(result), process_(process), tool_(tool), draft_(process) {}

  absl::Status Read(const Setting& setting) {
    const std::string_view value = Trim(setting.value);
    NoteOverridden(setting, value);
    if (const int index = FindSetting(setting.key, process_); index >= 0) {
      return ReadEffective(SettingsTable(process_)[index], draft_.entries()[index], setting, value);
    }
    if (const std::string_view owner = OwnerOf(setting.key); !owner.empty()) {
      if (setting.source == Source::kRequest) return OfOtherProcess(setting.key, owner);
      foreign_[setting.key] = {owner, std::string(value)};
      return absl::OkStatus();
    }
    if (const KnownKey* known = FindKnownKey(setting.key)) {
      const bool asks = setting.source == Source::kRequest && known->changes_print;
      if (asks && !IsNeutral(*known, value)) return NotMade(setting.key, value, *known);
      others_[setting.key] = {known, std::string(value)};
      return absl::OkStatus();
    }
    if (setting.source == Source::kRequest) return Unknown(setting.key);
    others_[setting.key] = {nullptr, std::string(value)};
    return absl::OkStatus();
  }

  /// Says what has no effect, once all settings are read.
  Draft Finish() {
    const auto table = SettingsTable(process_);
    for (size_t i = 0; i < table.size(); ++i) {
      if (draft_.entries()[i].given) NoteEffective(table[i], draft_.entries()[i]);
    }
    for (const auto& [key, other] : others_) NoteOther(key, other.first, other.second);
    for (const auto& [key, other] : foreign_)
      result_.no_effect.push_back(
          fmt::format("{}: a setting of process {}", Quoted(key, other.second), other.first));
    SortNotes();
    return std::move(draft_);
  }

  /// What was read and no stage works with.
  ToldSettings Told() const {
    ToldSettings told;
    for (const auto& [key, other] : others_) Tell(key, other.second, told);
    return told;
  }

 private:
  /// The process that has the setting; empty: the job's own, or none.
  std::string_view OwnerOf(std::string_view key) const {
    for (const ProcessInfo& info : kProcesses)
      if (info.process != process_ && FindSetting(key, info.process) >= 0) return info.name;
    // What PrusaSlicer knows is about FDM.
    const bool of_fdm = process_ != Process::kFdm && FindKnownKey(key) != nullptr;
    return of_fdm ? ProcessName(Process::kFdm) : std::string_view();
  }

  absl::Status OfOtherProcess(const std::string& key, std::string_view owner) const {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOfOtherProcess,
                     fmt::format("{} is a setting of process {}, and the job is of process {}", key,
                                 owner, ProcessName(process_)),
                     {{"setting", key}, {"process", std::string(owner)}});
  }

  /// A person who asks for what changes the print should not get another one.
  static absl::Status NotMade(const std::string& key, std::string_view value,
                              const KnownKey& known) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     fmt::format("{}: {}", Quoted(key, value), known.why),
                     {{"setting", key}, {"value", std::string(value)}});
  }

  absl::Status Unknown(const std::string& key) const {
    const std::string nearest = NearestSetting(key, process_);
    std::map<std::string, std::string> metadata = {{"setting", key}};
    if (!nearest.empty()) metadata["suggestion"] = nearest;
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingUnknown,
                     fmt::format("there is no setting '{}'{}", key,
                                 nearest.empty() ? "" : fmt::format("; do you mean {}?", nearest)),
                     std::move(metadata));
  }

  absl::Status ReadEffective(const SettingSpec& spec, Draft::Entry& entry, const Setting& setting,
                             std::string_view all) {
    const std::string item = ItemOf(spec, all, tool_);
    const std::string value = setting.source == Source::kRequest ? item : Readable(spec, item);
    if (value.empty() && setting.source != Source::kRequest && IsNumber(spec)) {
      Warn(fmt::format("{} has no value: {} is taken", spec.key, spec.standard));
      return absl::OkStatus();
    }
    entry.all = std::string(all);
    entry.written = value;
    entry.given = true;
    entry.requested = setting.source == Source::kRequest;
    if (spec.standard == kNotSet && FirstItem(value) == kNotSet) {
      entry.value.reset();
      return absl::OkStatus();
    }
    auto parsed = ParseValue(spec, value);
    if (!parsed.ok()) return parsed.status();
    if (setting.source == Source::kRequest) {
      if (const Choice* choice = StandIn(spec, value)) return RefuseStandIn(spec, choice->name);
      if (WantsOtherFormat(spec, value)) return RefuseStandIn(spec, value);
    }
    entry.value = *std::move(parsed);
    return absl::OkStatus();
  }

  static std::string_view FirstItem(std::string_view value) {
    return Trim(value.substr(0, value.find(',')));
  }

  static bool IsNumber(const SettingSpec& spec) {
    return spec.kind == Kind::kInteger || spec.kind == Kind::kNumber ||
           spec.kind == Kind::kPercent || spec.kind == Kind::kNumberOrPercent;
  }

  /// What a vendor's file writes after a number, a comment or a percent sign where there is
  /// nothing that it relates to, PrusaSlicer leaves out.
  std::string Readable(const SettingSpec& spec, const std::string& value) {
    const bool is_bed = spec.kind == Kind::kBedShape;
    if (!(is_bed || IsNumber(spec)) || ParseValue(spec, value).ok()) return value;
    const std::string read = is_bed ? WithAllCorners(value) : std::string(NumberAtFront(value));
    if (read.empty() || read == value) return value;
    Warn(fmt::format("{}: only {} counts", Quoted(spec.key, value), read));
    return read;
  }

  static std::string_view NumberAtFront(std::string_view value) {
    size_t end = value.size();
    while (end > 0 && !ToNumber(value.substr(0, end)).has_value()) --end;
    return Trim(value.substr(0, end));
  }

  /// A corner without "x" is its number, and 0.
  static std::string WithAllCorners(std::string_view value) {
    std::string corners;
    for (const std::string_view corner : Split(value, ",")) {
      const bool whole = corner.find('x') != std::string_view::npos;
      corners += fmt::format("{}{}{}", corners.empty() ? "" : ",",
                             whole ? corner : NumberAtFront(corner), whole ? "" : "x0");
    }
    return corners;
  }

  /// The choice of `spec` that `value` names, if something else is done instead.
  static const Choice* StandIn(const SettingSpec& spec, std::string_view value) {
    for (const Choice& choice : spec.choices) {
      if (choice.name == value && !choice.note.empty()) return &choice;
    }
    return nullptr;
  }

  /// Pictures of the same sizes are made, those of other formats as PNG.
  static bool WantsOtherFormat(const SettingSpec& spec, std::string_view value) {
    return spec.kind == Kind::kSizes && !OnlyOurFormats(value);
  }

  static absl::Status RefuseStandIn(const SettingSpec& spec, std::string_view value) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     fmt::format("{} = {} is not supported yet: it must be {}", spec.key, value,
                                 DescribeRange(spec)),
                     {{"setting", std::string(spec.key)}, {"value", std::string(value)}});
  }

  /// Within one source, a key that comes twice is likely a mistake; a request over a profile is
  /// not.
  void NoteOverridden(const Setting& setting, std::string_view value) {
    const auto [entry, first] = last_.try_emplace({setting.source, setting.key}, value);
    std::string& last = entry->second;
    if (first || last == value) return;
    result_.no_effect.push_back(
        fmt::format("{}: overridden by a later {}", Quoted(setting.key, last), setting.key));
    last = std::string(value);
  }

  void Warn(std::string text) {
    result_.no_effect.push_back(text);
    result_.warnings.push_back(std::move(text));
  }

  void NoteEffective(const SettingSpec& spec, const Draft::Entry& entry) {
    const std::string_view value = entry.written;
    if (const Choice* choice = StandIn(spec, value)) {
      Warn(fmt::format("{}: {}", Quoted(spec.key, value), choice->note));
    }
    if (WantsOtherFormat(spec, value)) {
      Warn(Quoted(spec.key, value) + ": the pictures are made as PNG, in the same sizes");
    }
    NoteOtherItems(spec, entry);
    if (spec.kind == Kind::kPercent && !value.ends_with("%")) NoteMissingPercent(spec, value);
  }

  /// Of lists one item counts: the tool's, or that of the machine's normal mode.
  void NoteOtherItems(const SettingSpec& spec, const Draft::Entry& entry) {
    const std::string_view separator =
        spec.kind == Kind::kText || spec.kind == Kind::kGcode ? ";" : ",";
    const std::string_view all = entry.all;
    if (spec.list == List::kNone || all.find('"') != std::string_view::npos) return;
    const std::vector<std::string_view> items = Split(all, separator);
    if (std::ranges::all_of(items, [&](std::string_view item) { return Trim(item) == Trim(items[0]); }))
      return;
    const std::string text = fmt::format("{}: only {}, {}, has an effect", Quoted(spec.key, all),
                                         tool_ == 0 || spec.list != List::kPerExtruder
                                             ? "the first value"
                                             : fmt::format("that of extruder {}", tool_ + 1),
                                         entry.written);
    if (spec.list == List::kPerExtruder) {
      Warn(text);
    } else {
      result_.no_effect.push_back(text);
    }
  }

  void NoteMissingPercent(const SettingSpec& spec, std::string_view value) {
    const auto number = ParseNumber(value, false);
    if (!number.ok() || number->number <= 0 || number->number >= 1) return;
    result_.warnings.push_back(
        fmt::format("{0} = {1} is read as {1}%; for {2}% write the percent sign", spec.key, value,
                    PrintNumber(number->number * 100)));
  }

  void NoteOther(const std::string& key, const KnownKey* known, const std::string& value) {
    if (known == nullptr) {
      result_.no_effect.push_back(Quoted(key, value) + ": unknown");
      return;
    }
    if (IsNeutral(*known, value)) return;
    const std::string text = fmt::format("{}: {}", Quoted(key, value), known->why);
    if (known->changes_print) {
      Warn(text);
    } else {
      (known->of_print ? result_.no_effect : last_notes_).push_back(text);
    }
  }

  /// What changes the print first, what describes profiles last.
  void SortNotes() {
    std::vector<std::string>& notes = result_.no_effect;
    const std::set<std::string> weighty(result_.warnings.begin(), result_.warnings.end());
    std::stable_partition(notes.begin(), notes.end(),
                          [&](const std::string& note) { return weighty.contains(note); });
    std::ranges::move(last_notes_, std::back_inserter(notes));
  }

  ResolvedSettings& result_;
  const Process process_;
  const size_t tool_;
  Draft draft_;
  std::vector<std::string> last_notes_;
  std::map<std::string, std::pair<std::string_view, std::string>> foreign_;
  std::map<std::string, std::pair<const KnownKey*, std::string>> others_;
  std::map<std::pair<Source, std::string>, std::string> last_;
};

/// What the G-code of each layer names goes along with its options, and no more: the rest is no
/// part of what decides a layer.
absl::Status TakeLayerSettings(const std::string& text, MotionOptions& options) {
  const std::string code = options.before_layer_gcode + "\n" + options.layer_gcode;
  options.layer_settings = LinesNamedIn(code, text);
  const auto size = static_cast<int64_t>(options.layer_settings.size());
  if (size <= limits::kMaxSettingBytes) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "bytes of the settings that layer_gcode names",
                    limits::kMaxSettingBytes, size);
}

/// What elefant_foot_compensation leaves of thin places: room for the first layer's outer wall and
/// its neighbour, as PrusaSlicer has it.
void TakeFootWidth(JobSettings& settings) {
  const Coord width_nm = settings.beading[0].first_layer_width_nm;
  const Coord spacing_nm = Spacing(width_nm, settings.slicing.first_layer_height_nm);
  settings.slicing.objects[0].elephant_foot_min_width_nm =
      width_nm + std::max<Coord>(spacing_nm, 0);
}

/// Copies that are arranged to be printed one after the other leave room for the head.
void TakeClearance(JobSettings& settings) {
  const SequencePlanOptions& sequence = settings.planning.sequence;
  settings.slicing.clearance_radius_nm =
      sequence.complete_objects ? sequence.clearance_radius_nm : 0;
}

/// What skirt, brim and raft take from settings that are about other things.
void TakeAdhesion(JobSettings& settings) {
  const Coord first_height_nm = settings.slicing.first_layer_height_nm;
  const Coord line_width_nm = settings.beading[0].first_layer_width_nm;
  SkirtOptions& skirt = settings.planning.skirt;
  skirt.width_nm = line_width_nm;
  skirt.height_nm = first_height_nm;
  const double radius_mm = settings.motion.filament_diameter_mm / 2;
  skirt.filament_area_mm2 = std::numbers::pi * radius_mm * radius_mm;
  ObjectPlanOptions& object = settings.planning.objects[0];
  object.brim.line_width_nm = line_width_nm;
  RaftHeights& raft = object.raft.heights;
  raft.first_nm = first_height_nm;
  raft.others_nm = std::max(settings.slicing.objects[0].layer_height_nm,
                            FromMm(0.75 * settings.motion.nozzle_diameter_mm));
  settings.slicing.objects[0].raft = raft;
  object.raft_settings.assign(static_cast<size_t>(raft.layers), 0);
  settings.planning.bed = settings.slicing.bed;
}

/// A density that depends on the distance to the surface looks as many layers up and down as it
/// reaches.
absl::Status TakeDensityField(JobSettings& settings) {
  InfillOptions& infill = settings.infill[0];
  if (infill.density_field.empty()) return absl::OkStatus();
  const auto field = ParseDensityField(infill.density_field);
  if (!field.ok()) return field.status();
  if (field->dither != Dither::kNone && !infill.stress_field.empty()) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     "density_field: dither has no effect on the streamlines of stress_field",
                     {{"setting", "density_field"}});
  }
  const double height_mm = ToMm(settings.slicing.objects[0].layer_height_nm);
  const double layers = std::ceil(field->ReachMm() / height_mm);
  if (layers > static_cast<double>(limits::kMaxFieldHaloLayers)) {
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
        fmt::format("density_field: length = {} mm is out of range: it must be at most "
                    "{} layers of layer_height = {} mm",
                    PrintNumber(field->ReachMm()), limits::kMaxFieldHaloLayers,
                    PrintNumber(height_mm)),
        {{"setting", "density_field"}});
  }
  infill.field_halo_layers = static_cast<int32_t>(layers);
  return absl::OkStatus();
}

/// Lines that planning lays out do not follow a field.
absl::Status CheckPlannedPattern(const InfillOptions& infill) {
  const bool planned = infill.choose_pattern || InfoOf(infill.pattern).planned;
  if (!planned || infill.density_field.empty()) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("density_field: fill_pattern = {} is laid out over the whole part, "
                               "and cannot follow a field",
                               infill.choose_pattern ? "auto" : InfoOf(infill.pattern).name),
                   {{"setting", "density_field"}});
}

/// Between copies that are printed one after the other a skirt of one layer is all that the head can
/// pass; profiles ask for more. What a person asks for is checked (check_settings.h). Returns what
/// to say of it.
std::optional<std::string> TakeSequentialSkirt(Draft& draft) {
  if (draft.process() != Process::kFdm || draft.Number("complete_objects") == 0 ||
      draft.Number("skirts") == 0)
    return std::nullopt;
  const Draft::Entry& height = draft.At("skirt_height");
  if (height.requested || draft.Number("skirt_height") <= 1) return std::nullopt;
  std::string note = fmt::format("skirt_height = {}: with complete_objects = 1 the skirt has one "
                                 "layer, or the head would meet it",
                                 height.written);
  draft.SetNumber("skirt_height", 1);
  return note;
}

/// Beads are not higher than the nozzle is wide. Returns what to say of it.
std::optional<std::string> TakeEveryLayers(JobSettings& settings) {
  int32_t& every = settings.infill[0].every_layers;
  const Coord height_nm = settings.slicing.objects[0].layer_height_nm;
  const Coord nozzle_nm = FromMm(settings.motion.nozzle_diameter_mm);
  const auto most = static_cast<int32_t>(std::max<Coord>(1, nozzle_nm / height_nm));
  if (every <= most) return std::nullopt;
  const int32_t asked = std::exchange(every, most);
  return fmt::format("infill_every_layers = {}: {} is what layer_height and nozzle_diameter allow",
                     asked, most);
}

}  // namespace

absl::StatusOr<ResolvedSettings> Resolve(std::span<const Setting> given, Process process) {
  if (absl::Status status = CheckLimits(given); !status.ok()) return status;
  ResolvedSettings result;
  result.settings.process = process;
  const size_t tool = ToolOf(given);
  Reader reader(result, process, tool);
  for (const Setting& setting : given) {
    if (absl::Status status = reader.Read(setting); !status.ok()) return status;
  }
  ToldSettings told = reader.Told();
  Draft draft = reader.Finish();
  TellDerived(draft, told);
  if (auto note = TakeSequentialSkirt(draft)) {
    result.no_effect.push_back(*note);
    result.warnings.push_back(*std::move(note));
  }
  if (absl::Status status = Derive(draft); !status.ok()) return status;
  if (absl::Status status = CheckSettings(draft); !status.ok()) return status;

  const auto table = SettingsTable(process);
  for (size_t i = 0; i < table.size(); ++i) {
    for (const Field& field : {table[i].field, table[i].also}) {
      if (field.set != nullptr) field.set(result.settings, *draft.entries()[i].value);
    }
  }
  if (process == Process::kFdm) {
    TakeFootWidth(result.settings);
    if (ToolCount(given) > 1) {
      result.settings.motion.tool = static_cast<int32_t>(tool);
      told["num_extruders"] = fmt::format("{}", ToolCount(given));
    }
    const auto code = macro::ParseJobCode(result.settings.motion);
    if (!code.ok()) return code.status();
    if (!macro::NamesClock(*code)) told.erase("creation_time");
    TakeClearance(result.settings);
    TakeAdhesion(result.settings);
    if (absl::Status ok = TakeDensityField(result.settings); !ok.ok()) return ok;
    if (absl::Status ok = CheckPlannedPattern(result.settings.infill[0]); !ok.ok()) return ok;
    if (auto note = TakeEveryLayers(result.settings)) result.no_effect.push_back(*std::move(note));
  }
  for (std::string& note : UnmetNeeds(draft, result.settings)) {
    result.no_effect.push_back(std::move(note));
  }
  result.effective_text = EffectiveText(result.settings, told);
  MotionOptions& motion = result.settings.motion;
  if (process == Process::kFdm)
    if (absl::Status ok = macro::CheckJobCode(motion, result.effective_text); !ok.ok()) return ok;
  if (absl::Status ok = TakeLayerSettings(result.effective_text, motion); !ok.ok()) return ok;
  return result;
}

namespace {

/// Few jobs have fields, or angles by layer: those that have none do not say so.
bool IsRare(const SettingSpec& spec) {
  return spec.kind == Kind::kDensityField || spec.kind == Kind::kStressField ||
         spec.kind == Kind::kMaterialField || spec.kind == Kind::kAngles;
}

}  // namespace

std::string EffectiveText(const JobSettings& settings, const ToldSettings& told) {
  ToldSettings all = told;
  for (const SettingSpec& spec : SettingsTable(settings.process)) {
    if (spec.field.get == nullptr) continue;
    std::string value = PrintValue(spec, spec.field.get(settings));
    if (IsRare(spec) && value.empty()) continue;
    all[std::string(spec.key)] = std::move(value);
  }
  std::string text;
  for (const auto& [key, value] : all) text += fmt::format("{} = {}\n", key, value);
  return text;
}

}  // namespace slicefarm::config
