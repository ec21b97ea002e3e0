#include "services/cli/calibration/calibration_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <regex>
#include <sstream>

namespace slicefarm::cli::calibration_lines_test {
namespace {

const std::vector<ValueLine> kLines = {
    {"0.00", "M900 K0"}, {"0.02", "M900 K0.02"}, {"0.04", "M900 K0.04"}};

LineSettings Settings() {
  LineSettings settings;
  settings.retract_mm = 0.8;
  settings.middle = {100, 110};
  settings.code_after = "M900 K0.03";
  return settings;
}

/// Extrusions of a code, and the box around them.
struct Drawn {
  double filament_mm = 0, retracted_mm = 0, length_mm = 0;
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
  std::vector<double> speeds;
};

Drawn Read(const std::string& code) {
  Drawn drawn;
  double at[2] = {};
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    static const std::regex kMove("G1 X([0-9.]+) Y([0-9.]+)( E([0-9.]+))? F([0-9]+)");
    static const std::regex kFilament("G1 E(-?[0-9.]+) F[0-9]+");
    if (std::regex_match(line, found, kFilament)) drawn.retracted_mm -= std::stod(found[1]);
    if (!std::regex_match(line, found, kMove)) continue;
    const double to[2] = {std::stod(found[1]), std::stod(found[2])};
    if (found[4].matched) {
      drawn.filament_mm += std::stod(found[4]);
      drawn.length_mm += std::hypot(to[0] - at[0], to[1] - at[1]);
      drawn.speeds.push_back(std::stod(found[5]) / 60);
      for (int i = 0; i < 2; ++i) {
        drawn.low[i] = std::min({drawn.low[i], at[i], to[i]});
        drawn.high[i] = std::max({drawn.high[i], at[i], to[i]});
      }
    }
    std::copy(to, to + 2, at);
  }
  return drawn;
}

/// Returns the highest coordinates of a binary STL file. No coordinate is below 0.
std::array<float, 3> HighOf(const std::string& stl) {
  std::array<float, 3> high = {};
  for (size_t face = 84; face < stl.size(); face += 50)
    for (size_t i = 0; i < 9; ++i) {
      float value;
      std::memcpy(&value, stl.data() + face + 12 + 4 * i, sizeof(value));
      EXPECT_GE(value, 0) << "the frame stands on the bed";
      high[i % 3] = std::max(high[i % 3], value);
    }
  return high;
}

TEST(MakeLinePrint, LinesHaveThePlasticOfTheirBeadsWithinTheFrame) {
  for (const LineShape shape : {LineShape::kStraight, LineShape::kCorner}) {
    const LinePrint print = MakeLinePrint(shape, kLines, Settings());
    const bool corner = shape == LineShape::kCorner;
    ASSERT_EQ(print.codes.size(), corner ? 4u : 1u);
    const auto high = HighOf(print.stl);
    for (const HeightCode& code : print.codes) {
      const Drawn drawn = Read(code.text);
      const double length = corner ? 3 * 3 * 2 * 21 * std::numbers::sqrt2 : 3 * 80;
      EXPECT_NEAR(drawn.length_mm, length, 0.1);
      const double section = 0.2 * (0.45 - 0.2 * (1 - std::numbers::pi / 4)) / 2.4;
      EXPECT_NEAR(drawn.filament_mm, length * section, 0.01);
      EXPECT_NE(code.text.find("G1 E0.8 F2400\n"), std::string::npos) << "restarts";
      EXPECT_NEAR(drawn.retracted_mm, 0, 1e-9) << "each restart has its retraction";
      for (int i = 0; i < 2; ++i) {
        EXPECT_GT(drawn.low[i], Settings().middle[i] - high[i] / 2 + 2);
        EXPECT_LT(drawn.high[i], Settings().middle[i] + high[i] / 2 - 2);
      }
    }
  }
}

TEST(MakeLinePrint, EachLineHasItsValueAndLabel) {
  const LinePrint print = MakeLinePrint(LineShape::kStraight, kLines, Settings());
  const std::string& code = print.codes.front().text;
  size_t at = 0;
  for (const ValueLine& line : kLines) {
    at = code.find(line.code + "\nG1 X", at);
    ASSERT_NE(at, std::string::npos) << line.code;
  }
  EXPECT_TRUE(code.ends_with("M900 K0.03")) << "the value of the filament comes back";
  EXPECT_EQ(Read(code).speeds, (std::vector<double>{20, 100, 20, 20, 100, 20, 20, 100, 20}));
  std::vector<ValueLine> more = kLines;
  more[2].label = "0.05";
  EXPECT_NE(MakeLinePrint(LineShape::kStraight, more, Settings()).stl, print.stl);
}

TEST(MakeLinePrint, WithoutRetractionNothingIsRetracted) {
  LineSettings settings = Settings();
  settings.retract_mm = 0;
  const LinePrint print = MakeLinePrint(LineShape::kCorner, kLines, settings);
  EXPECT_EQ(print.codes[1].text.find("G1 E"), std::string::npos);
  EXPECT_NE(print.codes[1].text.find(" E"), std::string::npos);
}

}  // namespace
}  // namespace slicefarm::cli::calibration_lines_test
