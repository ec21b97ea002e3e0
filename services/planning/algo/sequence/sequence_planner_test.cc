#include "services/planning/algo/sequence/sequence_planner.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::sequence_planner_test {
namespace {

constexpr std::string_view kSquare = "(-5 -5, 5 -5, 5 5, -5 5)";

PlacedCopy CopyAt(int32_t object, double x_mm) {
  const auto corner = [x_mm](double x, double y) { return Point{FromMm(x_mm + x), FromMm(y)}; };
  return {object, corner(0, 0), {corner(-5, -5), corner(5, -5), corner(5, 5), corner(-5, 5)}};
}

/// Returns objects with the given numbers of layers of 0.2 mm.
std::vector<SlicedLayer> Towers(const std::vector<int32_t>& layer_counts) {
  std::vector<SlicedLayer> layers;
  for (int32_t i = 0; i < *std::ranges::max_element(layer_counts); ++i) {
    SlicedLayer& layer = layers.emplace_back();
    layer.frame = {i, (i + 1) * Coord{200'000}, 200'000};
    for (int32_t object = 0; object < std::ssize(layer_counts); ++object) {
      const bool there = i < layer_counts[static_cast<size_t>(object)];
      layer.sections.push_back(SectionOrDie(object, i, there ? kSquare : ""));
    }
  }
  return layers;
}

absl::StatusOr<std::vector<int32_t>> PassesOf(const std::vector<SlicedLayer>& layers,
                                              const std::vector<PlacedCopy>& copies,
                                              const SequencePlanOptions& options = {}) {
  const std::vector<std::string> names = {"cup", "lid"};
  SequencePlanner planner(options, copies, names);
  LayerPlan unused;
  for (const SlicedLayer& layer : layers) planner.Look(layer, unused);
  OpenLayers no_layers;
  JobPlan plan;
  for (const PlacedCopy& copy : copies) plan.copies.push_back({copy.object, copy.shift, 0});
  if (absl::Status status = planner.Finish({}, no_layers, plan); !status.ok()) return status;
  std::vector<int32_t> passes;
  for (const Copy& copy : plan.copies) passes.push_back(copy.pass);
  return passes;
}

using Passes = std::vector<int32_t>;

TEST(SequencePlanner, EachCopyHasAPassOfItsOwn) {
  const auto layers = Towers({10, 20});
  EXPECT_EQ(*PassesOf(layers, {CopyAt(0, 200), CopyAt(0, 0), CopyAt(1, 100)}), Passes({2, 0, 1}));
  EXPECT_EQ(*PassesOf(layers, {}), Passes({}));
}

TEST(SequencePlanner, HeightsAreThoseOfTheOutlines) {
  const auto layers = Towers({101, 100});
  EXPECT_EQ(*PassesOf(layers, {CopyAt(0, 0), CopyAt(1, 100)}), Passes({1, 0}));
  EXPECT_EQ(*PassesOf(layers, {CopyAt(0, 0), CopyAt(1, 100)}, {.clearance_height_nm = FromMm(21)}),
            Passes({0, 1}));
}

TEST(SequencePlanner, CopiesThatPrintNothingAreInNobodysWay) {
  const auto layers = Towers({10, 0});
  EXPECT_EQ(*PassesOf(layers, {CopyAt(0, 0), CopyAt(1, 1), CopyAt(0, 100)}), Passes({0, 0, 1}));
}

TEST(SequencePlanner, NamesTheCopiesThatCollide) {
  const auto layers = Towers({10, 10});
  const auto detail_of = [&](const std::vector<PlacedCopy>& copies) {
    return DetailOf(PassesOf(layers, copies).status());
  };
  ErrorDetail detail = detail_of({CopyAt(0, 0), CopyAt(0, 100), CopyAt(1, 115)});
  EXPECT_EQ(detail.reason, Reason::kObjectsCollide);
  EXPECT_EQ(detail.metadata["first"], "cup (copy 2)");
  EXPECT_EQ(detail.metadata["second"], "lid");
  detail = detail_of({CopyAt(0, 0), CopyAt(1, 20)});
  EXPECT_EQ(detail.metadata["first"], "cup");
}

TEST(SequencePlanner, RefusesMoreLayersThanAJobMayHave) {
  std::vector<PlacedCopy> copies;
  for (int i = 0; i < 11; ++i) copies.push_back(CopyAt(0, i * 100));
  const auto layers = Towers({19'000});
  const ErrorDetail detail =
      DetailOf(PassesOf(layers, copies, {.clearance_height_nm = FromMm(4'000)}).status());
  EXPECT_EQ(detail.reason, Reason::kRequestTooLarge);
  EXPECT_EQ(detail.metadata.at("got"), "209000");
}

}  // namespace
}  // namespace slicefarm::planning::sequence_planner_test
