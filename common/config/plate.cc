#include "common/config/plate.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "absl/strings/escaping.h"
#include "common/base/error.h"
#include "common/base/portable_math.h"
#include "common/config/process_settings.h"
#include "common/config/resolved_bytes.h"
#include "common/config/setting_reader.h"
#include "common/config/table/settings_table.h"
#include "common/config/written_rows.h"
#include "common/stage/copy_groups.h"

namespace slicefarm::config {
namespace {

using Settings = std::vector<Setting>;

std::string Quoted(const std::string& name) { return "\"" + absl::Utf8SafeCEscape(name) + "\""; }

absl::Status OfObject(const std::string& name, const absl::Status& status) {
  ErrorDetail detail = DetailOf(status);
  detail.metadata["object"] = name;
  return MakeError(status.code(), detail.reason,
                   fmt::format("object {}: {}", Quoted(name),
                               std::string_view(status.message().data(), status.message().size())),
                   std::move(detail.metadata));
}

/// Returns the scope of a setting. REQUIRES: the process has the setting.
Scope ScopeOf(const Setting& setting, Process process) {
  return SettingsTable(process)[FindSetting(setting.key, process)].scope();
}

absl::Status Misplaced(const Setting& setting, Process process, Scope place) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMisplaced,
                   fmt::format("{} is a setting of {} and cannot be set for {}", setting.key,
                               ScopeName(ScopeOf(setting, process)), ScopeName(place)),
                   {{"setting", setting.key}});
}

/// Returns true if the setting may be given at a level. A height range may have a layer height in
/// addition to the settings of regions.
bool MayBeGiven(const Setting& setting, Process process, Scope place, bool of_range) {
  if (FindSetting(setting.key, process) < 0) return true;  // Resolve says what it is
  if (of_range && setting.key == "layer_height") return true;
  return ScopeOf(setting, process) >= place;
}

/// Resolver of the settings of a job's objects, parts and ranges. Each different set of settings is
/// resolved only once.
class Resolver {
 public:
  Resolver(std::span<const Setting> job, Process process, const CancelToken& cancel,
           ResolvedPlate& plate)
      : job_(job.begin(), job.end()), process_(process), cancel_(cancel), plate_(plate) {}

  absl::Status ResolveJob() {
    absl::StatusOr<ResolvedSettings> base = Resolve(job_, process_, parsed_);
    if (!base.ok()) return base.status();
    plate_.settings.slicing = {base->settings.slicing, {}};
    plate_.settings.own = process().PlateOf(base->settings.own);
    plate_.effective_text = base->effective_text;
    plate_.no_effect = base->no_effect;
    plate_.beside_print = base->beside_print;
    plate_.warnings = base->warnings;
    reported_.insert(base->no_effect.begin(), base->no_effect.end());
    of_job_ = reported_;
    warned_.insert(base->warnings.begin(), base->warnings.end());
    for (MissingFeature& each : base->missing) ReportMissing(std::move(each));
    known_[Settings{}] = job_rows_ = base->settings;
    shrinkage_ = base->shrinkage;
    return absl::OkStatus();
  }

  const ShrinkageCompensation& shrinkage() const { return shrinkage_; }
  const JobRows& job_rows() const { return job_rows_; }
  const ProcessSettings& process() const { return SettingsOf(process_); }

  /// Returns the rows for the job's settings, overridden by `own`. `object`: name of the object,
  /// for notes and errors.
  absl::StatusOr<JobRows> With(const std::string& object, const Settings& own) {
    if (const auto known = known_.find(own); known != known_.end()) return known->second;
    if (absl::Status wanted = cancel_.Check(); !wanted.ok()) return wanted;
    Settings all = job_;
    all.insert(all.end(), own.begin(), own.end());
    if (absl::Status ok = bytes_.Add(BytesOfJob(job_) + BytesOf(own)); !ok.ok())
      return OfObject(object, ok);
    absl::StatusOr<ResolvedSettings> resolved = Resolve(all, process_, parsed_);
    if (!resolved.ok()) return OfObject(object, resolved.status());
    DropMetNeeds(own, resolved->no_effect);
    for (SettingNote& note : resolved->no_effect) {
      if (!reported_.insert(note).second || IsOverride(note, own)) continue;
      note.text = object + ": " + note.text;
      plate_.no_effect.push_back(std::move(note));
    }
    for (const std::string& warning : resolved->warnings)
      if (warned_.insert(warning).second) plate_.warnings.push_back(object + ": " + warning);
    for (const MissingFeature& each : resolved->missing) ReportMissing(each);
    known_[own] = resolved->settings;
    return resolved->settings;
  }

  /// Adds a warning about a request that changes the print and cannot be fulfilled. The same text
  /// is added only once.
  void Warn(const std::string& text) {
    if (!warned_.insert(text).second) return;
    plate_.no_effect.insert(plate_.no_effect.begin(), {text});
    plate_.warnings.push_back(text);
  }

  /// Adds a missing feature that spoils the print, and the same text as a warning. The same feature
  /// is added only once.
  void ReportMissing(MissingFeature feature) {
    if (std::ranges::find(plate_.missing, feature) != plate_.missing.end()) return;
    if (warned_.insert(feature.text).second) plate_.warnings.push_back(feature.text);
    plate_.missing.push_back(std::move(feature));
  }

  /// Returns the settings that are allowed at the given level. Other settings are errors if a
  /// person requested them, and are reported if they are from a file.
  absl::StatusOr<Settings> Fitting(const std::string& object, const Settings& settings, Scope place,
                                   bool of_range = false) {
    Settings fitting;
    for (const Setting& setting : settings) {
      if (MayBeGiven(setting, process_, place, of_range)) {
        fitting.push_back(setting);
      } else if (setting.source == Source::kRequest) {
        return OfObject(object, Misplaced(setting, process_, place));
      } else {
        plate_.no_effect.push_back(
            {fmt::format("{}: {} = {}: is a setting of {}", object, setting.key, setting.value,
                         ScopeName(ScopeOf(setting, process_)))});
      }
    }
    return fitting;
  }

 private:
  struct Less {
    bool operator()(const Settings& a, const Settings& b) const {
      return std::ranges::lexicographical_compare(a, b, [](const Setting& x, const Setting& y) {
        return std::tie(x.key, x.value, x.source) < std::tie(y.key, y.value, y.source);
      });
    }
  };

  /// Removes the job's notes on unmet needs if an object meets the need. Example: a setting of the
  /// job requires a raft, and only one object has a raft.
  void DropMetNeeds(const Settings& own, const std::vector<SettingNote>& notes_there) {
    std::erase_if(plate_.no_effect, [&](const SettingNote& note) {
      if (!of_job_.contains(note) || note.why != SettingNote::Why::kUnmetNeed) return false;
      const bool still = std::ranges::find(notes_there, note) != notes_there.end();
      return !still && !HasKey(own, note.key);
    });
  }

  /// Returns true if a note only reports that an object's own value overrides the value of the job,
  /// which is intended.
  static bool IsOverride(const SettingNote& note, const Settings& own) {
    return note.why == SettingNote::Why::kOverridden && HasKey(own, note.key);
  }

  static bool HasKey(const Settings& settings, std::string_view key) {
    return std::ranges::find(settings, key, &Setting::key) != settings.end();
  }

  const Settings job_;
  const Process process_;
  const CancelToken& cancel_;
  ResolvedPlate& plate_;
  ShrinkageCompensation shrinkage_;
  JobRows job_rows_;  ///< rows of the job's own settings
  std::set<SettingNote> reported_;
  std::set<SettingNote> of_job_;  ///< notes on the job's own settings
  std::set<std::string> warned_;
  std::map<Settings, JobRows, Less> known_;  ///< resolved rows per set of own settings
  ParsedTexts parsed_;
  ResolvedBytes bytes_;  ///< size of all sets in `known_`
};

/// Returns both sets, where `second` overrides `first`. Overridden settings are removed, so that
/// equal sets compare equal regardless of their origin.
Settings Joined(Settings first, const Settings& second) {
  std::erase_if(first, [&](const Setting& setting) {
    return std::ranges::find(second, setting.key, &Setting::key) != second.end();
  });
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Settings of each row of an object's parts, to which modifiers are applied.
using RowSettings = std::map<int32_t, Settings>;

/// Resolver of one object.
class ObjectResolver {
 public:
  ObjectResolver(const SceneObject& object, Resolver& resolver, RegionRows& rows)
      : object_(object), resolver_(resolver), process_(resolver.process()), rows_of_job_(rows) {}

  struct Result {
    ObjectInput input;  ///< input for slicing, without copies
    JobRows settings;
  };

  absl::StatusOr<Result> Resolve() {
    auto own = resolver_.Fitting(object_.name, object_.settings, Scope::kObject);
    if (!own.ok()) return own.status();
    own_ = *std::move(own);
    absl::StatusOr<JobRows> settings = resolver_.With(object_.name, own_);
    if (!settings.ok()) return settings.status();
    for (const std::string& unmet : process_.UnmetNeedsOf(object_, *settings))
      resolver_.Warn(object_.name + ": " + unmet);
    Result result;
    result.input.name = object_.name;
    if (absl::Status ok = AddRanges(result.input); !ok.ok()) return ok;
    for (const Part& part : object_.parts)
      if (absl::Status ok = AddPart(part, result.input); !ok.ok()) return ok;
    result.settings = *std::move(settings);
    if (absl::Status ok = process_.AddRows(result.settings, rows_of_job_); !ok.ok()) return ok;
    return result;
  }

 private:
  absl::Status AddRanges(ObjectInput& input) {
    for (const HeightRange& range : object_.ranges) {
      if (!(0 <= range.from_mm && range.from_mm < range.to_mm && range.to_mm < 1e4))
        return OfObject(
            object_.name,
            MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                      fmt::format("from {} mm to {} mm is not a range of heights: the end must be "
                                  "above the start, and both from 0 mm to 10000 mm",
                                  range.from_mm, range.to_mm)));
      auto own = resolver_.Fitting(object_.name, range.settings, Scope::kRegion, true);
      if (!own.ok()) return own.status();
      absl::StatusOr<JobRows> settings = resolver_.With(object_.name, Joined(own_, *own));
      if (!settings.ok()) return settings.status();
      input.ranges.push_back(
          {FromMm(range.from_mm), FromMm(range.to_mm), settings->object.layer_height_nm});
      ranges_.push_back(*std::move(own));
    }
    ranges_.push_back({});  // all other heights
    return absl::OkStatus();
  }

  absl::Status AddPart(const Part& part, ObjectInput& input) {
    auto own = resolver_.Fitting(object_.name, part.settings, Scope::kRegion);
    if (!own.ok()) return own.status();
    PartInput added;
    added.name = part.name;
    added.mesh = part.mesh;
    added.role = part.role;
    added.to_object = part.to_object;
    added.regions.clear();
    absl::Status ok =
        part.role == PartRole::kModifier ? AddChanges(*own, added) : AddRows(*own, added);
    if (part.role == PartRole::kModifier) added.regions.assign(ranges_.size(), 0);
    input.parts.push_back(std::move(added));
    return ok;
  }

  absl::Status AddRows(const Settings& own, PartInput& part) {
    for (const Settings& range : ranges_) {
      const Settings all = Joined(Joined(own_, own), range);
      absl::StatusOr<int32_t> row = RowOf(all);
      if (!row.ok()) return row.status();
      part.regions.push_back(*row);
      if (part.role == PartRole::kSolid) rows_.try_emplace(*row, all);
    }
    return absl::OkStatus();
  }

  /// Adds the rows that the modifier makes from each existing row. The existing rows include rows
  /// made by earlier modifiers.
  absl::Status AddChanges(const Settings& own, PartInput& modifier) {
    RowSettings made;
    for (const auto& [row, settings] : rows_) {
      const Settings all = Joined(settings, own);
      absl::StatusOr<int32_t> inside = RowOf(all);
      if (!inside.ok()) return inside.status();
      modifier.changes[row] = *inside;
      made.try_emplace(*inside, all);
    }
    rows_.merge(made);
    return absl::OkStatus();
  }

  absl::StatusOr<int32_t> RowOf(const Settings& own) {
    absl::StatusOr<JobRows> settings = resolver_.With(object_.name, own);
    if (!settings.ok()) return settings.status();
    return rows_of_job_.RowOf(*settings);
  }

  const SceneObject& object_;
  Resolver& resolver_;
  const ProcessSettings& process_;
  RegionRows& rows_of_job_;
  Settings own_;
  std::vector<Settings> ranges_;
  RowSettings rows_;
};

/// Returns the settings of an object as JSON, for people and for the cache's key.
nlohmann::ordered_json ToJson(const Settings& settings) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const Setting& setting : settings) json[setting.key] = setting.value;
  return json;
}

bool HasOwnSettings(const SceneObject& object) {
  return !object.settings.empty() || !object.ranges.empty() ||
         std::ranges::any_of(object.parts, [](const Part& part) { return !part.settings.empty(); });
}

std::string ObjectsText(std::span<const SceneObject> objects) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const SceneObject& object : objects) {
    if (!HasOwnSettings(object)) continue;
    nlohmann::ordered_json json = {{"object", object.name}, {"settings", ToJson(object.settings)}};
    for (const Part& part : object.parts)
      if (!part.settings.empty())
        json["parts"].push_back({{"part", part.name}, {"settings", ToJson(part.settings)}});
    for (const HeightRange& range : object.ranges)
      json["heights"].push_back({{"from_mm", range.from_mm},
                                 {"to_mm", range.to_mm},
                                 {"settings", ToJson(range.settings)}});
    all.push_back(std::move(json));
  }
  if (all.empty()) return {};
  return "object_settings = " +
         all.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Scales copies in place. In x and y a copy grows around its position; in z it grows from the bed.
void Grow(const ShrinkageCompensation& shrinkage, std::vector<Instance>& copies) {
  for (Instance& copy : copies) {
    copy.to_plate.topRows<2>().leftCols<3>() *= shrinkage.xy;
    copy.to_plate.row(2) *= shrinkage.z;
  }
}

/// Replaces the rows of an object's regions by the rows for copies with the transform `to_plate`.
absl::Status TurnRows(const Transform& to_plate, RegionRows& rows, ObjectInput& object) {
  const double angle_rad = Atan2(to_plate(1, 0), to_plate(0, 0));
  absl::Status status;
  const auto turned = [&](int32_t row) {
    const absl::StatusOr<int32_t> other = rows.TurnedRow(row, angle_rad);
    status.Update(other.status());
    return other.value_or(row);
  };
  for (PartInput& part : object.parts) {
    if (part.role != PartRole::kModifier)
      for (int32_t& row : part.regions) row = turned(row);
    std::map<int32_t, int32_t> changes;
    for (const auto& [from, to] : part.changes) changes.emplace(turned(from), turned(to));
    part.changes = std::move(changes);
  }
  return status;
}

/// Adds the object to the plate. If the plate has an equal object, only the copies are added to
/// that object.
void Add(ObjectResolver::Result object, const ProcessSettings& process, ResolvedPlate& plate) {
  JobSettings& settings = plate.settings;
  for (size_t i = 0; i < plate.objects.size(); ++i) {
    std::vector<CopyInput> copies = plate.objects[i].copies;
    plate.objects[i].copies = object.input.copies;
    const bool equal = plate.objects[i] == object.input &&
                       settings.slicing.objects[i] == object.settings.object &&
                       process.AreAlike(settings, i, object.settings);
    plate.objects[i].copies = std::move(copies);
    if (!equal) continue;
    std::ranges::move(object.input.copies, std::back_inserter(plate.objects[i].copies));
    return;
  }
  plate.objects.push_back(std::move(object.input));
  settings.slicing.objects.push_back(object.settings.object);
  process.AddObject(object.settings, settings);
}

}  // namespace

absl::StatusOr<ResolvedPlate> ResolvePlate(std::span<const Setting> given_job,
                                           std::span<const SceneObject> given_objects,
                                           Process process, const CancelToken& cancel) {
  Settings job(given_job.begin(), given_job.end());
  std::vector<SceneObject> objects(given_objects.begin(), given_objects.end());
  const ProcessSettings& own = SettingsOf(process);
  std::vector<MissingFeature> missing;
  if (absl::Status ok = own.UnifySettings(job, objects, missing); !ok.ok()) return ok;
  if (absl::Status ok = CheckResolvedBytes(job, objects); !ok.ok()) return ok;
  if (absl::Status ok = CheckWrittenRows(objects, process); !ok.ok()) return ok;
  ResolvedPlate plate;
  Resolver resolver(job, process, cancel, plate);
  if (absl::Status ok = resolver.ResolveJob(); !ok.ok()) return ok;
  std::ranges::move(own.Incompatible(job, plate.effective_text), std::back_inserter(missing));
  for (MissingFeature& each : missing) resolver.ReportMissing(std::move(each));
  const std::unique_ptr<RegionRows> rows = own.NewRows();
  for (SceneObject& object : objects) {
    Grow(resolver.shrinkage(), object.instances);
    absl::StatusOr<ObjectResolver::Result> resolved =
        ObjectResolver(object, resolver, *rows).Resolve();
    if (!resolved.ok()) return resolved.status();
    for (const CopyGroup& group : GroupsOf(object.instances)) {
      ObjectResolver::Result one = *resolved;
      one.input.sunk_mm = 0;
      one.input.to_plate = group.to_plate;
      one.input.copies = CopiesOf(group);
      if (absl::Status ok = TurnRows(group.to_plate, *rows, one.input); !ok.ok())
        return OfObject(object.name, ok);
      Add(std::move(one), own, plate);
    }
  }
  if (plate.objects.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                     "no object has a printable copy");
  if (absl::Status ok = own.FinishPlate(resolver.job_rows(), *rows, plate.settings); !ok.ok())
    return ok;
  plate.region_rows = rows->size();
  // Texts of the default process contain no process, because such texts are older than processes.
  if (process != kDefaultProcess)
    plate.effective_text += fmt::format("process = {}\n", ProcessName(process));
  plate.effective_text += ObjectsText(objects);
  return plate;
}

}  // namespace slicefarm::config
