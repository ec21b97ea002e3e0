#include "common/model/options/solid_layers.h"

#include <gtest/gtest.h>

namespace slicefarm::solid_layers_test {
namespace {

/// Returns the layers up to 20 of a list, counted from 1.
std::string LayersOf(std::string_view text) {
  const auto list = ParseSolidLayers(text);
  if (!list.ok()) return "error";
  std::string layers;
  for (int32_t layer = 0; layer < 20; ++layer)
    if (ContainsLayer(*list, layer))
      layers += (layers.empty() ? "" : " ") + std::to_string(layer + 1);
  return layers;
}

TEST(SolidLayers, AreTheseOfTheText) {
  struct Case {
    std::string_view text;
    std::string_view layers;
  };
  for (const Case& c : {Case{"5", "5 10 15 20"}, Case{"5#", "5 10 15 20"}, Case{"8#2", "8 9 16 17"},
                        Case{"1,7,9", "1 7 9"}, Case{" 2 , 9#3 ", "2 9 10 11"},
                        Case{"1#1", "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20"}})
    EXPECT_EQ(LayersOf(c.text), c.layers) << c.text;
}

TEST(SolidLayers, ArePrintedAsTheyAreRead) {
  for (const std::string_view text : {"5", "5#2", "1,7,9", "1,7#2,9"})
    EXPECT_EQ(PrintSolidLayers(*ParseSolidLayers(text)), text);
  EXPECT_EQ(PrintSolidLayers(*ParseSolidLayers(" 5#1 ")), "5");
}

TEST(SolidLayers, OtherTextsAreRefused) {
  for (const std::string_view text : {"", "0", "-3", "1.5", "a", "5#0", "5#x", "1;2"})
    EXPECT_FALSE(ParseSolidLayers(text).ok()) << text;
}

}  // namespace
}  // namespace slicefarm::solid_layers_test
