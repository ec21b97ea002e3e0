#include "services/exposure/algo/writers/laser_gcode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "services/exposure/algo/writers/sample_layers_test.h"

namespace slicefarm::exposure::laser_gcode_test {
namespace {

/// Strict reader of laser G-code. It fails on an unknown word, a word twice in a line, a travel
/// with power on, or a move before its mode.
class Machine {
 public:
  struct Exposure {
    double x0, y0, x1, y1, feed, power;
  };

  void Run(const std::string& file) {
    std::istringstream stream(file);
    for (std::string line; std::getline(stream, line) && !::testing::Test::HasFailure();)
      RunLine(line);
  }

  std::vector<Exposure> exposures;
  std::vector<double> heights, waits;
  bool on = false, ended = false;
  bool constant_power = false;

 private:
  void RunLine(std::string line) {
    line = line.substr(0, line.find(';'));
    std::map<char, double> words;
    std::istringstream stream(line);
    std::optional<int> command;
    char group = 0;
    for (std::string word; stream >> word;) {
      const char letter = word[0];
      ASSERT_TRUE(std::string("GMXYZFSIP").find(letter) != std::string::npos) << line;
      ASSERT_FALSE(ended) << line;
      const double value = word.size() > 1 ? std::stod(word.substr(1)) : 0;
      if (letter == 'G' || letter == 'M') {
        ASSERT_FALSE(command) << line;
        command = static_cast<int>(value);
        group = letter;
        continue;
      }
      ASSERT_TRUE(words.emplace(letter, value).second) << line;
    }
    if (!command) {
      ASSERT_TRUE(words.empty()) << line;
      return;
    }
    if (group == 'M') return Switch(*command, words, line);
    if (*command == 21) return void(metric_ = true);
    if (*command == 90) return void(absolute_ = true);
    if (*command == 94) return;
    ASSERT_TRUE(*command == 0 || *command == 1 || *command == 4) << line;
    ASSERT_TRUE(metric_ && absolute_) << line;
    if (*command == 4) return Wait(words, line);
    if (words.contains('S')) power_ = words.at('S');
    if (words.contains('F')) feed_ = words.at('F');
    ASSERT_TRUE(*command != 0 || power_ == 0) << line;
    if (words.contains('Z')) {
      ASSERT_FALSE(on) << line;
      heights.push_back(words.at('Z'));
      return;
    }
    const double x = words.at('X'), y = words.at('Y');
    if (*command == 1) {
      ASSERT_TRUE(on && feed_ > 0) << line;
      if (power_ > 0) exposures.push_back({x_, y_, x, y, feed_, power_});
    }
    x_ = x, y_ = y;
  }

  /// Checks a pause: a laser that is on while the head does not move burns a hole. M4 turns it off.
  void Wait(const std::map<char, double>& words, const std::string& line) {
    ASSERT_TRUE(!on || !constant_power || power_ == 0) << line;
    waits.push_back(words.at('P'));
  }

  void Switch(int command, const std::map<char, double>& words, const std::string& line) {
    ASSERT_TRUE(command >= 2 && command <= 5) << line;
    if (command == 2) return void(ended = true);
    on = command != 5;
    constant_power = command == 3;
    power_ = words.contains('S') ? words.at('S') : 0;
    ASSERT_EQ(power_, 0) << line;
  }

  bool metric_ = false, absolute_ = false;
  double x_ = 0, y_ = 0, feed_ = 0, power_ = 0;
};

TEST(LaserGcode, IsReadBackByAStrictMachine) {
  for (const OutputFormat format : {OutputFormat::kGrbl, OutputFormat::kMarlin}) {
    Machine machine;
    machine.Run(SampleFile(format));
    EXPECT_FALSE(machine.on);
    EXPECT_EQ(machine.ended, format == OutputFormat::kGrbl);
    EXPECT_EQ(machine.heights, (std::vector<double>{0.05, 0.1}));
    size_t next = 0;
    const FileFacts facts = SampleFacts(format);
    for (const ExposedLayer& layer : SampleLayers()) {
      for (const PlateLine& line : PlateLines(layer)) {
        const ExposureStyle& style =
            facts.regions[static_cast<size_t>(line.settings)].StyleOf(line.kind);
        for (size_t i = 0; i + 1 < line.points.size(); ++i, ++next) {
          ASSERT_LT(next, machine.exposures.size());
          const Machine::Exposure& move = machine.exposures[next];
          EXPECT_NEAR(move.x0, ToMm(static_cast<double>(line.points[i].x)), 1e-4);
          EXPECT_NEAR(move.y0, ToMm(static_cast<double>(line.points[i].y)), 1e-4);
          EXPECT_NEAR(move.x1, ToMm(static_cast<double>(line.points[i + 1].x)), 1e-4);
          EXPECT_NEAR(move.y1, ToMm(static_cast<double>(line.points[i + 1].y)), 1e-4);
          EXPECT_NEAR(move.feed, style.speed_mm_s * 60, 0.1);
          EXPECT_NEAR(move.power, style.power_w / 400 * 1000, 0.01);
        }
      }
    }
    EXPECT_EQ(next, machine.exposures.size());
  }
}

/// The user's code runs with the laser off, in absolute mm. The machine's own commands follow the
/// start code.
TEST(LaserGcode, OwnCodeStandsAroundTheMoveInZ) {
  FileFacts facts = SampleFacts(OutputFormat::kGrbl);
  facts.start_code = "G28\n";
  facts.end_code = "M30\n";
  const std::string header = FileHeader(facts), footer = FileFooter(facts);
  EXPECT_LT(header.find("G28\n"), header.find("G21\nG90\nG94\nM5\n"));
  EXPECT_EQ(footer, "M5\nM30\nM2\n");
  const ExposedLayer layer = SampleLayers()[1];
  EXPECT_EQ(LayerHead(layer.frame, {"M100\n", "M101\n"}), "M100\n; layer 1\nG0 Z0.1\nM101\n");
  EXPECT_TRUE(LayerText(layer, facts).starts_with("M4 S0\n"));
}

TEST(LaserGcode, ConstantPowerIsM3) {
  FileFacts facts = SampleFacts(OutputFormat::kGrbl);
  facts.output.dynamic_power = false;
  const std::string text = LayerText(SampleLayers()[0], facts);
  EXPECT_NE(text.find("M3 S0\n"), std::string::npos);
  EXPECT_EQ(text.find("M4"), std::string::npos);
}

/// Returns the text of a hatch of two lines and a triangle: 3 jumps and ends of lines, 2 corners.
std::string WithDelays(OutputFormat format, bool dynamic_power, Coord run_nm, Machine& machine) {
  std::vector<ExposureOptions> regions(1);
  regions[0].jump = {
      .speed_mm_s = 2000, .delay_us = 250, .mark_delay_us = 1500, .polygon_delay_us = 40};
  FileFacts facts = SampleFacts(format);
  facts.regions = regions;
  facts.output.dynamic_power = dynamic_power;
  ExposedLayer layer = SampleLayers()[0];
  layer.groups[0] = {};
  layer.groups[0].kind = ExposureKind::kContour;
  layer.groups[0].AddLine(Polyline{{0, 0}, {10'000'000, 0}, {10'000'000, 5'000'000}, {0, 0}});
  layer.groups[1].run_nm = run_nm;
  layer.groups.resize(2);
  layer.visits = {{0, 0, {}}};
  const std::string text = LayerText(layer, facts);
  machine.Run("G21\nG90\n" + text);
  return text;
}

TEST(LaserGcode, DelaysAreDwells) {
  for (const bool dynamic_power : {true, false}) {
    Machine grbl, marlin;
    WithDelays(OutputFormat::kGrbl, dynamic_power, 0, grbl);
    const double jump = 0.00025, mark = 0.0015, corner = 0.00004;
    EXPECT_EQ(grbl.waits,
              (std::vector<double>{jump, corner, corner, mark, jump, mark, jump, mark}));
    WithDelays(OutputFormat::kMarlin, dynamic_power, 0, marlin);  // whole ms
    EXPECT_EQ(marlin.waits, (std::vector<double>{1, 1, 1, 2, 1, 2, 1, 2}));
    EXPECT_EQ(grbl.exposures.size(), 5u);
  }
}

TEST(LaserGcode, SkywritingNeedsNoMarkDelay) {
  Machine machine;
  WithDelays(OutputFormat::kGrbl, true, 500'000, machine);
  EXPECT_EQ(std::count(machine.waits.begin(), machine.waits.end(), 0.0015), 1);  // the contour
}

TEST(LaserGcode, MarlinIsToldTheSpeedOfJumps) {
  Machine machine;
  EXPECT_NE(WithDelays(OutputFormat::kMarlin, true, 0, machine).find("F120000"), std::string::npos);
  EXPECT_EQ(WithDelays(OutputFormat::kGrbl, true, 0, machine).find("F120000"), std::string::npos);
}

TEST(LaserGcode, FocusRaisesTheHead) {
  std::vector<ExposureOptions> regions(2);
  regions[0].styles[1].focus_mm = 1.5;
  regions[1].styles[4].focus_mm = -0.25;
  FileFacts facts = SampleFacts(OutputFormat::kGrbl);
  facts.regions = regions;
  Machine machine;
  const ExposedLayer layer = SampleLayers()[0];
  machine.Run("G21\nG90\n" + LayerHead(layer.frame, {}) + LayerText(layer, facts));
  // Contours and hatch of a copy, a thin wall, and another copy.
  EXPECT_EQ(machine.heights, (std::vector<double>{0.05, 1.55, -0.2, 0.05, 1.55}));
}

TEST(LaserGcode, SkywritingRunsWithoutPower) {
  std::vector<ExposedLayer> layers = SampleLayers();
  layers[0].groups = {layers[0].groups[1]};
  layers[0].groups[0].run_nm = 500'000;
  layers[0].groups[0].points = {{0, 0}, {4'000'000, 3'000'000}};
  layers[0].visits = {{0, 0, {}}};
  const std::string text = LayerText(layers[0], SampleFacts(OutputFormat::kGrbl));
  EXPECT_NE(text.find("G0 X-0.4 Y-0.3\nG1 X0 Y0 F72000\nG1 X4 Y3 S500\nG1 X4.4 Y3.3 S0\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace slicefarm::exposure::laser_gcode_test
