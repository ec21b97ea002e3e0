#include "processes/fdm/job/sampled_estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "common/model/options/motion_options.h"

namespace slicefarm::coordinator::sampled_estimate_test {
namespace {

using testing::ElementsAre;

/// Returns layers that take 1 s, 2 s, 3 s, ...
std::vector<LayerEstimate> Layers(int count) {
  std::vector<LayerEstimate> layers;
  for (int i = 0; i < count; ++i) layers.push_back({1.0 + i, 10.0 * (1 + i)});
  return layers;
}

/// Returns samples of these layers. Each sample is `by` times its estimate.
LayerSamples SamplesOf(const std::vector<LayerEstimate>& layers, const std::vector<int32_t>& which,
                       double by) {
  LayerSamples samples;
  for (const int32_t layer : which) {
    const LayerEstimate& rough = layers[static_cast<size_t>(layer)];
    samples.layers.push_back({layer, by * rough.time_s, by * rough.volume_mm3});
  }
  return samples;
}

double Time(const std::vector<LayerEstimate>& layers) {
  double time = 0;
  for (const LayerEstimate& layer : layers) time += layer.time_s;
  return time;
}

TEST(LayersToSample, AreTheFirstAndSpreadByTime) {
  const std::vector<int32_t> all = LayersToSample(Layers(300), {});
  EXPECT_EQ(all.front(), 0);
  EXPECT_EQ(all.size(), 33u);
  // The layers above 212 take half of the total time.
  EXPECT_NEAR(std::ranges::count_if(all, [](int32_t layer) { return layer > 212; }), 16, 1);
  EXPECT_THAT(LayersToSample(Layers(1), {}), ElementsAre(0));
  EXPECT_THAT(LayersToSample(Layers(3), {}), ElementsAre(0, 1, 2));
}

TEST(LayersToSample, HaveRaftsAmongThem) {
  std::vector<LayerEstimate> layers(3);
  for (const LayerEstimate& layer : Layers(300)) layers.push_back(layer);
  std::vector<SlicedLayer> print(layers.size());
  for (int32_t i = 0; i < std::ssize(print); ++i) {
    ObjectSection& section = print[static_cast<size_t>(i)].sections.emplace_back();
    print[static_cast<size_t>(i)].frame.index = i;
    section.stack = i < 3 ? Stack(1, kPlateObject, StackKind::kRaft) : Stack(0);
    section.regions.resize(1);
  }
  const std::vector<int32_t> all = LayersToSample(layers, print);
  EXPECT_THAT(std::vector(all.begin(), all.begin() + 3), ElementsAre(0, 1, 2));
  EXPECT_EQ(std::ranges::count(all, 5), 0);
}

TEST(EstimateFrom, ScalesWhatWasNotMade) {
  const std::vector<LayerEstimate> layers = Layers(100);
  LayerSamples samples = SamplesOf(layers, {0, 20, 70}, 1.5);
  samples.around_s = 7;
  const MotionOptions motion;
  const JobEstimate estimate = EstimateFrom(samples, layers, motion);
  EXPECT_NEAR(estimate.print_time_s, 1.5 * Time(layers) + 7, 1e-6);
  EXPECT_NEAR(estimate.filament.length_mm, 15 * Time(layers), 1e-6);
}

TEST(EstimateFrom, GoesBetweenSamplesInProportion) {
  const std::vector<LayerEstimate> layers(5, {10, 10});
  LayerSamples samples;
  samples.layers = {{0, 10, 10}, {4, 30, 30}};
  EXPECT_NEAR(EstimateFrom(samples, layers, {}).print_time_s, 10 + 15 + 20 + 25 + 30, 1e-9);
}

TEST(EstimateFrom, WhatARaftTakesIsAddedAndMeasuresNothingElse) {
  std::vector<LayerEstimate> layers(10, {10, 10});
  layers[0] = layers[1] = {0, 0};
  LayerSamples samples;
  samples.layers = {{0, 100, 100}, {1, 50, 50}, {5, 20, 20}};
  EXPECT_NEAR(EstimateFrom(samples, layers, {}).print_time_s, 100 + 50 + 8 * 20, 1e-9);
}

}  // namespace
}  // namespace slicefarm::coordinator::sampled_estimate_test
