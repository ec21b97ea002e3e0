#include "common/model/options/layer_heights.h"

#include <gtest/gtest.h>

namespace slicefarm::layer_heights_test {
namespace {

TEST(LayerHeights, AreReadAndWritten) {
  const auto heights = ParseLayerHeights("0.000000;0.200000;5.5;0.1;5.5;0.3");
  ASSERT_TRUE(heights.ok()) << heights.status();
  EXPECT_EQ(*heights,
            (std::vector<LayerHeightAt>{{0, 200'000}, {5'500'000, 100'000}, {5'500'000, 300'000}}));
  EXPECT_EQ(PrintLayerHeights(*heights), "0;0.2;5.5;0.1;5.5;0.3");
  EXPECT_EQ(ParseLayerHeights(PrintLayerHeights(*heights)).value(), *heights);
  EXPECT_TRUE(ParseLayerHeights("")->empty());
  EXPECT_EQ(PrintLayerHeights({}), "");
}

TEST(LayerHeights, RefusesWhatIsNone) {
  std::string many = "0;0.2";
  for (int i = 0; i < kMaxLayerHeightPoints; ++i) many += ";1;0.2";
  for (const std::string_view text :
       {std::string_view("0"), std::string_view("0;"), std::string_view("0;0.2;"),
        std::string_view("a;0.2"), std::string_view("0;0"), std::string_view("0;6"),
        std::string_view("-1;0.2"), std::string_view("5;0.2;4;0.2"), std::string_view("nan;0.2"),
        std::string_view("0;inf"), std::string_view("1e300;0.2"), std::string_view(many)})
    EXPECT_FALSE(ParseLayerHeights(text).ok()) << text.substr(0, 40);
}

}  // namespace
}  // namespace slicefarm::layer_heights_test
