#include "common/config/missing_feature.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/config/machine_named.h"
#include "common/config/plate.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::missing_feature_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<MissingFeature> kMissing = {{"several_tools", "two tools", {{"objects", "a"}}},
                                              {"painted_filaments", "paint", {}}};

TEST(CheckMissing, NamesTheFirstThatIsNotAllowed) {
  const absl::Status none = CheckMissing(kMissing, {});
  EXPECT_EQ(none.code(), absl::StatusCode::kInvalidArgument);
  const ErrorDetail detail = DetailOf(none);
  EXPECT_EQ(detail.reason, Reason::kNotSupported);
  EXPECT_EQ(detail.metadata.at("feature"), "several_tools");
  EXPECT_EQ(detail.metadata.at("allow"), "several_tools");
  EXPECT_EQ(detail.metadata.at("objects"), "a");
  EXPECT_THAT(std::string(none.message()), HasSubstr("two tools"));
  const std::vector<std::string> one = {"several_tools"};
  EXPECT_EQ(DetailOf(CheckMissing(kMissing, one)).metadata.at("feature"), "painted_filaments");
  const std::vector<std::string> all = {"painted_filaments", "several_tools"};
  EXPECT_TRUE(CheckMissing(kMissing, all).ok());
  EXPECT_TRUE(CheckMissing({}, {}).ok());
}

TEST(CheckAllowed, KnowsEachNameAndSuggestsOthers) {
  for (const Allowance& each : Allowances()) {
    const std::vector<std::string> names = {std::string(each.name)};
    EXPECT_TRUE(CheckAllowed(names).ok()) << each.name;
    EXPECT_FALSE(each.doc.empty()) << each.name;
  }
  const std::vector<std::string> wrong = {"several_tools", "severaltools"};
  const absl::Status status = CheckAllowed(wrong);
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(status).metadata.at("suggestion"), "several_tools");
}

std::vector<Setting> Given(std::initializer_list<const char*> keys) {
  std::vector<Setting> given;
  for (const char* key : keys) given.push_back({key, "1", Source::kProfile});
  return given;
}

TEST(CheckMachineNamed, WantsAllKeysOfAMachine) {
  EXPECT_TRUE(CheckMachineNamed(Given({"gcode_flavor", "skirts", "bed_shape", "nozzle_diameter"}),
                                Process::kFdm)
                  .ok());
  const absl::Status none = CheckMachineNamed(Given({"bed_shape"}), Process::kFdm);
  EXPECT_EQ(DetailOf(none).reason, Reason::kPrinterMissing);
  EXPECT_EQ(DetailOf(none).metadata.at("settings"), "nozzle_diameter, gcode_flavor");
  EXPECT_TRUE(CheckMachineNamed({}, Process::kLaser).ok()) << "it has no such profiles";
}

ResolvedPlate PlateOf(std::vector<Setting> job) {
  SceneObject object;
  object.name = "a";
  object.parts.emplace_back();
  object.instances.emplace_back();
  const auto plate = ResolvePlate(job, std::vector{object}, Process::kFdm);
  EXPECT_TRUE(plate.ok()) << plate.status();
  return plate.value_or(ResolvedPlate());
}

struct Case {
  const char* name;
  Setting setting;
  const char* feature;  ///< expected feature; empty: none is missing
};

class PlateTest : public testing::TestWithParam<Case> {};

TEST_P(PlateTest, TellsWhatSpoilsThePrint) {
  const ResolvedPlate plate = PlateOf({GetParam().setting});
  if (std::string_view(GetParam().feature).empty()) {
    EXPECT_THAT(plate.missing, IsEmpty());
    return;
  }
  ASSERT_EQ(plate.missing.size(), 1u);
  EXPECT_EQ(plate.missing[0].feature, GetParam().feature);
  EXPECT_THAT(plate.warnings, testing::Contains(plate.missing[0].text));
}

INSTANTIATE_TEST_SUITE_P(
    Settings, PlateTest,
    testing::Values(
        Case{"Colours", {"colorprint_heights", "5", Source::kProfile}, "colorprint_heights"},
        Case{"NoColours", {"colorprint_heights", "", Source::kProfile}, ""},
        Case{"Resin", {"printer_technology", "SLA", Source::kProfile}, "printer_technology"},
        Case{"Filament", {"printer_technology", "FFF", Source::kProfile}, ""},
        Case{"LayerCode", {"layer_gcode", "{no_such_name}", Source::kProfile}, "gcode_templates"},
        Case{"FilamentCode",
             {"start_filament_gcode", "\"{if x}\"", Source::kProfile},
             "gcode_templates"},
        Case{"GoodCode", {"layer_gcode", "; {layer_num}", Source::kProfile}, ""},
        Case{"Detail", {"wipe_tower_width", "60", Source::kProfile}, ""}),
    [](const auto& info) { return info.param.name; });

TEST(ResolvePlate, LeavesOutATemplateThatCannotBeExpanded) {
  const ResolvedPlate plate = PlateOf({{"layer_gcode", "{no_such_name}", Source::kProfile}});
  EXPECT_EQ(FdmOf(plate.settings).machine.motion.layer_gcode.str(), "");
}

// A machine that is not homed or that stays hot is dangerous.
TEST(ResolvePlate, NeverLeavesOutStartAndEnd) {
  for (const char* key : {"start_gcode", "end_gcode"}) {
    const std::vector<Setting> job = {{key, "{no_such_name}", Source::kProfile}};
    EXPECT_EQ(DetailOf(ResolvePlate(job, {}, Process::kFdm).status()).reason,
              Reason::kSettingMalformed)
        << key;
  }
}

}  // namespace
}  // namespace slicefarm::config::missing_feature_test
