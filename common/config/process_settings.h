#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/config/setting_values.h"
#include "common/config/table/setting_spec.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config {

/// Table of the different rows of region settings of a plate, which is filled while the plate is
/// resolved. This base class is for a process without settings per region: all regions share one
/// row.
class RegionRows {
 public:
  virtual ~RegionRows() = default;

  /// Returns the index of the row for `settings`; equal rows share an index. Errors:
  /// REQUEST_TOO_LARGE beyond limits::kMaxRegionSettings.
  virtual absl::StatusOr<int32_t> RowOf(const JobRows& /*settings*/) { return 0; }

  /// Returns the index of the row for the regions of row `row` in copies that are turned by
  /// `angle_rad` about the z axis, counter-clockwise. Errors: SETTING_OUT_OF_RANGE with the name of
  /// the setting that makes rows differ by angle, beyond limits::kMaxRegionSettings.
  virtual absl::StatusOr<int32_t> TurnedRow(int32_t row, double /*angle_rad*/) { return row; }

  /// Returns the number of rows so far.
  virtual int64_t size() const { return 1; }

  /// Stores the rows in the plate.
  virtual void PutInto(JobSettings& /*plate*/) const {}
};

/// Arguments of ProcessSettings::DeriveOptions: the settings of a job, an object or a region. The
/// values of `draft` are already stored in `result`.
struct OptionSources {
  const SettingValues& draft;
  std::span<const Setting> given;  ///< settings as texts, before they are read
  ResolvedSettings& result;        ///< receives derived options, notes and warnings
  ReportedSettings& reported;      ///< settings that no stage uses
};

/// Format of a job's output file, identified by the file name's suffix.
struct FileFormat {
  std::string_view suffix;  ///< suffix such as ".svg"
  std::string_view key;     ///< setting that selects the format, by the value `value`
  std::string_view value;
  /// True: only this process uses the suffix; a job of another process is refused if its output
  /// file has the suffix. False: other processes may use the suffix as well.
  bool alone = false;
  /// True: a file with the suffix gets this format unless settings select another one. False: only
  /// the setting `key` selects the format.
  bool chosen_by_name = true;
  /// True: such a file is an archive of files of the other formats. If the setting has the value,
  /// the job makes this format; the settings of the other formats do not matter.
  bool archive = false;
};

/// Words for a job's units of work and their time, in messages to users.
struct ResultWords {
  std::string_view one = "layer";
  std::string_view many = "layers";
  std::string_view to_make = "to print";
};

/// Definition of the settings of one process. common/config reads, resolves and explains settings;
/// it calls this interface for everything that depends on the process, and names no process itself.
/// Each process has one object, in processes/<name>/settings. processes/list/settings.cc lists
/// these objects.
class ProcessSettings {
 public:
  virtual ~ProcessSettings() = default;

  // Functions for the settings table.
  /// Returns rows of this process, into which the values of all settings are then stored. The
  /// initial values do not matter.
  virtual JobRows Standards() const = 0;
  /// Returns a plate with the job's rows and without objects.
  virtual ProcessValue PlateOf(const ProcessValue& job) const = 0;
  /// Returns all settings that have an effect, with their scopes, in any order. Called once.
  virtual std::vector<SettingSpec> Table() const = 0;
  /// Returns true if a key outside of the table belongs to this process. Files contain such keys,
  /// but they have no effect.
  virtual bool Knows(std::string_view /*key*/) const { return false; }

  /// Returns the keys that each profile of a machine sets. If a job sets all of them, it is made
  /// for a certain machine (CheckMachineNamed).
  virtual std::span<const std::string_view> MachineKeys() const { return {}; }

  // Functions for one set of settings, in the order of the calls. For their errors see Resolve.
  /// Returns the index of the extruder. In lists with one item per extruder, the item with this
  /// index is used.
  virtual size_t ListItem(std::span<const Setting> /*given*/) const { return 0; }
  /// Replaces values that refer to other settings by absolute values. Requests that cannot be
  /// fulfilled are reported in `result`.
  virtual absl::Status Derive(SettingValues& draft, ResolvedSettings& result) const = 0;
  /// Checks that the values are consistent with each other.
  virtual absl::Status Check(const SettingValues& draft) const = 0;
  /// Sets the options that depend on several settings, in OptionSources::result.
  virtual absl::Status DeriveOptions(const OptionSources& /*sources*/) const {
    return absl::OkStatus();
  }
  /// Checks the complete settings, including ResolvedSettings::effective_text.
  virtual absl::Status Finish(const SettingValues& /*draft*/, ResolvedSettings& /*result*/) const {
    return absl::OkStatus();
  }

  // Functions for a plate of objects, in the order of the calls. For their errors see ResolvePlate.
  /// Removes the settings of which a plate can have only one value (such as the extruder) from
  /// `job` and `objects`, before the settings of any object are resolved. Adds requests that cannot
  /// be fulfilled to `missing`.
  virtual absl::Status UnifySettings(std::vector<Setting>& /*job*/,
                                     std::vector<SceneObject>& /*objects*/,
                                     std::vector<MissingFeature>& /*missing*/) const {
    return absl::OkStatus();
  }
  /// Returns one feature for each profile of the job with a condition that the machine or the print
  /// settings do not fulfil, such as `compatible_printers_condition`. `settings_text`:
  /// ResolvedSettings::effective_text.
  virtual std::vector<MissingFeature> Incompatible(std::span<const Setting> /*job*/,
                                                   std::string_view /*settings_text*/) const {
    return {};
  }
  virtual std::unique_ptr<RegionRows> NewRows() const { return std::make_unique<RegionRows>(); }
  /// Returns the settings of an object's parts and ranges that have no effect, because a setting of
  /// the object disables them. Each line is `key = value: needs ...`.
  virtual std::vector<std::string> UnmetNeedsOf(const SceneObject& /*object*/,
                                                const JobRows& /*settings*/) const {
    return {};
  }
  /// Adds rows for the structures that planning adds to an object, such as supports. Stores the
  /// indices of these rows in `object`, the settings of the object.
  virtual absl::Status AddRows(JobRows& /*object*/, RegionRows& /*rows*/) const {
    return absl::OkStatus();
  }
  /// Returns true if object number `object` of the plate and an object with the settings `other`
  /// have the same settings for all stages. REQUIRES: their settings for slicing are equal.
  virtual bool AreAlike(const JobSettings& /*plate*/, size_t /*object*/,
                        const JobRows& /*other*/) const {
    return true;
  }
  /// Appends the options of one object to the plate.
  virtual void AddObject(const JobRows& /*object*/, JobSettings& /*plate*/) const {}
  /// Stores the rows in the plate and sets the options of the plate as a whole. `job`: settings of
  /// the job.
  virtual absl::Status FinishPlate(const JobRows& /*job*/, RegionRows& rows,
                                   JobSettings& plate) const {
    rows.PutInto(plate);
    return absl::OkStatus();
  }

  // Functions for the result.
  /// Returns the output formats and the file suffixes that select them.
  virtual std::vector<FileFormat> FileFormats() const { return {}; }
  /// Returns an example call of `slicefarm slice` for the help, with options specific to the
  /// process. Returns an empty text if there is none.
  virtual std::string_view Example() const { return {}; }
  virtual ResultWords Words() const { return {}; }
  /// Returns the cost of the material per kg. Returns 0 if the settings have no cost; then the
  /// farm's own value is used.
  virtual double MaterialCostPerKg(const JobSettings& /*settings*/) const { return 0; }
};

/// Returns the settings definition of a process. The list of processes defines this function.
const ProcessSettings& SettingsOf(Process process);

}  // namespace slicefarm::config
