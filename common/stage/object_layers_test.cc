#include "common/stage/object_layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "common/base/error.h"

namespace slicefarm::object_layers_test {
namespace {

using testing::Eq;
using testing::IsNull;
using testing::Pointee;

struct Own {
  int32_t object = 0;
  int32_t layer = 0;
  int32_t count = 0;
};

SlicedLayer LayerWith(int32_t index, const std::vector<Own>& sections) {
  SlicedLayer layer;
  layer.frame.index = index;
  for (const Own& own : sections) {
    ObjectSection& section = layer.sections.emplace_back();
    section.stack = own.object;
    section.layer = own.layer;
    section.layer_count = own.count;
  }
  return layer;
}

/// Returns the layers of two objects with equal layer heights: `first` layers of one object and
/// `second` layers of the other.
std::vector<SlicedLayer> InStep(int32_t first, int32_t second) {
  std::vector<SlicedLayer> layers;
  for (int32_t i = 0; i < std::max(first, second); ++i) {
    std::vector<Own> sections;
    if (i < first) sections.push_back({0, i, first});
    if (i < second) sections.push_back({1, i, second});
    layers.push_back(LayerWith(i, sections));
  }
  return layers;
}

/// Returns layers in which object 0 has a section in each layer, and object 1 in every third.
std::vector<SlicedLayer> OutOfStep() {
  std::vector<SlicedLayer> layers;
  for (int32_t i = 0; i < 30; ++i) {
    std::vector<Own> sections = {{0, i, 30}};
    if (i % 3 == 2) sections.push_back({1, i / 3, 10});
    layers.push_back(LayerWith(i, sections));
  }
  return layers;
}

std::span<const SlicedLayer> Cut(const std::vector<SlicedLayer>& layers, LayerRange range) {
  return std::span(layers).subspan(static_cast<size_t>(range.first),
                                   static_cast<size_t>(range.size()));
}

TEST(ObjectLayers, FindsByTheObjectsOwnLayer) {
  const std::vector<SlicedLayer> layers = OutOfStep();
  const ObjectLayers found(layers);
  EXPECT_EQ(found.Find(0, 7), &layers[7].sections[0]);
  EXPECT_EQ(found.Find(1, 7), &layers[23].sections[1]);
}

TEST(ObjectLayers, AirIsAboveBelowAndAround) {
  const std::vector<SlicedLayer> layers = InStep(4, 2);
  const ObjectLayers found(layers);
  EXPECT_THAT(found.Find(0, -1), IsNull());
  EXPECT_THAT(found.Find(0, 4), IsNull());
  EXPECT_THAT(found.Find(1, 2), IsNull());
  EXPECT_THAT(found.Find(2, 0), IsNull());
}

TEST(ObjectLayers, AStretchFromTheMiddleOfTheJob) {
  const std::vector<SlicedLayer> layers = OutOfStep();
  const auto cut = Cut(layers, {9, 15});
  const ObjectLayers found(cut);
  EXPECT_THAT(found.Find(0, 8), IsNull());
  EXPECT_EQ(found.Find(0, 9), &layers[9].sections[0]);
  EXPECT_EQ(found.Find(1, 3), &layers[11].sections[1]);
  EXPECT_EQ(found.Find(1, 4), &layers[14].sections[1]);
  EXPECT_THAT(found.Find(1, 5), IsNull());
}

// SlicedLayer requires consecutive layers of an object, but an untrusted message may violate this.
TEST(ObjectLayers, LayersAfterAGapAreNotFound) {
  const std::vector<SlicedLayer> layers = {LayerWith(0, {{0, 0, 9}}), LayerWith(1, {{0, 4, 9}}),
                                           LayerWith(2, {{0, 1, 9}})};
  const ObjectLayers found(layers);
  EXPECT_EQ(found.Find(0, 0), &layers[0].sections[0]);
  EXPECT_EQ(found.Find(0, 1), &layers[2].sections[0]);
  EXPECT_THAT(found.Find(0, 4), IsNull());
}

TEST(ObjectLayers, StacksOfOneObjectAreApart) {
  std::vector<SlicedLayer> layers = {LayerWith(0, {{0, 0, 1}, {5, 0, 1}})};
  layers[0].sections[1].stack = Stack(5, 0, StackKind::kSupport);
  EXPECT_EQ(ObjectLayers(layers).Find(0, 0), &layers[0].sections[0]);
  EXPECT_EQ(ObjectLayers(layers).Find(5, 0), &layers[0].sections[1]);
}

TEST(WithHalo, InStepItIsTheRangeAndAHaloOnEachSide) {
  const std::vector<SlicedLayer> layers = InStep(20, 20);
  EXPECT_EQ(WithHalo(layers, {5, 8}, 2), (LayerRange{3, 10}));
  EXPECT_EQ(WithHalo(layers, {0, 3}, 2), (LayerRange{0, 5}));
  EXPECT_EQ(WithHalo(layers, {18, 20}, 4), (LayerRange{14, 20}));
  EXPECT_EQ(WithHalo(layers, {5, 8}, 0), (LayerRange{5, 8}));
}

// Two thick layers above and below equal six thin layers of the other object.
TEST(WithHalo, ReachesAsFarAsTheThickestLayersWant) {
  const std::vector<SlicedLayer> layers = OutOfStep();
  EXPECT_EQ(WithHalo(layers, {14, 15}, 2), (LayerRange{8, 21}));
  EXPECT_EQ(WithHalo(layers, {15, 17}, 2), (LayerRange{13, 19}));  // no layer of object 1
}

TEST(WithHalo, AnObjectThatEndsWantsNoMore) {
  const std::vector<SlicedLayer> layers = InStep(20, 6);
  EXPECT_EQ(WithHalo(layers, {5, 6}, 3), (LayerRange{2, 9}));
  EXPECT_EQ(WithHalo(layers, {6, 7}, 3), (LayerRange{3, 10}));
}

TEST(CheckHalo, WhatWithHaloGivesIsEnough) {
  for (const auto& layers : {InStep(30, 30), InStep(30, 7), OutOfStep()}) {
    for (int32_t first = 0; first < 30; first += 3) {
      for (const int32_t last : {first + 1, std::min(first + 5, 30)}) {
        for (const int32_t halo : {0, 1, 4}) {
          const LayerRange all = WithHalo(layers, {first, last}, halo);
          EXPECT_TRUE(CheckHalo(Cut(layers, all), {first, last}, halo).ok())
              << first << " " << last << " " << halo;
        }
      }
    }
  }
}

TEST(CheckHalo, ARangeThatIsNotThereIsRefused) {
  const std::vector<SlicedLayer> layers = OutOfStep();
  for (const LayerRange range : {LayerRange{29, 31}, LayerRange{30, 40}, LayerRange{-1, 3}})
    EXPECT_EQ(DetailOf(CheckHalo(layers, range, 1)).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(CheckHalo(Cut(layers, {5, 9}), {4, 6}, 0)).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(CheckHalo({}, {0, 1}, 0)).reason, Reason::kRequestMalformed);
}

TEST(CheckHalo, ALayerTooFewIsRefused) {
  const std::vector<SlicedLayer> layers = OutOfStep();
  const LayerRange all = WithHalo(layers, {14, 15}, 2);
  EXPECT_EQ(DetailOf(CheckHalo(Cut(layers, {all.first + 1, all.last}), {14, 15}, 2)).reason,
            Reason::kRequestMalformed);
  const absl::Status above = CheckHalo(Cut(layers, {all.first, all.last - 1}), {14, 15}, 2);
  EXPECT_EQ(DetailOf(above).reason, Reason::kRequestMalformed);
  EXPECT_THAT(std::string(above.message()), testing::HasSubstr("layer 6 of stack 1"));
}

}  // namespace
}  // namespace slicefarm::object_layers_test
