#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/config/draft.h"
#include "common/config/resolve.h"
#include "common/config/setting_need.h"
#include "common/config/table/setting_spec.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config {

/// Regions of a plate while it is resolved. Base: one region for all, of a process that has no
/// settings by region.
class RegionRows {
 public:
  virtual ~RegionRows() = default;

  /// Returns the number of the region row of `settings`: equal rows share a number. Errors:
  /// REQUEST_TOO_LARGE past limits::kMaxRegionSettings.
  virtual absl::StatusOr<int32_t> RowOf(const JobRows& /*settings*/) { return 0; }

  /// Number of rows so far.
  virtual int64_t size() const { return 1; }

  /// Puts the rows into the plate.
  virtual void PutInto(JobSettings& /*plate*/) const {}
};

/// Settings on their way to a job's, once all values are in their places.
struct Settling {
  const Draft& draft;
  std::span<const Setting> given;
  ResolvedSettings& result;  ///< what is told goes here as well
  ToldSettings& told;
};

/// A format of the file that a job comes to, which the end of its name stands for.
struct FileFormat {
  std::string_view suffix;  ///< ".svg"
  std::string_view key;     ///< the setting that says so
  std::string_view value;
  bool alone = false;  ///< only processes that list the suffix make files of such a name
  bool chosen_by_name = true;  ///< a file of such a name gets the format unless settings say it
};

/// What users are told of a job's parts and of its time.
struct ResultWords {
  std::string_view one = "layer";
  std::string_view many = "layers";
  std::string_view to_make = "to print";
};

/// What the settings of one process are and what they come to. common/config reads, resolves and
/// explains settings, and asks this for all that differs: it knows no process by name. One object a
/// process, in processes/<name>/settings; processes/list/settings.cc lists them.
class ProcessSettings {
 public:
  virtual ~ProcessSettings() = default;

  // The table.
  /// Where values get their places: settings of the process, whatever they are.
  virtual JobRows Standards() const = 0;
  /// Returns a plate with the job's rows and without objects.
  virtual ProcessValue PlateOf(const ProcessValue& job) const = 0;
  /// All settings that have an effect, with their scopes, in any order. Called once.
  virtual std::vector<SettingSpec> Table() const = 0;
  /// Those that do nothing unless others are so.
  virtual std::vector<Need> Needs() const { return {}; }
  /// Whether a key beside the table is one of this process: files have it, and nothing heeds it.
  virtual bool Knows(std::string_view /*key*/) const { return false; }

  /// Returns the keys that a machine's profile sets: a job that sets all of them names its machine.
  virtual std::span<const std::string_view> MachineKeys() const { return {}; }

  // One set of settings, in the order of the calls: see Resolve, whose errors these are.
  /// Which item counts of a list with one for each extruder.
  virtual size_t ListItem(std::span<const Setting> /*given*/) const { return 0; }
  /// Turns what refers to other settings into what it comes to. What is not made as asked is told
  /// in `result`.
  virtual absl::Status Derive(Draft& draft, ResolvedSettings& result) const = 0;
  /// Whether the values fit each other.
  virtual absl::Status Check(const Draft& draft) const = 0;
  /// What options of stages take from settings that are about others.
  virtual absl::Status Settle(const Settling& /*settling*/) const { return absl::OkStatus(); }
  /// Looks at the settings as a whole, their text included.
  virtual absl::Status Finish(const Draft& /*draft*/, ResolvedSettings& /*result*/) const {
    return absl::OkStatus();
  }

  // A plate of objects, in the order of the calls: see ResolvePlate, whose errors these are.
  /// Takes out what objects and job can only have together, before anything is resolved. Adds to
  /// `missing` what is not done as asked.
  virtual absl::Status TakeTogether(std::vector<Setting>& /*job*/,
                                    std::vector<SceneObject>& /*objects*/,
                                    std::vector<MissingFeature>& /*missing*/) const {
    return absl::OkStatus();
  }
  /// Returns the profiles among the job's settings that their own conditions keep from this
  /// machine or print. `settings_text`: ResolvedSettings::effective_text.
  virtual std::vector<MissingFeature> Incompatible(std::span<const Setting> /*job*/,
                                                   std::string_view /*settings_text*/) const {
    return {};
  }
  virtual std::unique_ptr<RegionRows> NewRows() const { return std::make_unique<RegionRows>(); }
  /// What an object's parts and ranges ask for and its settings switch off, each as
  /// `what: needs ...`.
  virtual std::vector<std::string> UnmetNeedsOf(const SceneObject& /*object*/,
                                                const JobRows& /*settings*/) const {
    return {};
  }
  /// Adds the rows of what is planned for an object; `object`: its settings, which name them then.
  virtual absl::Status AddRows(JobRows& /*object*/, RegionRows& /*rows*/) const {
    return absl::OkStatus();
  }
  /// Whether an object of the plate and one of `other` settings, which slicing would make alike,
  /// are alike to all stages.
  virtual bool AreAlike(const JobSettings& /*plate*/, size_t /*object*/,
                        const JobRows& /*other*/) const {
    return true;
  }
  /// Adds the options by object of one more.
  virtual void AddObject(const JobRows& /*object*/, JobSettings& /*plate*/) const {}
  /// Puts the rows in, and what is of the plate as a whole; `job`: its settings.
  virtual absl::Status FinishPlate(const JobRows& /*job*/, RegionRows& rows,
                                   JobSettings& plate) const {
    rows.PutInto(plate);
    return absl::OkStatus();
  }

  // What comes out.
  /// The formats that there are, and what names of files ask for.
  virtual std::vector<FileFormat> FileFormats() const { return {}; }
  /// A call of `slicefarm slice` that shows what is its own, for help; empty: none.
  virtual std::string_view Example() const { return {}; }
  virtual ResultWords Words() const { return {}; }
  /// What the material costs; 0: whatever the farm says.
  virtual double MaterialCostPerKg(const JobSettings& /*settings*/) const { return 0; }
};

/// Defined by the list of processes.
const ProcessSettings& SettingsOf(Process process);

}  // namespace slicefarm::config
