#include "processes/mill/settings/mill_settings.h"

#include <algorithm>

#include "common/config/table/shared_settings.h"
#include "processes/mill/model/check_milling.h"
#include "processes/mill/settings/mill_table.h"

namespace slicefarm::config::mill {
namespace {

/// Returns the plate settings with defaults for milling. The table of a machine tool is larger than
/// a printer's bed, and the height of the machine does not limit parts.
std::vector<SettingSpec> TableSettings() {
  std::vector<SettingSpec> all = PlateSettings();
  for (SettingSpec& spec : all) {
    if (spec.key == "bed_shape") {
      spec.standard = "0x0,1000x0,1000x1000,0x1000";
      spec.doc =
          "Outline of the table on which parts are arranged: corners XxY in mm, separated by "
          "commas";
    }
    if (spec.key == "max_print_height") {
      spec.standard = "0";
      spec.doc = "Largest height of parts that the machine can mill; 0: no limit";
    }
    if (spec.key == "duplicate_distance") {
      spec.standard = "20";
      spec.doc =
          "Distance between copies that are arranged automatically; the cutter must fit between "
          "them";
    }
  }
  return all;
}

class OfMilling : public ProcessSettings {
 public:
  JobRows Standards() const override {
    return {.slicing = {}, .object = {}, .own = MillSettings()};
  }
  ProcessValue PlateOf(const ProcessValue& job) const override { return job.As<MillSettings>(); }
  std::vector<SettingSpec> Table() const override {
    constexpr SettingGroup kGroups[] = {{"milling", MillTable}, {"machine", TableSettings}};
    return TableOf(kGroups);
  }
  absl::Status Derive(SettingValues& /*draft*/, ResolvedSettings& /*result*/) const override {
    return absl::OkStatus();
  }
  absl::Status Check(const SettingValues& /*draft*/) const override { return absl::OkStatus(); }
  absl::Status Finish(const SettingValues& /*draft*/, ResolvedSettings& result) const override {
    return CheckMillingOptions(MillOf(result.settings).how);
  }
  ResultWords Words() const override { return {"step", "steps", "to mill"}; }
  std::string_view Example() const override {
    return "slicefarm slice part.stl -o part.nc --machine mill --set cutter=ball:4";
  }
  std::vector<FileFormat> FileFormats() const override {
    return {{".ngc", "dialect", "linuxcnc", true},
            {".nc", "output_format", "gcode"},
            {".gcode", "output_format", "gcode"},
            {".svg", "output_format", "svg"}};
  }
};

}  // namespace

const ProcessSettings& Settings() {
  static const OfMilling settings;
  return settings;
}

}  // namespace slicefarm::config::mill
