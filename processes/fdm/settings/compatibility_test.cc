#include "processes/fdm/settings/compatibility.h"

#include <gtest/gtest.h>

#include <string>

namespace slicefarm::config::fdm::compatibility_test {
namespace {

constexpr char kMk4s[] =
    "printer_model = MK4S\nnozzle_diameter = 0.4\nlayer_height = 0.2\n"
    "printer_notes = Do not remove these lines\\nPRINTER_VENDOR_PRUSA3D\\nNO_TEMPLATES\n";

struct Case {
  const char* name;
  std::vector<Setting> given;
  int missing;
};

class ConditionTest : public testing::TestWithParam<Case> {};

TEST_P(ConditionTest, IsEvaluated) {
  const auto missing = IncompatibleProfiles(GetParam().given, kMk4s);
  EXPECT_EQ(static_cast<int>(missing.size()), GetParam().missing);
  for (const MissingFeature& each : missing) EXPECT_EQ(each.feature, "incompatible_profiles");
}

Setting Of(const char* key, const char* value) { return {key, value, Source::kProfile}; }
constexpr char kPrinters[] = "compatible_printers_condition";
constexpr char kPrints[] = "compatible_prints_condition";

// Conditions from the profiles of Prusa, Creality and other vendors.
INSTANTIATE_TEST_SUITE_P(
    Profiles, ConditionTest,
    testing::Values(
        Case{"None", {Of("layer_height", "0.2")}, 0}, Case{"Empty", {Of(kPrinters, "")}, 0},
        Case{"Model",
             {Of(kPrinters, "printer_model=~/(MK4S|MK4SMMU3)/ and nozzle_diameter[0]==0.4")},
             0},
        Case{"OtherModel",
             {Of(kPrinters, "printer_model=~/(ENDER3|CR10)/ and nozzle_diameter[0]==0.4")},
             1},
        Case{"OtherNozzle", {Of(kPrinters, "nozzle_diameter[0]==0.6")}, 1},
        Case{"Notes", {Of(kPrinters, "printer_notes=~/.*PRINTER_VENDOR_PRUSA3D.*/")}, 0},
        Case{"NotNotes", {Of(kPrinters, "printer_notes!~/.*NO_TEMPLATES.*/")}, 1},
        Case{"Negated", {Of(kPrinters, "! (printer_notes=~/.*PRINTER_VENDOR_E3D.*/)")}, 0},
        Case{"Prints", {Of(kPrints, "layer_height<=0.1")}, 1},
        // Condition of a print profile, then of a filament.
        Case{"Stacked",
             {Of(kPrinters, "nozzle_diameter[0]==0.4"), Of(kPrinters, "nozzle_diameter[0]==0.8")},
             1},
        Case{"Cumulated",
             {Of("compatible_printers_condition_cummulative",
                 "\"nozzle_diameter[0]==0.4\";\"printer_model==\\\"MINI\\\"\"")},
             1},
        // A whole config.ini replaces the settings before it.
        Case{"Replaced",
             {Of(kPrinters, "nozzle_diameter[0]==0.8"),
              Of("compatible_printers_condition_cummulative", "nozzle_diameter[0]==0.4;;")},
             0},
        Case{"Unreadable", {Of(kPrinters, "nozzle_diameter[0]==")}, 0},
        Case{"UnknownName", {Of(kPrinters, "no_such_setting==1")}, 0}),
    [](const auto& info) { return info.param.name; });

TEST(IncompatibleProfiles, QuotesTheCondition) {
  const std::vector<Setting> given = {Of(kPrinters, "nozzle_diameter[0]==0.6")};
  const auto missing = IncompatibleProfiles(given, kMk4s);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_NE(missing[0].text.find("nozzle_diameter[0]==0.6"), std::string::npos);
  EXPECT_EQ(missing[0].metadata.at("setting"), kPrinters);
}

}  // namespace
}  // namespace slicefarm::config::fdm::compatibility_test
