#include "services/planning/algo/seams/seam_candidates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "services/planning/algo/layers_test.h"
#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::seam_candidates_test {
namespace {

ObjectSection SectionOf(MultiPolygon outlines, int32_t layer = 0) {
  ObjectSection section = SectionOrDie(0, layer, "");
  section.regions = {{Role::kPart, 0, 0, std::move(outlines)}};
  return section;
}

bool HasPlaceAt(const RingCandidates& ring, Point at) {
  return std::ranges::any_of(ring.candidates, [&](const SeamCandidate& candidate) {
    return Distance(candidate.at, at) < 1000;
  });
}

TEST(SeamCandidate, TellsCorners) {
  EXPECT_TRUE(IsCorner({.at = {}, .turn_rad = -0.3F}));
  EXPECT_FALSE(IsCorner({.at = {}, .turn_rad = 0.3F}));
  EXPECT_TRUE(IsCorner({.at = {}, .turn_rad = 0.6F}));
}

TEST(SeamCandidateFinder, TakesCornersAndFillsUp) {
  SeamCandidateFinder finder;
  const auto rings = finder.Next(SectionOrDie(0, 0, "(0 0, 20 0, 20 10, 0 10)"));
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].below, -1);
  for (const Point corner : {Mm(0, 0), Mm(20, 0), Mm(20, 10), Mm(0, 10)})
    EXPECT_TRUE(HasPlaceAt(rings[0], corner));
  const auto& candidates = rings[0].candidates;
  EXPECT_GT(candidates.size(), 20u);
  for (size_t i = 0; i + 1 < candidates.size(); ++i)
    EXPECT_LE(Distance(candidates[i].at, candidates[i + 1].at), FromMm(3));
}

TEST(SeamCandidateFinder, PlacesOfARoundWallStandOverEachOther) {
  SeamCandidateFinder finder;
  auto below = finder.Next(SectionOf({{CircleRing({}, 10, 100), {}}}));
  for (int layer = 1; layer < 20; ++layer) {
    // The facets rotate from layer to layer. The places must not follow them.
    auto here = finder.Next(SectionOf({{CircleRing({}, 10, 100, 0.013 * layer), {}}}, layer));
    EXPECT_EQ(here[0].below, 0);
    size_t upright = 0;
    for (const SeamCandidate& candidate : below[0].candidates)
      for (const SeamCandidate& above : here[0].candidates)
        upright += Distance(candidate.at, above.at) < 20'000 ? 1 : 0;
    EXPECT_GT(upright, below[0].candidates.size() * 9 / 10);
    below = std::move(here);
  }
}

TEST(SeamCandidateFinder, LinesCanStayOnEitherEndOfABevel) {
  // The sharper end alternates between the two corners.
  SeamCandidateFinder finder;
  finder.Next(SectionOrDie(0, 0, "(0 0, 19.84 0, 20 0.13, 20 10, 0 10)"));
  const auto rings = finder.Next(SectionOrDie(0, 1, "(0 0, 19.88 0, 20 0.17, 20 10, 0 10)"));
  const auto again = finder.Next(SectionOrDie(0, 2, "(0 0, 19.84 0, 20 0.13, 20 10, 0 10)"));
  int near = 0, near_again = 0;
  for (const SeamCandidate& candidate : rings[0].candidates)
    near += Distance(candidate.at, Mm(20, 0)) < 3e5;
  for (const SeamCandidate& candidate : again[0].candidates)
    near_again += Distance(candidate.at, Mm(20, 0)) < 3e5;
  EXPECT_EQ(near, 2);
  EXPECT_EQ(near_again, 2);
}

TEST(SeamCandidateFinder, LinksRingsThroughSplitsAndMerges) {
  SeamCandidateFinder finder;
  const std::string_view one = "(0 0, 30 0, 30 10, 0 10)";
  const std::string_view two = "(0 0, 14 0, 14 10, 0 10) ; (16 0, 30 0, 30 10, 16 10)";
  finder.Next(SectionOrDie(0, 0, one));
  const auto split = finder.Next(SectionOrDie(0, 1, two));
  EXPECT_EQ(split[0].below, 0);
  EXPECT_EQ(split[1].below, 0);
  const auto merged =
      finder.Next(SectionOrDie(0, 2, "(0 0, 18 0, 18 10, 0 10) ; (90 0, 95 0, 95 5)"));
  EXPECT_EQ(merged[0].below, 0) << "most of it goes on from the left one";
  EXPECT_EQ(merged[1].below, -1);
}

TEST(SeamCandidateFinder, ARingOfAHoleFollowsTheHole) {
  SeamCandidateFinder finder;
  const std::string_view tube = "(0 0, 10 0, 10 10, 0 10) (1 1, 1 9, 9 9, 9 1)";
  finder.Next(SectionOrDie(0, 0, tube));
  const auto rings = finder.Next(SectionOrDie(0, 1, tube));
  EXPECT_EQ(rings[0].below, 0);
  EXPECT_EQ(rings[1].below, 1);
}

TEST(SeamCandidateFinder, MeasuresOverhangsInHeightsOfTheLayer) {
  SeamCandidateFinder finder;
  finder.Next(SectionOrDie(0, 0, "(0 0, 30 0, 30 30, 0 30)"));
  const auto rings =
      finder.Next(SectionOrDie(0, 1, "(0 0, 30.3 0, 30.3 30, 0 30) ; (12 70, 15 70, 15 75)"));
  ASSERT_EQ(rings.size(), 2u);
  ASSERT_FALSE(rings[0].candidates.empty());
  ASSERT_FALSE(rings[1].candidates.empty());
  for (const SeamCandidate& candidate : rings[0].candidates)
    EXPECT_NEAR(candidate.overhang, candidate.at.x > FromMm(30) ? 1.5 : 0, 1e-6);
  for (const SeamCandidate& candidate : rings[1].candidates)
    EXPECT_EQ(candidate.overhang, 10) << "2 mm: the end of what is looked at";
  const auto top = finder.Next(SectionOrDie(0, 2, "(12 12, 18 12, 18 18, 12 18)"));
  ASSERT_EQ(top.size(), 1u);
  ASSERT_FALSE(top[0].candidates.empty());
  for (const SeamCandidate& candidate : top[0].candidates)
    EXPECT_EQ(candidate.overhang, 0) << "far inside";
}

TEST(SeamCandidateFinder, PaintedPartsHaveMorePlaces) {
  ObjectSection section = SectionOrDie(0, 0, "(0 0, 20 0, 20 20, 0 20)");
  section.marks = {
      {PartRole::kSeamEnforcer, MakePolygonsOrDie("(9.8 19, 10.2 19, 10.2 21, 9.8 21)")},
      {PartRole::kSeamBlocker, MakePolygonsOrDie("(-1 -1, 1 -1, 1 21, -1 21)")}};
  const auto rings = SeamCandidateFinder().Next(section);
  int enforced = 0;
  for (const SeamCandidate& candidate : rings[0].candidates) {
    enforced += candidate.enforced ? 1 : 0;
    EXPECT_EQ(candidate.blocked, candidate.at.x <= FromMm(1));
  }
  EXPECT_GE(enforced, 1);
}

/// The ring has two runs, one of them across the ring's first place. Then the whole ring is
/// enforced.
TEST(SeamCandidateFinder, EnforcedPlacesKnowTheMiddleOfTheirRun) {
  ObjectSection section = SectionOrDie(0, 0, "(0 0, 20 0, 20 20, 0 20)");
  section.marks = {
      {PartRole::kSeamEnforcer,
       MakePolygonsOrDie("(-1 -1, 3 -1, 3 1, 1 1, 1 3, -1 3) ; (8 19, 14 19, 14 21, 8 21)")}};
  const auto rings = SeamCandidateFinder().Next(section);
  ASSERT_EQ(rings.size(), 1u);
  int enforced = 0;
  for (const SeamCandidate& candidate : rings[0].candidates) {
    enforced += candidate.enforced ? 1 : 0;
    if (!candidate.enforced) {
      EXPECT_EQ(candidate.off_middle_mm, 0);
    } else if (candidate.at.y > FromMm(19)) {
      EXPECT_NEAR(candidate.off_middle_mm, std::abs(ToMm(candidate.at.x) - 11), 0.3);
    } else {
      EXPECT_NEAR(candidate.off_middle_mm, ToMm(candidate.at.x + candidate.at.y), 0.3);
    }
  }
  EXPECT_GT(enforced, 0);
  section.marks = {{PartRole::kSeamEnforcer, MakePolygonsOrDie("(-1 -1, 21 -1, 21 21, -1 21)")}};
  const auto all_around = SeamCandidateFinder().Next(section);
  ASSERT_EQ(all_around.size(), 1u);
  ASSERT_FALSE(all_around[0].candidates.empty());
  for (const SeamCandidate& candidate : all_around[0].candidates)
    EXPECT_EQ(candidate.off_middle_mm, 0);
}

TEST(SeamCandidateFinder, SmallRingsHaveAFewAndLargeOnesNotTooMany) {
  const auto small = SeamCandidateFinder().Next(SectionOrDie(0, 0, "(0 0, 0.4 0, 0.4 0.4)"));
  EXPECT_GE(small[0].candidates.size(), 3u);
  const auto large =
      SeamCandidateFinder().Next(SectionOrDie(0, 0, "(0 0, 1000 0, 1000 900, 0 900)"));
  EXPECT_LE(large[0].candidates.size(), 200u);
}

TEST(SeamCandidateFinder, DustAndNothingAreFine) {
  MultiPolygon dust;
  for (int i = 0; i < 6000; ++i) {
    const Point at = Mm(i % 80, i / 80);
    dust.push_back({{at, at + Mm(0.5, 0), at + Mm(0.5, 0.5)}, {}});
  }
  SeamCandidateFinder finder;
  EXPECT_EQ(finder.Next(SectionOf(dust)).size(), 6000u);
  const auto again = finder.Next(SectionOf(dust, 1));
  for (size_t i = 0; i < again.size(); ++i) EXPECT_EQ(again[i].below, static_cast<int32_t>(i));
  EXPECT_TRUE(finder.Next(SectionOrDie(0, 2, "")).empty());
  EXPECT_EQ(finder.Next(SectionOrDie(0, 3, "(0 0, 9 0, 9 9)"))[0].below, -1);
}

}  // namespace
}  // namespace slicefarm::planning::seam_candidates_test
