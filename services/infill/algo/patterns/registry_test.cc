#include "services/infill/algo/patterns/registry.h"

#include <gtest/gtest.h>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::registry_test {
namespace {

TEST(Registry, EveryPatternIsMade) {
  const MultiPolygon box = SampleBox();
  const std::vector<Polyline> planned = {{{-kNmPerMm, 0}, {kNmPerMm, 0}}};
  for (const FillPatternInfo& info : kFillPatterns) {
    MakePattern* const make = PatternOf(info.pattern);
    ASSERT_NE(make, nullptr) << info.name;
    const auto pieces =
        make(box, {.z_nm = 300'000,
                   .pitch_nm = 3e6,
                   .spacing_nm = 400'000,
                   .planned = info.planned ? planned : std::span<const Polyline>{}});
    ASSERT_TRUE(pieces.ok()) << info.name;
    EXPECT_FALSE(pieces->empty()) << info.name;
    EXPECT_TRUE(make({}, {.pitch_nm = 3e6, .spacing_nm = 400'000})->empty()) << info.name;
  }
}

}  // namespace
}  // namespace slicefarm::infill::registry_test
