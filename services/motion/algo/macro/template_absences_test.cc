#include "services/motion/algo/macro/template_absences.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "services/motion/algo/macro/template_variables.h"

namespace slicefarm::motion::template_absences_test {
namespace {

using ::testing::HasSubstr;

TEST(WhyAbsent, GivesTheReason) {
  EXPECT_THAT(std::string(WhyAbsent("used_filament")), HasSubstr("end_gcode"));
  EXPECT_THAT(std::string(WhyAbsent("timestamp")), HasSubstr("clock"));
  EXPECT_EQ(WhyAbsent("no_such_setting"), "");
}

TEST(WhyAbsent, KnowsAllThatOnlyTheWholePrintHas) {
  const TemplateVariables layer = LayerVariables(MotionOptions{}, {}, {});
  for (const auto& [name, value] : ProgramVariables(MotionOptions{}, {}, 0)) {
    EXPECT_EQ(WhyAbsent(name).empty(), layer.contains(name)) << name;
  }
}

}  // namespace
}  // namespace slicefarm::motion::template_absences_test
