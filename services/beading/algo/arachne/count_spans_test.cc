#include "services/beading/algo/arachne/count_spans.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::beading::count_spans_test {
namespace {

struct CountSpan {
  int count = 0;
  double length_mm = 0;
  double thickness_mm = 0;
};

/// Returns the merged counts of spans along a line, two edges each. Beads are 0.4 mm wide. The
/// filter allows a deviation of 0.1 mm, and 0.3 mm if a span is too short. `in_neck`: at both
/// ends the part thickens so steeply that the edges have no count.
std::vector<int> Merged(const std::vector<CountSpan>& spans, bool in_neck) {
  SkeletalGraph graph;
  std::vector<int> counts;
  double x = 0;
  const auto add_node = [&](double radius) { graph.nodes.push_back({{x, 0}, radius}); };
  constexpr double kThickNm = 3e6, kSteepNm = 300'000;
  if (in_neck) {
    add_node(kThickNm);
    counts.push_back(-1);
    x += kSteepNm;
  }
  add_node(spans.front().thickness_mm * 0.5e6);
  for (const CountSpan& span : spans) {
    for (int edge = 0; edge < 2; ++edge) {
      x += span.length_mm * 0.5e6;
      add_node(span.thickness_mm * 0.5e6);
      counts.push_back(span.count);
    }
  }
  if (in_neck) {
    x += kSteepNm;
    add_node(kThickNm);
    counts.push_back(-1);
  }
  // The half-edges with even index lead along the line, the ones with odd index lead back.
  const int last = static_cast<int>(2 * counts.size()) - 2;
  for (int half = 0; half <= last + 1; ++half) {
    HalfEdge edge;
    edge.from = half % 2 == 0 ? half / 2 : half / 2 + 1;
    edge.next = half % 2 == 0 ? (half == last ? half + 1 : half + 2) : (half == 1 ? 0 : half - 2);
    edge.previous =
        half % 2 == 0 ? (half == 0 ? 1 : half - 2) : (half == last + 1 ? last : half + 2);
    graph.half_edges.push_back(edge);
  }
  StrategyOptions options;
  options.max_walls = 3;
  const std::vector<int> merged = MergedCounts(*MakeStrategy(options), {}, graph, counts);
  std::vector<int> by_span;
  const size_t first = in_neck ? 1 : 0;
  for (size_t i = first; i + first < merged.size(); i += 2) by_span.push_back(merged[i]);
  return by_span;
}

struct MergeCase {
  std::string name;
  std::vector<CountSpan> spans;
  std::vector<int> counts;
  bool in_neck = false;
};
class Merging : public testing::TestWithParam<MergeCase> {};

TEST_P(Merging, TakesStretchesIntoThoseBesideThem) {
  EXPECT_EQ(Merged(GetParam().spans, GetParam().in_neck), GetParam().counts);
}

// Two beads replace one from 0.68 mm on, four replace three from 1.48 mm, five replace four from
// 1.94 mm, and six replace five from 2.28 mm.
INSTANTIATE_TEST_SUITE_P(
    MergeCounts, Merging,
    testing::Values(
        MergeCase{"AllStay", {{6, 5, 2.4}, {4, 5, 1.6}}, {6, 4}},
        MergeCase{"ASlightNeckGoes", {{6, 5, 2.4}, {5, 5, 2.3}, {6, 5, 2.4}}, {6, 6, 6}},
        MergeCase{"ALongNeckStays", {{6, 5, 2.4}, {5, 2, 2.0}, {6, 5, 2.4}}, {6, 5, 6}},
        MergeCase{"AShortNeckGoes", {{6, 5, 2.4}, {5, 1, 2.0}, {6, 5, 2.4}}, {6, 6, 6}},
        MergeCase{"AShortMiddleBetweenUnlikeStays",
                  {{6, 5, 2.4}, {5, 1.4, 2.05}, {4, 5, 1.6}},
                  {6, 5, 4}},
        MergeCase{
            "AShortNeckWithoutAMiddleStays", {{6, 5, 2.4}, {4, 1, 1.6}, {6, 5, 2.4}}, {6, 4, 6}},
        MergeCase{"AloneAndNearerToFour", {{5, 1, 1.96}}, {4}},
        MergeCase{"AloneAndNearerToSix", {{5, 1, 2.3}}, {6}},
        MergeCase{"AloneAndLong", {{5, 2, 1.96}}, {5}},
        MergeCase{"ALoneBeadInAShortNeckIsSplit", {{1, 0.8, 0.6}}, {2}, true},
        MergeCase{"NotInALongOne", {{1, 1.1, 0.6}}, {1}, true},
        MergeCase{"NotInOneTooThinForTwo", {{1, 0.8, 0.4}}, {1}, true},
        MergeCase{"NotInAPlaceOfItsOwn", {{1, 0.8, 0.6}}, {1}},
        MergeCase{"TheMiddleOfThreeInAShortNeckIsSplit", {{3, 0.8, 1.4}}, {4}, true},
        MergeCase{"TheOutermostKeepTheirWidthInANeck", {{3, 0.8, 1.2}}, {3}, true},
        MergeCase{"TheOutermostKeepTheirWidth", {{3, 1, 1.2}}, {3}},
        MergeCase{"InfillIsNoBead", {{7, 1, 2.82}}, {7}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::beading::count_spans_test
