#include "services/exposure/algo/scan/inside.h"

#include <gtest/gtest.h>

#include <vector>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure::inside_test {
namespace {

TEST(InsideInset, HatchBeginsAtTheContourAndRingsBeforeTheirFirstLine) {
  ExposureOptions options;
  EXPECT_EQ(InsideInset(options), 120'000);
  EXPECT_EQ(HatchTrim(options), 40'000);
  options.hatch_offset_nm = 200'000;
  EXPECT_EQ(InsideInset(options), 120'000 + 160'000);
  EXPECT_EQ(HatchTrim(options), 40'000);
  options.contours = 0;
  EXPECT_EQ(InsideInset(options), 40'000);
  EXPECT_EQ(HatchTrim(options), 0);
  options = {};
  options.strategy = ScanStrategy::kRings;
  EXPECT_EQ(InsideInset(options), 200'000 - 30'000);
  EXPECT_EQ(HatchTrim(options), 0);
}

TEST(InsideInset, LinesAlongTheContourComeBeforeTheHatch) {
  const ExposureOptions options;
  EXPECT_EQ(BorderInsets(options, 0), std::vector<Coord>{});
  EXPECT_EQ(BorderInsets(options, 2), (std::vector<Coord>{200'000, 280'000}));
  EXPECT_EQ(InsideInset(options, 2), 280'000);
  EXPECT_EQ(NarrowDepth(options, 2), 320'000);
  EXPECT_EQ(LineLevels(options, 2).size(), 4u);
  EXPECT_EQ(LineLevels(options, 2).back().melted_nm, 240'000);
  EXPECT_EQ(LineLevels(options, 2).back().line_nm, 280'000);
}

TEST(NarrowDepth, WhereLinesBeginToFillTheInside) {
  ExposureOptions options;
  EXPECT_EQ(NarrowDepth(options), 160'000);
  options.strategy = ScanStrategy::kRings;
  EXPECT_EQ(NarrowDepth(options), 170'000);
  options.strategy = ScanStrategy::kHatch;
  options.contours = 0;
  EXPECT_EQ(NarrowDepth(options), 40'000);
  options.beam_compensation_nm = 0;
  EXPECT_EQ(NarrowDepth(options), 0);
}

TEST(LineLevels, FromTheOutlineInwards) {
  ExposureOptions options;
  const auto depths = [&] {
    std::vector<Coord> all;
    for (const LineLevel& level : LineLevels(options)) {
      all.push_back(level.melted_nm);
      all.push_back(level.line_nm);
    }
    return all;
  };
  EXPECT_EQ(depths(), (std::vector<Coord>{0, 40'000, 80'000, 120'000}));
  options.strategy = ScanStrategy::kRings;
  EXPECT_EQ(depths(), (std::vector<Coord>{0, 40'000, 80'000, 120'000, 160'000, 170'000}));
  options.contours = 0;
  options.beam_compensation_nm = 0;
  EXPECT_EQ(depths(), std::vector<Coord>{});
}

}  // namespace
}  // namespace slicefarm::exposure::inside_test
