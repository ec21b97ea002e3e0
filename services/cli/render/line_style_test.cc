#include "services/cli/render/line_style.h"

#include <gtest/gtest.h>

namespace slicefarm::cli::line_style_test {
namespace {

TEST(StylesOf, ReadsWhatLabelsSay) {
  const auto styles = StylesOf(
      "$$HEADERSTART\n$$ASCII\n$$UNITS/0.001\n$$LABEL/1,contour 120.5 W 400 mm/s focus 1 mm\n"
      "$$LABEL/2,hatch 200 W 800 mm/s 20 kHz points every 60 um of 30 us and 5 us between\r\n"
      "$$LABEL/3,a bracket\n$$LABEL/none\n");
  ASSERT_EQ(styles.size(), 3u);
  EXPECT_DOUBLE_EQ(styles.at(1).EnergyJPerMm(), 120.5 / 400);
  EXPECT_DOUBLE_EQ(styles.at(2).EnergyJPerMm(), 200 * 30e-6 / 0.06);
  EXPECT_DOUBLE_EQ(styles.at(3).EnergyJPerMm(), 0);
}

TEST(StylesOf, AHeaderWithoutLabels) { EXPECT_TRUE(StylesOf("$$HEADERSTART\n$$ASCII\n").empty()); }

}  // namespace
}  // namespace slicefarm::cli::line_style_test
