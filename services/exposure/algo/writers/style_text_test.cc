#include "services/exposure/algo/writers/style_text.h"

#include <gtest/gtest.h>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure::style_text_test {
namespace {

TEST(StyleText, SaysWhatIsSet) {
  ExposureOptions options;
  EXPECT_EQ(StyleText(options, 0), "contour 200 W 800 mm/s");
  options.styles[3] = {.power_w = 90.5,
                       .speed_mm_s = 400,
                       .focus_mm = 2,
                       .frequency_khz = 50,
                       .point_distance_nm = 65'000,
                       .point_time_us = 40,
                       .point_delay_us = 10};
  EXPECT_EQ(
      StyleText(options, 3),
      "downskin 90.5 W 400 mm/s focus 2 mm 50 kHz points every 65 um of 40 us and 10 us between");
}

}  // namespace
}  // namespace slicefarm::exposure::style_text_test
