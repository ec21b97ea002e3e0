#include "services/motion/algo/gcode/extruder_words.h"

#include <gtest/gtest.h>

#include <string>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion::extruder_words_test {
namespace {

MotionOptions Options(bool relative, bool volumetric, bool by_firmware = false) {
  MotionOptions options;
  options.tool().filament_diameter_mm = 1.75;
  options.tool().retraction.length_mm = 0.8;
  options.tool().retraction.speed_mm_s = 35;
  options.writing.relative_e = relative;
  options.writing.volumetric_e = volumetric;
  options.writing.firmware_retraction = by_firmware;
  return options;
}

std::string Pushes(const MotionOptions& options) {
  ExtruderWords extruder(options);
  GcodeText out;
  for (const int32_t filament : {150'000, 50'001, -80'000}) extruder.Push(filament, out);
  out << '\n';
  extruder.Reset(out);
  extruder.Push(100'000, out);
  return out.Take();
}

TEST(ExtruderWords, CountAsTheyAreAsked) {
  EXPECT_EQ(Pushes(Options(true, false)), " E1.5 E.50001 E-.8\n E1");
  EXPECT_EQ(Pushes(Options(false, false)), " E1.5 E2.00001 E1.20001\nG92 E0\n E1");
  // The volumes are the lengths times 2.405281875 mm2.
  EXPECT_EQ(Pushes(Options(false, true)), " E3.60792 E4.81059 E2.88636\nG92 E0\n E2.40528");
  EXPECT_EQ(Pushes(Options(true, true)), " E3.60792 E1.20267 E-1.92423\n E2.40528");
}

TEST(ExtruderWords, RoundingDoesNotAddUp) {
  ExtruderWords extruder(Options(true, true));
  GcodeText out;
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    GcodeText word;
    extruder.Push(1'234, word);
    sum += std::stod(word.Take().substr(2));
  }
  EXPECT_NEAR(sum, 12.34 * 2.405281875, 1e-5);
}

TEST(ExtruderWords, NothingIsResetTwice) {
  ExtruderWords extruder(Options(false, false));
  GcodeText out;
  extruder.Reset(out);
  extruder.Push(5, out);
  extruder.Push(-5, out);
  extruder.Reset(out);
  EXPECT_EQ(out.Take(), " E.00005 E0");
}

TEST(ExtruderWords, TheHeadOfAProgramAgrees) {
  const auto head = [](const MotionOptions& options) {
    ExtruderWords extruder(options);
    GcodeText out;
    extruder.WriteCanonicalState(out);
    extruder.WriteFirstRetraction(options.tool().retraction, out);
    return out.Take();
  };
  EXPECT_EQ(head(Options(true, false)), "G21\nG90\nM83\nG1 E-.8 F2100\n");
  EXPECT_EQ(head(Options(false, false)), "G21\nG90\nM82\nG92 E0\nG1 E-.8 F2100\nG92 E0\n");
  EXPECT_EQ(head(Options(true, true)), "G21\nG90\nM83\nG1 E-1.92423 F2100\n");
  EXPECT_EQ(head(Options(true, false, true)), "G21\nG90\nM83\nG10\n");
  MotionOptions none = Options(true, false);
  none.tool().retraction.length_mm = 0;
  EXPECT_EQ(head(none), "G21\nG90\nM83\n");
}

}  // namespace
}  // namespace slicefarm::motion::extruder_words_test
