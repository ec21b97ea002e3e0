#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "common/model/options/motion_options.h"
#include "common/model/paths_test.h"
#include "services/motion/algo/layer_program.h"

namespace slicefarm::motion::layer_words_test {
namespace {

using testing::HasSubstr;
using testing::Not;

Path Line(Feature feature, std::string_view points, bool closed = false) {
  Path path = MakePathOrDie(points, closed);
  path.feature = feature;
  return path;
}

/// Two squares of two copies each, far from one another.
OrderedLayer Squares() {
  OrderedLayer layer;
  layer.frame = {2, 600'000, 200'000};
  layer.blocks = {{0,
                   2,
                   layer.frame.height_nm,
                   {Line(Feature::kExternalPerimeter, "(10 10, 30 10, 30 30, 10 30)", true),
                    Line(Feature::kInternalInfill, "(12 12, 28 28)")}}};
  layer.visits = {{0, 0, 0, {}}, {0, 1, 0, {FromMm(50), 0}}};
  return layer;
}

/// Settings of the extruder's words.
struct Asked {
  bool relative = true;
  bool volumetric = false;
  bool by_firmware = false;
  bool comments = false;
};

MotionOptions Options(const Asked& asked = {}) {
  MotionOptions options;
  options.tool().cooling.enabled = false;
  options.tool().retraction.length_mm = 0.8;
  options.writing.relative_e = asked.relative;
  options.writing.volumetric_e = asked.volumetric;
  options.writing.firmware_retraction = asked.by_firmware;
  options.writing.comments = asked.comments;
  options.layer_gcode = "M117 layer";
  return options;
}

std::string Gcode(const MotionOptions& options, const OrderedLayer& layer = Squares()) {
  const auto code = LayerCode::Of(options);
  EXPECT_TRUE(code.ok()) << code.status();
  auto programs = ProgramLayer(layer, {}, options, *code);
  EXPECT_TRUE(programs.ok()) << programs.status();
  return programs->front().gcode;
}

/// A line without its E word and its comment, and the amount that it pushes in its own units.
struct Push {
  std::string line;
  double amount = 0;
};

std::vector<Push> Pushes(const std::string& gcode, bool relative) {
  std::vector<Push> pushes;
  double at = 0;
  std::istringstream lines(gcode);
  for (std::string line; std::getline(lines, line);) {
    if (line == "G92 E0") {
      at = 0;
      continue;
    }
    line = line.substr(0, line.find(" ;"));
    Push push;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word[0] != 'E' || line[0] != 'G') {
        push.line += word + " ";
        continue;
      }
      const double number = std::stod(word.substr(1));
      push.amount = relative ? number : number - at;
      at = number;
    }
    pushes.push_back(push);
  }
  EXPECT_TRUE(relative || at == 0) << "the layer does not end at 0";
  return pushes;
}

void ExpectSame(const std::vector<Push>& got, const std::vector<Push>& want, double factor) {
  ASSERT_EQ(got.size(), want.size());
  for (size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].line, want[i].line);
    EXPECT_NEAR(got[i].amount, want[i].amount * factor, 1.01e-5) << got[i].line;
  }
}

TEST(LayerWords, PushTheSameHoweverTheyAreCounted) {
  const std::vector<Push> want = Pushes(Gcode(Options()), true);
  const double area_mm2 = std::numbers::pi / 4 * 1.75 * 1.75;
  ExpectSame(Pushes(Gcode(Options({.relative = false})), false), want, 1);
  ExpectSame(Pushes(Gcode(Options({.volumetric = true})), true), want, area_mm2);
  ExpectSame(Pushes(Gcode(Options({.relative = false, .volumetric = true})), false), want,
             area_mm2);
  ExpectSame(Pushes(Gcode(Options({.comments = true})), true), want, 1);
}

TEST(LayerWords, TheExtruderIsAtZeroWhereGcodeOfOthersStands) {
  const std::string gcode = Gcode(Options({.relative = false}));
  const std::string before = gcode.substr(0, gcode.find("M117 layer"));
  EXPECT_THAT(before, Not(HasSubstr(" E")));
  // A new count begins after each retraction.
  size_t resets = 0;
  for (size_t at = gcode.find("G92 E0\n"); at != std::string::npos;
       at = gcode.find("G92 E0\n", at + 1))
    ++resets;
  EXPECT_GE(resets, 2u);
}

TEST(LayerWords, LayersThatMeetReadyBeginAtZeroToo) {
  OrderedLayer layer = Squares();
  layer.visits.resize(1);
  layer.begins_ready = layer.ends_ready = true;
  const std::string gcode = Gcode(Options({.relative = false}), layer);
  EXPECT_TRUE(gcode.ends_with("G92 E0\n")) << gcode;
  ExpectSame(Pushes(gcode, false), Pushes(Gcode(Options(), layer), true), 1);
}

TEST(LayerWords, FirmwareRetractsWithoutNumbers) {
  for (const bool relative : {true, false}) {
    const std::string gcode = Gcode(Options({.relative = relative, .by_firmware = true}));
    std::istringstream lines(gcode);
    bool retracted = true;
    int retractions = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line == "G10") ++retractions;
      if (line == "G10" || line == "G11") {
        EXPECT_EQ(retracted, line == "G11");
        retracted = line == "G10";
      }
      const bool pushes = line.starts_with("G1 ") && line.find(" E") != std::string::npos;
      EXPECT_FALSE(pushes && retracted) << line;
      EXPECT_FALSE(pushes && line.find_first_of("XY") == std::string::npos) << line;
    }
    EXPECT_TRUE(retracted);
    EXPECT_GE(retractions, 2);
  }
}

TEST(LayerWords, CommentsSayWhatMovesAreFor) {
  const std::string gcode = Gcode(Options({.comments = true}));
  for (const char* words : {" ; perimeter\n", " ; infill\n", " ; move to first perimeter point\n",
                            " ; retract\n", " ; unretract\n"})
    EXPECT_THAT(gcode, HasSubstr(words));
  std::istringstream lines(gcode);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("G1 ")) {
      EXPECT_THAT(line, HasSubstr(" ; "));
    }
  }
}

TEST(LayerWords, AChangeOfColourStandsAfterLayerGcodeAndPrimes) {
  MotionOptions options = Options();
  options.writing.color_change_gcode = "M600";
  options.writing.height_code = R"([{"z":0.6,"type":"color_change","text":"#FF0000"}])";
  const std::string gcode = Gcode(options);
  EXPECT_THAT(gcode, HasSubstr("M117 layer\n;COLOR_CHANGE,T0,#FF0000\nM600\n"));
  const std::vector<Push> plain = Pushes(Gcode(Options()), true);
  const std::vector<Push> changed = Pushes(gcode, true);
  double difference = 0;
  for (const Push& push : plain) difference += push.amount;
  for (const Push& push : changed) difference -= push.amount;
  EXPECT_NEAR(difference, 0.8, 1e-9) << "the first restart is left out, and no other";

  options.writing.height_code = R"([{"z":0.6,"type":"pause"}])";
  options.writing.pause_gcode = "M601";
  EXPECT_THAT(Gcode(options), HasSubstr("M117 layer\n;PAUSE_PRINT\nM601\n"));

  options.writing.height_code = R"([{"z":0.7,"type":"pause"}])";
  EXPECT_EQ(Gcode(options), Gcode(Options()));
}

}  // namespace
}  // namespace slicefarm::motion::layer_words_test
