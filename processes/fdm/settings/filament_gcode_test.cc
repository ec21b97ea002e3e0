#include "processes/fdm/settings/filament_gcode.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "common/config/resolve.h"
#include "processes/fdm/settings/draft_of_test.h"

namespace slicefarm::config::fdm::filament_gcode_test {
namespace {

absl::Status Fault(const Pairs& given) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value});
  return Resolve(settings, Process::kFdm).status();
}

struct Case {
  const char* name;
  Pairs given;
  const char* setting;
  const char* line;
};

TEST(FilamentGcode, ErrorsNameTheSettingThatTheLineIsWrittenIn) {
  const Case cases[] = {
      {"of the filament", {{"start_filament_gcode", "{nothing}"}}, "start_filament_gcode", "1"},
      {"its second line",
       {{"start_gcode", "G28\nG1 Z5"}, {"start_filament_gcode", "G92 E0\n{nothing}\n"}},
       "start_filament_gcode",
       "2"},
      {"before it",
       {{"start_gcode", "G28\n{nothing}"}, {"start_filament_gcode", "G92 E0"}},
       "start_gcode",
       "2"},
      {"after the layers", {{"end_filament_gcode", "G1\n{nothing}"}}, "end_filament_gcode", "2"},
      {"behind it",
       {{"end_filament_gcode", "G1\nG1"}, {"end_gcode", "M84\n{nothing}"}},
       "end_gcode",
       "2"},
      {"that does not parse", {{"start_filament_gcode", "{1 +}"}}, "start_filament_gcode", "1"},
      {"of neither", {{"layer_gcode", "{nothing}"}}, "layer_gcode", "1"}};
  for (const Case& c : cases) {
    const absl::Status status = Fault(c.given);
    ASSERT_FALSE(status.ok()) << c.name;
    ErrorDetail detail = DetailOf(status);
    EXPECT_EQ(detail.reason, Reason::kSettingMalformed) << c.name;
    EXPECT_EQ(detail.metadata["setting"], c.setting) << c.name;
    EXPECT_EQ(detail.metadata["line"], c.line) << c.name;
    const std::string begins = std::string(c.setting) + ", line " + c.line + ": ";
    EXPECT_EQ(std::string(status.message()).substr(0, begins.size()), begins) << c.name;
  }
}

}  // namespace
}  // namespace slicefarm::config::fdm::filament_gcode_test
