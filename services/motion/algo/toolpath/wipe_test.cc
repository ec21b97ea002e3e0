#include "services/motion/algo/toolpath/wipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/options/motion_options.h"
#include "common/model/options/tool_row.h"
#include "common/model/paths_test.h"

namespace slicefarm::motion::wipe_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Path Loop(std::string_view points) {
  Path path = MakePathOrDie(points);
  path.closed = true;
  return path;
}

MotionOptions Wiping() {
  MotionOptions options;
  options.travel_speed_mm_s = 150;
  options.tool().retraction = {.length_mm = 0.7, .speed_mm_s = 35, .wipe = true};
  return options;
}

TEST(WipeOf, TakesAsLongAsTheRetractionAlone) {
  const Wipe wipe = WipeOf(Wiping());
  EXPECT_DOUBLE_EQ(wipe.speed_mm_s, 120);
  EXPECT_DOUBLE_EQ(wipe.length_mm, 2.4);
}

TEST(WipeOf, IsShorterByWhatIsPulledBackBefore) {
  MotionOptions options = Wiping();
  options.tool().retraction.before_wipe = 0.75;
  EXPECT_DOUBLE_EQ(WipeOf(options).length_mm, 0.6);
}

TEST(WipeOf, HasTheLengthAndTheSpeedOfTheSettings) {
  MotionOptions options = Wiping();
  options.tool().retraction.wipe_distance_mm = 2;
  options.tool().retraction.before_wipe = 1;
  options.wipe_speed_ratio = 0.5;
  EXPECT_DOUBLE_EQ(WipeOf(options).length_mm, 2) << "though nothing is left to retract";
  EXPECT_DOUBLE_EQ(WipeOf(options).speed_mm_s, 75);
}

TEST(WipeOf, NoneWithoutTheSettingOrARetraction) {
  for (const auto& spoil : {+[](RetractionOptions& r) { r.wipe = false; },
                            +[](RetractionOptions& r) { r.length_mm = 0; },
                            +[](RetractionOptions& r) { r.before_wipe = 1; }}) {
    MotionOptions options = Wiping();
    spoil(options.tool().retraction);
    EXPECT_EQ(WipeOf(options).length_mm, 0);
  }
}

struct TravelCase {
  std::string name;
  Path path;
  double length_mm;
  std::vector<PointUm> expected;
};

TEST(WipePath, Cases) {
  const std::vector<TravelCase> cases = {
      {"OnAlongALoop", Loop("(0 0, 10 0, 10 10, 0 10)"), 2, {{2'000, 0}}},
      {"RoundTheCorner", Loop("(0 0, 1 0, 1 9, 0 9)"), 2.5, {{1'000, 0}, {1'000, 1'500}}},
      {"NotLongerThanTheLoop", Loop("(0 0, 1 0, 0 1)"), 99, {{1'000, 0}, {0, 1'000}, {0, 0}}},
      {"BackAlongALine", MakePathOrDie("(0 0, 10 0)"), 2, {{8'000, 0}}},
      {"NotLongerThanTheLine", MakePathOrDie("(9 0, 10 0)"), 2, {{9'000, 0}}},
      {"ShortEdgesAreCutAcross",
       MakePathOrDie("(0 0, 9.85 0, 10 0.1, 10 0.2)"),
       2,
       {{9'850, 0}, {8'100, 0}}},
      {"ShortRestsAreLeftOut", MakePathOrDie("(0 0, 9 0, 10 0)"), 1.1, {{9'000, 0}}},
  };
  for (const TravelCase& c : cases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(WipePath(c.path, c.length_mm), c.expected);
  }
}

TEST(WipePath, IsShiftedToTheLeft) {
  const Path loop = Loop("(0 0, 10 0, 10 10, 0 10)");
  EXPECT_THAT(WipePath(loop, 2, 200'000), ElementsAre(PointUm{0, 200}, PointUm{2'000, 200}));
  EXPECT_THAT(WipePath(loop, 2, -200'000), ElementsAre(PointUm{0, -200}, PointUm{2'000, -200}));
  EXPECT_THAT(WipePath(MakePathOrDie("(0 0, 0.1 0)"), 2, 200'000), IsEmpty());
}

TEST(WipePath, OfADotThereIsNone) {
  EXPECT_THAT(WipePath(MakePathOrDie("(0 0, 0.1 0)"), 2), IsEmpty());
}

}  // namespace
}  // namespace slicefarm::motion::wipe_test
