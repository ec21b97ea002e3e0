#include "common/stage/print_layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "absl/strings/str_cat.h"

namespace slicefarm::print_layers_test {
namespace {

using testing::ElementsAre;

ObjectSection SectionOf(Stack stack, int32_t layer, Coord z_nm, Coord height_nm) {
  ObjectSection section;
  section.stack = stack;
  section.layer = layer;
  section.z_nm = z_nm;
  section.height_nm = height_nm;
  return section;
}

/// Returns layers of parts with a common layer height. Object i has `counts[i]` layers.
std::vector<SlicedLayer> Parts(const std::vector<int32_t>& counts, Coord height_nm) {
  std::vector<SlicedLayer> layers;
  for (int32_t i = 0; i < *std::ranges::max_element(counts); ++i) {
    SlicedLayer& layer = layers.emplace_back();
    layer.frame = {i, (i + 1) * height_nm, height_nm};
    for (int32_t object = 0; object < std::ssize(counts); ++object)
      if (i < counts[static_cast<size_t>(object)])
        layer.sections.push_back(SectionOf(object, i, (i + 1) * height_nm, height_nm));
  }
  return layers;
}

/// Returns "index top/height: stack.layer ..." for each layer.
std::vector<std::string> TextOf(const std::vector<SlicedLayer>& layers) {
  std::vector<std::string> texts;
  for (const SlicedLayer& layer : layers) {
    std::string text = absl::StrCat(layer.frame.index, " ", layer.frame.print_z_nm, "/",
                                    layer.frame.height_nm, ":");
    for (const ObjectSection& section : layer.sections)
      absl::StrAppend(&text, " ", section.stack.id, ".", section.layer);
    texts.push_back(text);
  }
  return texts;
}

const Stack kRaftStack(2, kPlateObject, StackKind::kRaft);
const Stack kSupportStack(3, 0, StackKind::kSupport);

TEST(PrintLayers, PartsAloneStayAsTheyAre) {
  const std::vector<SlicedLayer> parts = Parts({3, 2}, 20);
  EXPECT_EQ(PrintLayers(parts, {}, {}), parts);
  EXPECT_EQ(PrintLayers(parts, std::vector<Coord>{0, 0}, {}), parts);
}

TEST(PrintLayers, AStackThatAddsNoHeightLeavesTheFrames) {
  const AddedStack brim{kRaftStack, 0, {SectionOf(kRaftStack, 0, 20, 20)}};
  EXPECT_THAT(TextOf(PrintLayers(Parts({2}, 20), {}, {brim})),
              ElementsAre("0 20/20: 0.0 2.0", "1 40/20: 0.1"));
}

TEST(PrintLayers, APartOnARaftIsLifted) {
  const AddedStack raft{
      kRaftStack, 0, {SectionOf(kRaftStack, 0, 20, 20), SectionOf(kRaftStack, 1, 50, 30)}};
  EXPECT_THAT(TextOf(PrintLayers(Parts({2, 1}, 20), std::vector<Coord>{60, 0}, {raft})),
              ElementsAre("0 20/20: 1.0 2.0", "1 50/30: 2.1", "2 80/30: 0.0", "3 100/20: 0.1"));
}

TEST(PrintLayers, ALayerMayEndBetweenTwoOfThePart) {
  const AddedStack support{
      kSupportStack, 5, {SectionOf(kSupportStack, 0, 15, 15), SectionOf(kSupportStack, 1, 25, 10)}};
  EXPECT_THAT(TextOf(PrintLayers(Parts({2}, 20), {}, {support})),
              ElementsAre("0 20/20: 0.0 3.0", "1 30/10: 3.1", "2 40/10: 0.1"));
}

TEST(PrintLayers, HeightsDoNotDependOnTheOrderOfStacks) {
  const AddedStack raft{kRaftStack, 0, {SectionOf(kRaftStack, 0, 17, 17)}};
  const AddedStack support{kSupportStack, 0, {SectionOf(kSupportStack, 0, 17, 17)}};
  const auto layers = PrintLayers(Parts({3, 3}, 20), {}, {raft, support});
  EXPECT_EQ(layers, PrintLayers(Parts({3, 3}, 20), {}, {support, raft}));
  Coord below_nm = 0;
  for (const SlicedLayer& layer : layers) {
    EXPECT_EQ(layer.frame.print_z_nm - layer.frame.height_nm, below_nm);
    below_nm = layer.frame.print_z_nm;
  }
}

TEST(PrintLayerCount, IsThatOfTheLayers) {
  const AddedStack support{
      kSupportStack, 5, {SectionOf(kSupportStack, 0, 15, 15), SectionOf(kSupportStack, 1, 30, 15)}};
  const std::vector<SlicedLayer> parts = Parts({3, 2}, 20);
  for (const std::vector<Coord>& lifts : {std::vector<Coord>{}, {0, 0}, {5, 0}, {20, 20}})
    for (const std::vector<AddedStack>& added : {std::vector<AddedStack>{}, {support}})
      EXPECT_EQ(PrintLayerCount(parts, lifts, added), PrintLayers(parts, lifts, added).size());
}

}  // namespace
}  // namespace slicefarm::print_layers_test
