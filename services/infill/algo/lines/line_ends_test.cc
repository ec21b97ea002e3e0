#include "services/infill/algo/lines/line_ends.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::line_ends_test {
namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

/// Returns the ends on one line of CutLines.
std::vector<double> EndsOn(const ScanLines& lines, int32_t line) {
  std::vector<double> ends;
  for (int32_t place = lines.line_begin[line]; place < lines.line_begin[line + 1]; ++place)
    ends.push_back(lines.crossings[lines.order[place]].u);
  return ends;
}

/// Tests that LineEnds has the lines and the ends of CutLines.
void ExpectEndsOfScanLines(const MultiPolygon& region, const LineFamily& family) {
  const auto lines = CutLines(region, family);
  const auto ends = LineEnds::Of(region, family);
  ASSERT_TRUE(lines.ok() && ends.ok());
  ASSERT_GT(lines->LineCount(), 4);
  ASSERT_EQ(ends->last() - ends->first(), lines->LineCount());
  EXPECT_EQ(family.phase_nm + static_cast<double>(ends->first()) * family.pitch_nm, lines->first_v);
  for (int32_t line = 0; line < lines->LineCount(); ++line)
    EXPECT_THAT(ends->On(ends->first() + line), ElementsAreArray(EndsOn(*lines, line))) << line;
}

TEST(LineEnds, AreThoseOfScanLines) {
  for (const std::string text :
       {"(0 0, 10 0, 10 10, 0 10) (3 3, 7 3, 7 7, 3 7)",
        "(0 0, 4 0, 4 2, 6 2, 6 1, 8 1, 8 4, 5 6, 2 4, 0 4) (1 1, 3 1, 2 3)",
        "(-7 -1, 7 1, 9 6, 3 8) ; (20 0, 21 0, 20 3)"}) {
    for (const double angle : {0.0, std::numbers::pi / 2, std::numbers::pi / 4, 0.3, -1.1}) {
      for (const double phase_nm : {0.0, 1.7e5, -3e6}) {
        SCOPED_TRACE(text + " " + std::to_string(angle));
        ExpectEndsOfScanLines(MakePolygonsOrDie(text), {angle, phase_nm, 0.5e6});
      }
    }
  }
}

TEST(LineEnds, AreNoneBesideTheRegion) {
  const auto ends = LineEnds::Of(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)"),
                                 {.phase_nm = 5e5, .pitch_nm = 1e6});
  ASSERT_TRUE(ends.ok());
  EXPECT_EQ(ends->first(), 0);
  EXPECT_EQ(ends->last(), 10);
  EXPECT_THAT(ends->On(-1), IsEmpty());
  EXPECT_THAT(ends->On(10), IsEmpty());
  const auto none = LineEnds::Of({}, {.pitch_nm = 1e6});
  ASSERT_TRUE(none.ok());
  EXPECT_EQ(none->first(), none->last());
}

TEST(LineEnds, RefuseTooManyLines) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 1000 0, 1000 1000, 0 1000)");
  const absl::Status status = LineEnds::Of(square, {.pitch_nm = 1e3}).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(status).metadata.at("got"), "1000000");
}

}  // namespace
}  // namespace slicefarm::infill::line_ends_test
