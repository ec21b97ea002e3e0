#include "processes/fdm/settings/fdm_settings.h"

#include <algorithm>
#include <iterator>

#include "common/config/table/known_keys.h"
#include "common/config/table/shared_settings.h"
#include "processes/fdm/settings/check_settings.h"
#include "processes/fdm/settings/compatibility.h"
#include "processes/fdm/settings/derive.h"
#include "processes/fdm/settings/needs.h"
#include "processes/fdm/settings/plate_settings.h"
#include "processes/fdm/settings/plate_tool.h"
#include "processes/fdm/settings/region_table.h"
#include "processes/fdm/settings/settle.h"
#include "processes/fdm/settings/table/scopes.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

constexpr std::string_view kMachineKeys[] = {"bed_shape", "nozzle_diameter", "gcode_flavor"};

class OfFdm : public ProcessSettings {
 public:
  JobSettings Standards() const override { return {.slicing = {}, .own = FdmSettings()}; }
  std::vector<SettingSpec> Table() const override {
    std::vector<SettingSpec> all;
    for (const auto& section : {LayerSettings, SlicingSettings, WallSettings, SeamSettings,
                                InfillSettings, AdhesionSettings, SupportSettings, SpeedSettings,
                                FilamentSettings, MachineSettings, WritingSettings})
      std::ranges::move(section(), std::back_inserter(all));
    SetScopes(all);
    return all;
  }
  /// What PrusaSlicer knows is about filament.
  bool Knows(std::string_view key) const override { return FindKnownKey(key) != nullptr; }
  std::vector<Need> Needs() const override { return fdm::Needs(); }

  std::span<const std::string_view> MachineKeys() const override { return kMachineKeys; }

  size_t ListItem(std::span<const Setting> given) const override { return ToolOf(given); }
  absl::Status Derive(Draft& draft, ResolvedSettings& result) const override {
    return fdm::Derive(draft, result);
  }
  absl::Status Check(const Draft& draft) const override { return CheckSettings(draft); }
  absl::Status Settle(const Settling& settling) const override { return fdm::Settle(settling); }
  absl::Status Finish(const Draft& draft, ResolvedSettings& result) const override {
    return TakeGcode(draft, result);
  }

  absl::Status TakeTogether(std::vector<Setting>& job, std::vector<SceneObject>& objects,
                            std::vector<MissingFeature>& missing) const override {
    return TakeTool(job, objects, missing);
  }
  std::vector<MissingFeature> Incompatible(std::span<const Setting> job,
                                           std::string_view settings_text) const override {
    return IncompatibleProfiles(job, settings_text);
  }
  void BeginPlate(JobSettings& plate) const override { FdmOf(plate).planning.objects.clear(); }
  std::unique_ptr<RegionRows> NewRows() const override { return std::make_unique<RegionTable>(); }
  std::vector<std::string> UnmetNeedsOf(const SceneObject& object,
                                        const JobSettings& settings) const override {
    return NeedsOfObject(object, settings);
  }
  absl::Status AddRows(JobSettings& object, RegionRows& rows) const override {
    return AddAdhesionRows(object, rows);
  }
  bool AreAlike(const JobSettings& plate, size_t object, const JobSettings& other) const override {
    return FdmOf(plate).planning.objects[object] == FdmOf(other).planning.objects.front();
  }
  void AddObject(const JobSettings& object, JobSettings& plate) const override {
    FdmOf(plate).planning.objects.push_back(FdmOf(object).planning.objects.front());
  }
  absl::Status FinishPlate(const JobSettings& job, RegionRows& rows,
                           JobSettings& plate) const override {
    return fdm::FinishPlate(job, rows, plate);
  }

  /// A printer's profile says whether it reads binary G-code, whatever the file is called.
  std::vector<FileFormat> FileFormats() const override {
    constexpr std::string_view kKey = "binary_gcode";
    return {
        {.suffix = ".gcode", .key = kKey, .value = "0", .chosen_by_name = false},
        {.suffix = ".bgcode", .key = kKey, .value = "1", .alone = true, .chosen_by_name = false}};
  }
  double MaterialCostPerKg(const JobSettings& settings) const override {
    return FdmOf(settings).motion.filament_cost_per_kg;
  }
};

}  // namespace

const ProcessSettings& Settings() {
  static const OfFdm settings;
  return settings;
}

}  // namespace slicefarm::config::fdm
