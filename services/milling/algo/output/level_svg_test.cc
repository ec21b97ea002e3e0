#include "services/milling/algo/output/level_svg.h"

#include <gtest/gtest.h>

#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::level_svg_test {
namespace {

size_t CountOf(const std::string& text, std::string_view what) {
  size_t count = 0;
  for (size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(LevelSvg, DrawsStockAreasAndPasses) {
  const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor("cyl:1.5"));
  const std::vector<MilledStep> steps = AllSteps(job);
  ASSERT_FALSE(steps.empty());
  for (const MilledStep& level : steps) {
    const std::string svg = LevelSvg(job, level);
    size_t passes = 0;
    for (const CutArea& area : level.areas) passes += area.passes.size();
    EXPECT_EQ(CountOf(svg, "<path fill=\"none\""), passes);
    EXPECT_EQ(CountOf(svg, "<path fill=\"#bfd\""), level.areas.size());
    EXPECT_EQ(CountOf(svg, "<rect"), 1u);
    EXPECT_EQ(svg.find("nan"), svg.npos);
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  }
}

}  // namespace
}  // namespace slicefarm::milling::level_svg_test
