#include <cstdlib>
#include <vector>

#include "common/config/process_settings.h"
#include "common/config/table/settings_table.h"
#include "processes/engrave/settings/engrave_settings.h"
#include "processes/fdm/settings/fdm_settings.h"
#include "processes/laser/settings/laser_settings.h"
#include "processes/mill/settings/mill_settings.h"

namespace slicefarm::config {

const ProcessSettings& SettingsOf(Process process) {
  switch (process) {
    case Process::kFdm:
      return fdm::Settings();
    case Process::kLaser:
      return laser::Settings();
    case Process::kMill:
      return mill::Settings();
    case Process::kEngrave:
      return engrave::Settings();
  }
  std::abort();  // unreachable: all values of Process are handled
}

std::vector<SettingSpec> SpecsOf(Process process) { return SettingsOf(process).Table(); }

}  // namespace slicefarm::config
