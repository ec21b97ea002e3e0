#include "services/cli/calibration/chosen_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::cli::chosen_value_test {
namespace {

const CalibrationTable kFlow = {
    "flow",
    "%",
    "extrusion_multiplier",
    {{"+5", 0.98 * 1.05, 0, 0, ""}, {"0", 0.98, 0, 0, ""}, {"-5", 0.98 * 0.95, 0, 0, ""}}};

TEST(ValueAt, IsTheLabelsOrBetweenThem) {
  EXPECT_DOUBLE_EQ(*ValueAt(kFlow, "+5"), 0.98 * 1.05);
  EXPECT_DOUBLE_EQ(*ValueAt(kFlow, "5"), 0.98 * 1.05);
  EXPECT_DOUBLE_EQ(*ValueAt(kFlow, "-5"), 0.98 * 0.95);
  EXPECT_DOUBLE_EQ(*ValueAt(kFlow, "-2.5"), 0.98 * 0.975);
}

TEST(ValueAt, OtherTextsAreErrors) {
  for (const char* text : {"", "6", "-5.01", "2x", "nan", "inf", "++5", "five"}) {
    const absl::Status why = ValueAt(kFlow, text).status();
    EXPECT_EQ(DetailOf(why).reason, Reason::kRequestMalformed) << text;
    EXPECT_THAT(std::string(why.message()), testing::HasSubstr("-5 to 5 %")) << text;
  }
  EXPECT_FALSE(ValueAt({}, "1").ok());
}

TEST(ChosenSettings, EachAxisHasTheJerk) {
  const auto jerk =
      ChosenSettings({"cornering", "mm/s", "machine_max_jerk_x", {{"8", 8, 0, 0, ""}}}, "8");
  ASSERT_TRUE(jerk.ok()) << jerk.status();
  ASSERT_EQ(jerk->size(), 2u);
  EXPECT_EQ((*jerk)[1].key, "machine_max_jerk_y");
  EXPECT_EQ((*jerk)[1].value, "8");
}

TEST(ChosenSettings, SomePrintsHaveNone) {
  for (const CalibrationTable& table :
       {CalibrationTable(), CalibrationTable{"input-shaping", "Hz", "", {{"50", 50, 0, 0, ""}}}})
    EXPECT_EQ(DetailOf(ChosenSettings(table, "50").status()).reason, Reason::kNotSupported);
}

}  // namespace
}  // namespace slicefarm::cli::chosen_value_test
