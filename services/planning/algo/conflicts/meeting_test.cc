#include "services/planning/algo/conflicts/meeting.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::planning::meeting_test {
namespace {

constexpr const char* kSquare = "(0 0, 10 0, 10 10, 0 10)";

TEST(MeetingOf, TakesMoreThanATouch) {
  struct Case {
    const char* name;
    const char* other;
    bool meets;
  };
  const Case cases[] = {
      {"Apart", "(11 0, 20 0, 20 10, 11 10)", false},
      {"Touching", "(10 0, 20 0, 20 10, 10 10)", false},
      {"AsDrawingsAreOff", "(9.95 0, 20 0, 20 10, 9.95 10)", false},
      {"HalfALineIn", "(9.8 0, 20 0, 20 10, 9.8 10)", true},
      {"Inside", "(4 4, 6 4, 6 6, 4 6)", true},
      {"TheSame", kSquare, true},
  };
  for (const Case& c : cases)
    EXPECT_EQ(MeetingOf(MakePolygonsOrDie(kSquare), MakePolygonsOrDie(c.other)).has_value(),
              c.meets)
        << c.name;
}

TEST(ConflictError, NamesBothAndThePlace) {
  const ErrorDetail detail =
      DetailOf(ConflictError("cup", "the supports of lid", {FromMm(3), FromMm(4.5)}, FromMm(0.6)));
  EXPECT_EQ(detail.reason, Reason::kPathsConflict);
  EXPECT_EQ(detail.metadata.at("first"), "cup");
  EXPECT_EQ(detail.metadata.at("second"), "the supports of lid");
  EXPECT_EQ(detail.metadata.at("x_mm"), "3.00");
  EXPECT_EQ(detail.metadata.at("y_mm"), "4.50");
  EXPECT_EQ(detail.metadata.at("z_mm"), "0.60");
}

}  // namespace
}  // namespace slicefarm::planning::meeting_test
