#include "processes/fdm/task/layer_chain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "common/base/error.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/stage/motion_job.h"
#include "common/stage/ordering_job.h"
#include "processes/fdm/task/fdm_shared.h"

namespace slicefarm::layer_chain_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Beading stage that records its input layers. Each walled layer has as many plain islands as its
/// index.
struct Beading : BeadingStage {
  absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall&, const Neighbourhood& hood,
                                                const Shared<BeadingTable>&) const override {
    seen = {hood.layers.front().frame.index, hood.layers.back().frame.index + 1};
    std::vector<WalledLayer> walled(static_cast<size_t>(hood.range.size()));
    for (size_t i = 0; i < walled.size(); ++i) {
      walled[i].frame.index = hood.range.first + static_cast<int32_t>(i);
      walled[i].plain_islands = walled[i].frame.index;
    }
    return walled;
  }
  mutable LayerRange seen;
};

struct Infill : InfillStage {
  absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall&, std::vector<WalledLayer> walled,
                                                const Neighbourhood& hood,
                                                std::span<const LayerPlan>,
                                                const Shared<InfillTable>&) const override {
    seen = {hood.layers.front().frame.index, hood.layers.back().frame.index + 1};
    if (fails) return MakeError(absl::StatusCode::kInternal, Reason::kInternal, "infill");
    std::vector<FilledLayer> filled(walled.size());
    for (FilledLayer& layer : filled) layer.sections = sections;
    return filled;
  }
  bool fails = false;
  std::vector<FilledSection> sections;  ///< same sections for each layer
  mutable LayerRange seen;
};

struct Ordering : OrderingStage {
  absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall&, std::vector<FilledLayer> layers,
                                                  std::span<const LayerPlan> plans,
                                                  const Shared<OrderingJob>& job) const override {
    plan_count = plans.size();
    for (const FilledLayer& layer : layers)
      for (const FilledSection& section : layer.sections) EXPECT_THAT(section.uses, IsEmpty());
    copy_count = job->copies.size();
    std::vector<OrderedLayer> ordered(layers.size());
    for (size_t i = 0; i < ordered.size(); ++i)
      ordered[i].blocks.emplace_back().layer = first_block + static_cast<int32_t>(i);
    return ordered;
  }
  int32_t first_block = 0;
  mutable size_t plan_count = 0;
  mutable size_t copy_count = 0;
};

struct Motion : MotionStage {
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall&,
                                                    std::vector<OrderedLayer> layers,
                                                    const Shared<MotionJob>& job) const override {
    called = true;
    below.clear();
    surfaces.clear();
    for (const OrderedLayer& layer : layers)
      for (const PathBlock& block : layer.blocks) {
        below.push_back(block.below);
        surfaces.push_back(block.surface);
      }
    std::vector<LayerProgram> programs(layers.size());
    for (LayerProgram& program : programs)
      program.frame.index = static_cast<int32_t>(job->facts.copies.size());
    return programs;
  }
  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall&, const ProgramSummary&,
                                           const MotionOptions&) const override {
    return ProgramEnvelope{};
  }
  mutable bool called = false;
  mutable std::vector<MultiPolygon> below;
  mutable std::vector<std::vector<SurfaceFacet>> surfaces;
};

class LayerChainTest : public testing::Test {
 protected:
  LayerChainTest() {
    for (int32_t i = 0; i < 20; ++i) {
      SlicedLayer& layer = layers_.emplace_back();
      layer.frame.index = i;
      ObjectSection& section = layer.sections.emplace_back();
      section.layer = i;
      section.layer_count = 20;
    }
    copies_.resize(3);
    facts_.copies.resize(3);
  }

  absl::StatusOr<FdmResult> Run(LayerRange range, LayerRange sent) {
    plans_.resize(static_cast<size_t>(range.size()));
    return chain_.Run(StageCall{},
                      {.range = range,
                       .layers = std::span(layers_).subspan(static_cast<size_t>(sent.first),
                                                            static_cast<size_t>(sent.size())),
                       .plans = plans_,
                       .job = FdmShared{settings_, copies_, facts_}});
  }

  std::vector<SlicedLayer> layers_;
  std::vector<LayerPlan> plans_;
  std::vector<Copy> copies_;
  JobFacts facts_;
  FdmSettings settings_;
  Beading beading_;
  Infill infill_;
  Ordering ordering_;
  Motion motion_;
  LayerChain chain_{beading_, infill_, ordering_, motion_};
};

TEST_F(LayerChainTest, EachStageIsGivenWhatItWorksFrom) {
  const auto result = Run({8, 11}, {0, 20});
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_EQ(result->programs.size(), 3u);
  EXPECT_EQ(result->programs[0].frame.index, 3);  // the facts reached the stage
  EXPECT_EQ(ordering_.plan_count, 3u);
  EXPECT_EQ(ordering_.copy_count, 3u);
}

// Motion gets the layer below only if walls over air are slowed down or cooled.
TEST_F(LayerChainTest, MotionIsGivenWhatLiesBelow) {
  for (size_t i = 0; i < layers_.size(); ++i) {
    const Coord x = FromMm(static_cast<double>(i));
    layers_[i].sections[0].regions = {{.outlines = {{{{x, 0}, {x + 1000, 0}, {x, 1000}}, {}}}}};
  }
  ordering_.first_block = 8;
  ASSERT_TRUE(Run({8, 10}, {0, 20}).ok());
  EXPECT_THAT(motion_.below, ElementsAre(IsEmpty(), IsEmpty()));
  settings_.tools[0].cooling.dynamic_fan = true;
  ASSERT_TRUE(Run({8, 10}, {0, 20}).ok());
  EXPECT_THAT(motion_.below, ElementsAre(layers_[7].sections[0].regions[0].outlines,
                                         layers_[8].sections[0].regions[0].outlines));
  ordering_.first_block = 0;
  ASSERT_TRUE(Run({0, 1}, {0, 20}).ok());
  EXPECT_THAT(motion_.below, ElementsAre(IsEmpty())) << "nothing lies below an object";
}

// The first layer stays level on the bed.
TEST_F(LayerChainTest, MotionIsGivenTheSurface) {
  const std::vector<SurfaceFacet> facets = {{{Point{1, 2}, {3, 4}, {5, 6}}, {7, 8, 9}}};
  layers_[0].sections[0].surface = layers_[9].sections[0].surface = facets;
  ordering_.first_block = 8;
  ASSERT_TRUE(Run({8, 10}, {0, 20}).ok());
  EXPECT_THAT(motion_.surfaces, ElementsAre(IsEmpty(), facets));
  ordering_.first_block = 0;
  ASSERT_TRUE(Run({0, 1}, {0, 20}).ok());
  EXPECT_THAT(motion_.surfaces, ElementsAre(IsEmpty()));
}

// A remote beading stage does not receive outlines that only infill uses.
TEST_F(LayerChainTest, AStageIsSentItsOwnHaloOnly) {
  ASSERT_TRUE(Run({8, 11}, {0, 20}).ok());
  const int32_t halo = BeadingHaloLayers(settings_);
  EXPECT_EQ(beading_.seen, (LayerRange{8 - halo, 11 + halo}));
  EXPECT_EQ(infill_.seen, (LayerRange{0, 20}));
}

TEST_F(LayerChainTest, PlainIslandsAreWarnedOf) {
  const auto result = Run({0, 3}, {0, 20});
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_THAT(result->warnings, ElementsAre(LayerWarning{.layer = 1, .plain_islands = 1},
                                            LayerWarning{.layer = 2, .plain_islands = 2}));
}

// Figures are separate for each layer, so that sums over the job do not depend on its division into
// ranges.
TEST_F(LayerChainTest, WhatInfillComesToIsCountedForEachCopy) {
  const auto use = [](int32_t settings, int64_t paths) {
    FillStats of;
    of.settings = settings;
    of.paths = paths;
    of.longest_mm = 9;
    return of;
  };
  copies_ = {{0, {}, 0}, {1, {}, 0}, {0, {}, 1}};
  infill_.sections = {{Stack(2, kPlateObject, StackKind::kRaft), 0, 0, {}, {use(2, 100)}},
                      {0, 0, 0, {}, {use(0, 10), use(1, 1)}},
                      {1, 0, 0, {}, {use(1, 5)}}};
  const auto result = Run({8, 10}, {0, 20});
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_THAT(result->fills,
              ElementsAre(use(0, 20), use(1, 7), use(2, 100), use(0, 20), use(1, 7), use(2, 100)));
}

TEST_F(LayerChainTest, AHaloTooSmallIsRefused) {
  const auto result = Run({8, 11}, {8, 11});
  EXPECT_EQ(DetailOf(result.status()).reason, Reason::kRequestMalformed);
  EXPECT_FALSE(motion_.called);
}

TEST_F(LayerChainTest, AStagesErrorEndsTheChain) {
  infill_.fails = true;
  const auto result = Run({8, 11}, {0, 20});
  EXPECT_EQ(DetailOf(result.status()).reason, Reason::kInternal);
  EXPECT_FALSE(motion_.called);
}

}  // namespace
}  // namespace slicefarm::layer_chain_test
