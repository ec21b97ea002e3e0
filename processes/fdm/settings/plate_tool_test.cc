#include "processes/fdm/settings/plate_tool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/config/plate.h"
#include "common/model/options/motion_options.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm::plate_tool_test {
namespace {

using ::testing::HasSubstr;

using Settings = std::vector<Setting>;

SceneObject Object(const std::string& name, Settings settings = {}, Settings of_part = {}) {
  SceneObject object;
  object.name = name;
  object.settings = std::move(settings);
  Part part;
  part.name = "part of " + name;
  part.settings = std::move(of_part);
  object.parts.push_back(std::move(part));
  object.instances.emplace_back();
  return object;
}

Setting Tool(const char* number, const char* key = "extruder") {
  return {key, number, Source::kProfile};
}

struct Case {
  std::string name;
  Settings job;
  std::vector<SceneObject> objects;
  std::string want;  ///< extruder of the job; empty: the first one
};

class OneToolTest : public testing::TestWithParam<Case> {};

TEST_P(OneToolTest, IsTheJobs) {
  Settings job = GetParam().job;
  std::vector<SceneObject> objects = GetParam().objects;
  std::vector<MissingFeature> missing;
  const absl::Status status = UnifyTool(job, objects, missing);
  ASSERT_TRUE(status.ok()) << status;
  EXPECT_TRUE(missing.empty());
  EXPECT_EQ(job.empty() ? "" : job.front().value, GetParam().want);
  for (const SceneObject& object : objects) EXPECT_TRUE(object.settings.empty());
}

SceneObject WithModifier(SceneObject object, Settings settings) {
  Part part;
  part.name = "modifier";
  part.role = PartRole::kModifier;
  part.settings = std::move(settings);
  object.parts.push_back(std::move(part));
  return object;
}

SceneObject WithRange(SceneObject object, Settings settings) {
  object.ranges.push_back({1, 2, std::move(settings)});
  return object;
}

SceneObject Hidden(SceneObject object) {
  object.instances.front().printable = false;
  return object;
}

INSTANTIATE_TEST_SUITE_P(
    Plates, OneToolTest,
    testing::Values(Case{"None", {}, {Object("a")}, ""},
                    Case{"First", {Tool("1")}, {Object("a")}, ""},
                    Case{"Job", {Tool("2")}, {Object("a")}, "2"},
                    Case{"Object", {}, {Object("a", {Tool("2")}), Object("b", {Tool("2")})}, "2"},
                    Case{"Part", {}, {Object("a", {}, {Tool("3")})}, "3"},
                    Case{"PartOverObject", {}, {Object("a", {Tool("2")}, {Tool("1")})}, ""},
                    Case{"PartAsItsObject", {}, {Object("a", {Tool("2")}, {Tool("0")})}, "2"},
                    Case{"Lines",
                         {Tool("2", "perimeter_extruder"), Tool("2", "infill_extruder"),
                          Tool("2", "solid_infill_extruder")},
                         {Object("a")},
                         "2"},
                    Case{"ModifierWithItsObjects",
                         {},
                         {WithModifier(Object("a", {Tool("2")}), {Tool("2")})},
                         "2"},
                    Case{"ModifierWithout", {}, {WithModifier(Object("a", {Tool("2")}), {})}, "2"},
                    Case{"NotPrinted", {}, {Object("a", {Tool("2")}), Hidden(Object("b"))}, "2"}),
    [](const auto& info) { return info.param.name; });

struct ManyCase {
  std::string name;
  Settings job;
  std::vector<SceneObject> objects;
  std::vector<std::string> named;
};

class ManyToolsTest : public testing::TestWithParam<ManyCase> {};

TEST_P(ManyToolsTest, AreMissingByName) {
  Settings job = GetParam().job;
  std::vector<SceneObject> objects = GetParam().objects;
  std::vector<MissingFeature> missing;
  const absl::Status status = UnifyTool(job, objects, missing);
  ASSERT_TRUE(status.ok()) << status;
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].feature, "several_tools");
  EXPECT_EQ(missing[0].metadata.at("setting"), "extruder");
  for (const std::string& name : GetParam().named) EXPECT_THAT(missing[0].text, HasSubstr(name));
  // The first of them prints everything.
  const std::string_view tool = job.empty() ? "1" : std::string_view(job.front().value);
  EXPECT_THAT(missing[0].text, HasSubstr("number " + std::string(tool) + ":"));
}

INSTANTIATE_TEST_SUITE_P(Plates, ManyToolsTest,
                         testing::Values(ManyCase{"Objects",
                                                  {},
                                                  {Object("a"), Object("b", {Tool("2")})},
                                                  {"extruder 1: \"a\"", "extruder 2: \"b\""}},
                                         ManyCase{"Modifier",
                                                  {},
                                                  {WithModifier(Object("a"), {Tool("2")})},
                                                  {"extruder 2: \"a\", \"modifier\""}},
                                         ManyCase{"Range",
                                                  {},
                                                  {WithRange(Object("a"), {Tool("4")})},
                                                  {"extruder 4: \"a\" from 1 to 2 mm"}},
                                         ManyCase{"Infill",
                                                  {Tool("2", "infill_extruder")},
                                                  {Object("a")},
                                                  {"extruder 1", "extruder 2"}}),
                         [](const auto& info) { return info.param.name; });

TEST(UnifyTool, WantsANumber) {
  Settings job = {Tool("two")};
  std::vector<SceneObject> objects = {Object("a")};
  std::vector<MissingFeature> missing;
  EXPECT_EQ(DetailOf(UnifyTool(job, objects, missing)).reason, Reason::kSettingOutOfRange);
}

// The second filament is hotter, thicker and retracted further; the derived settings show this.
TEST(ResolvePlate, TakesTheFilamentOfTheTool) {
  const Settings job = {{"nozzle_diameter", "0.4,0.6", Source::kProfile},
                        {"temperature", "210,245", Source::kProfile},
                        {"first_layer_temperature", "215,250", Source::kProfile},
                        {"bed_temperature", "60,90", Source::kProfile},
                        {"filament_type", "PLA;PETG", Source::kProfile},
                        {"retract_length", "0.8,1.2", Source::kProfile},
                        {"filament_density", "1.24", Source::kProfile},
                        {"start_filament_gcode", "\"; one\";\"; two\"", Source::kProfile}};
  const auto plate =
      ResolvePlate(job, std::vector<SceneObject>{Object("a", {Tool("2")})}, Process::kFdm);
  ASSERT_TRUE(plate.ok()) << plate.status();
  const MotionOptions motion = MotionOf(FdmOf(plate->settings));
  EXPECT_EQ(motion.tool().nozzle_diameter_mm, 0.6);
  EXPECT_EQ(motion.tool().temperature_c, 245);
  EXPECT_EQ(motion.tool().first_layer_temperature_c, 250);
  EXPECT_EQ(motion.tool().bed_temperature_c, 90);
  EXPECT_EQ(motion.tool().filament_type, "PETG");
  EXPECT_EQ(motion.tool().retraction.length_mm, 1.2);
  EXPECT_EQ(motion.tool().filament_density_g_cm3, 1.24);
  EXPECT_EQ(motion.tool().number, 1);
  EXPECT_EQ(motion.tool().start_filament_gcode, "; two");
}

}  // namespace
}  // namespace slicefarm::config::fdm::plate_tool_test
