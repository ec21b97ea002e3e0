#include "processes/fdm/settings/fdm_settings.h"

#include "common/config/table/known_keys.h"
#include "common/config/table/shared_settings.h"
#include "processes/fdm/settings/check_settings.h"
#include "processes/fdm/settings/compatibility.h"
#include "processes/fdm/settings/derive.h"
#include "processes/fdm/settings/derive_options.h"
#include "processes/fdm/settings/object_needs.h"
#include "processes/fdm/settings/plate_settings.h"
#include "processes/fdm/settings/plate_tool.h"
#include "processes/fdm/settings/region_table.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

constexpr std::string_view kMachineKeys[] = {"bed_shape", "nozzle_diameter", "gcode_flavor"};

constexpr SettingGroup kGroups[] = {
    {"layers", LayerSettings},     {"slicing", SlicingSettings}, {"walls", WallSettings},
    {"seams", SeamSettings},       {"infill", InfillSettings},   {"adhesion", AdhesionSettings},
    {"supports", SupportSettings}, {"speed", SpeedSettings},     {"filament", FilamentSettings},
    {"machine", MachineSettings},  {"travel", TravelSettings},   {"output", WritingSettings},
    {"flow", FlowSettings},
};

class OfFdm : public ProcessSettings {
 public:
  JobRows Standards() const override { return {.slicing = {}, .object = {}, .own = FdmRows()}; }
  ProcessValue PlateOf(const ProcessValue& job) const override {
    const auto& rows = job.As<FdmRows>();
    return FdmSettings{rows.machine, {}, {}, {rows.tool}};
  }
  std::vector<SettingSpec> Table() const override { return TableOf(kGroups); }
  /// Returns true if PrusaSlicer has the key; all its keys concern FDM.
  bool Knows(std::string_view key) const override { return FindKnownKey(key) != nullptr; }

  std::span<const std::string_view> MachineKeys() const override { return kMachineKeys; }

  size_t ListItem(std::span<const Setting> given) const override { return ToolOf(given); }
  absl::Status Derive(SettingValues& draft, ResolvedSettings& result) const override {
    return fdm::Derive(draft, result);
  }
  absl::Status Check(const SettingValues& draft) const override { return CheckSettings(draft); }
  absl::Status DeriveOptions(const OptionSources& sources) const override {
    return fdm::DeriveOptions(sources);
  }
  absl::Status Finish(const SettingValues& draft, ResolvedSettings& result) const override {
    return DeriveGcode(draft, result);
  }

  absl::Status UnifySettings(std::vector<Setting>& job, std::vector<SceneObject>& objects,
                             std::vector<MissingFeature>& missing) const override {
    return UnifyTool(job, objects, missing);
  }
  std::vector<MissingFeature> Incompatible(std::span<const Setting> job,
                                           std::string_view settings_text) const override {
    return IncompatibleProfiles(job, settings_text);
  }
  std::unique_ptr<RegionRows> NewRows() const override { return std::make_unique<RegionTable>(); }
  std::vector<std::string> UnmetNeedsOf(const SceneObject& object,
                                        const JobRows& settings) const override {
    return NeedsOfObject(object, settings);
  }
  absl::Status AddRows(JobRows& object, RegionRows& rows) const override {
    return AddAdhesionRows(object, rows);
  }
  bool AreAlike(const JobSettings& plate, size_t object, const JobRows& other) const override {
    return FdmOf(plate).objects[object] == FdmOf(other).object;
  }
  void AddObject(const JobRows& object, JobSettings& plate) const override {
    FdmOf(plate).objects.push_back(FdmOf(object).object);
  }
  absl::Status FinishPlate(const JobRows& job, RegionRows& rows,
                           JobSettings& plate) const override {
    return fdm::FinishPlate(job, rows, plate);
  }

  /// Returns the file formats. The profile of a printer decides whether the printer reads binary
  /// G-code; the file name does not matter. A file name .gcode.3mf selects an archive.
  std::vector<FileFormat> FileFormats() const override {
    constexpr std::string_view kKey = "binary_gcode";
    return {
        {.suffix = ".gcode.3mf", .key = "gcode_3mf", .value = "1", .alone = true, .archive = true},
        {.suffix = ".gcode", .key = kKey, .value = "0", .chosen_by_name = false},
        {.suffix = ".bgcode", .key = kKey, .value = "1", .alone = true, .chosen_by_name = false}};
  }
  double MaterialCostPerKg(const JobSettings& settings) const override {
    return FdmOf(settings).tools.front().filament_cost_per_kg;
  }
};

}  // namespace

const ProcessSettings& Settings() {
  static const OfFdm settings;
  return settings;
}

}  // namespace slicefarm::config::fdm
