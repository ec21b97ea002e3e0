#include "services/infill/algo/ironing.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/inside_checks_test.h"

namespace slicefarm::infill::ironing_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

TEST(IronedLines, GiveTheFlowThatIsAskedFor) {
  const MultiPolygon region = P("(0 0, 30 0, 30 20, 0 20) (10 5, 10 15, 20 15, 20 5)");
  for (const double flow : {0.1, 0.15, 0.5}) {
    for (const double spacing_mm : {0.1, 0.25}) {
      IroningFill fill{.angle_rad = 0.3, .ironing = {.enabled = true, .flow = flow}};
      fill.ironing.spacing_nm = FromMm(spacing_mm);
      const auto group = IronedLines(region, fill);
      ASSERT_TRUE(group.ok());
      double volume = 0;
      for (const Path& path : group->paths) {
        EXPECT_EQ(path.feature, Feature::kIroning);
        EXPECT_FALSE(path.reversible);
        volume += ToMm(PathLength(path)) * SectionMm2(path.WidthAt(0), fill.height_nm);
      }
      const double asked =
          flow * Area(Offset(region, -fill.ironing.spacing_nm / 2)) * 1e-12 * ToMm(200'000.0);
      EXPECT_NEAR(volume / asked, 1, 0.03) << flow << " " << spacing_mm;
    }
  }
}

TEST(IronedLines, KeepTheirOrderAndStayInside) {
  const MultiPolygon region = P("(0 0, 20 0, 20 10, 13 4, 9 10, 0 10) ; (30 0, 40 3, 31 9)");
  const auto group = IronedLines(region, {.angle_rad = 1, .ironing = {.spacing_nm = 100'000}});
  ASSERT_TRUE(group.ok());
  EXPECT_TRUE(group->keep_order);
  EXPECT_GE(group->paths.size(), 2);
  ExpectInside(group->paths, Offset(region, -50'000));
}

TEST(IronedLines, NothingIsLeftOfWhatIsNarrow) {
  EXPECT_TRUE(IronedLines(P("(0 0, 20 0, 20 0.09, 0 0.09)"), {.ironing = {.spacing_nm = 100'000}})
                  ->paths.empty());
  EXPECT_TRUE(IronedLines({}, {})->paths.empty());
}

TEST(IronedLines, TooManyLinesAreRefused) {
  IroningFill fill;
  fill.ironing.spacing_nm = 1'000;
  const auto group = IronedLines(P("(0 0, 2000 0, 2000 2000, 0 2000)"), fill);
  EXPECT_EQ(DetailOf(group.status()).reason, Reason::kRequestTooLarge);
}

TEST(IronedLines, LoopsGiveTheSameFlow) {
  const MultiPolygon region = P("(0 0, 30 0, 30 20, 0 20) (10 5, 10 15, 20 15, 20 5)");
  IroningFill fill{.ironing = {.enabled = true, .flow = 0.15, .concentric = true}};
  const auto group = IronedLines(region, fill);
  ASSERT_TRUE(group.ok());
  EXPECT_TRUE(group->keep_order);
  double volume = 0;
  for (const Path& path : group->paths) {
    EXPECT_EQ(path.feature, Feature::kIroning);
    EXPECT_TRUE(path.closed);
    volume += ToMm(PathLength(path)) * SectionMm2(path.WidthAt(0), fill.height_nm);
  }
  EXPECT_NEAR(volume / (0.15 * Area(region) * 1e-12 * 0.2), 1, 0.03);
  ExpectInside(group->paths, Offset(region, -49'000));
  fill.ironing.spacing_nm = 1'000;
  EXPECT_EQ(DetailOf(IronedLines(P("(0 0, 2000 0, 2000 2000, 0 2000)"), fill).status()).reason,
            Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::infill::ironing_test
