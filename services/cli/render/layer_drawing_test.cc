#include "services/cli/render/layer_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "common/picture/picture_test.h"

namespace slicefarm::cli::layer_drawing_test {
namespace {

using testing::HasSubstr;

void ExpectColour(Colour got, Colour want) {
  EXPECT_NEAR(got.red, want.red, 0.01);
  EXPECT_NEAR(got.green, want.green, 0.01);
  EXPECT_NEAR(got.blue, want.blue, 0.01);
}

GcodeLayer TwoBeads() {
  return {.index = 3,
          .layer_count = 10,
          .z_mm = 0.8,
          .height_mm = 0.2,
          .beads = {{"External perimeter", 1.0, {{0, 0}, {20, 0}}},
                    {"Solid infill", 0.5, {{0, 5}, {20, 5}}}},
          .travels = {{{0, 0}, {10, 2.5}}}};
}

TEST(DrawLayer, PaintsEachFeatureInItsColour) {
  const GcodeLayer layer = TwoBeads();
  const DrawingOptions options;
  const Layout layout = LayOut(layer, options);
  const auto png = DrawLayer(layer, options);
  ASSERT_TRUE(png.ok()) << png.status();
  const Picture picture(*png);
  EXPECT_EQ(picture.width(), layout.width_px);
  EXPECT_EQ(picture.height(), layout.height_px);
  ExpectColour(picture.At(layout.ToPixel({10, 0})), FeatureColour("External perimeter"));
  ExpectColour(picture.At(layout.ToPixel({10, 5})), FeatureColour("Solid infill"));
  ExpectColour(picture.At(layout.ToPixel({10, 2.5})), {1, 1, 1});
}

TEST(LayOut, HoldsAnyLayerThatCanBeRead) {
  const auto layer = ReadGcodeLayer(
      "M83\n;LAYER_CHANGE\nG1 XNAN Y1 E1\nG1 XINF Y2 E1\nG1 X1e9 Y-1e9 E1\nG1 X-1e9 Y1e9 E1\n", 0);
  ASSERT_TRUE(layer.ok());
  const DrawingOptions options;
  const Layout layout = LayOut(*layer, options);
  EXPECT_EQ(layout.part_width_px, options.size_px);
  EXPECT_EQ(layout.height_px, options.size_px);
}

TEST(DrawLayer, GivesBeadsTheirWidthAndRoundEnds) {
  const GcodeLayer layer = TwoBeads();
  const Layout layout = LayOut(layer, {});
  const Picture picture(*DrawLayer(layer, {}));
  const auto painted = [&](double x, double y) {
    const Colour colour = picture.At(layout.ToPixel({x, y}));
    return colour.red + colour.green + colour.blue < 2.97;
  };
  // The bead is 1 mm wide: it reaches 0.5 mm to either side, and no farther.
  EXPECT_TRUE(painted(10, 0.47));
  EXPECT_TRUE(painted(10, -0.47));
  EXPECT_FALSE(painted(10, 0.53));
  EXPECT_FALSE(painted(10, -0.53));
  // The end is a half disc around (20, 0).
  EXPECT_TRUE(painted(20.47, 0));
  EXPECT_FALSE(painted(20.53, 0));
  EXPECT_FALSE(painted(20.45, 0.45));
  // The bead is 0.5 mm wide.
  EXPECT_TRUE(painted(10, 5.22));
  EXPECT_FALSE(painted(10, 5.28));
}

TEST(DrawLayer, PaintsLaterBeadsOverEarlierOnes) {
  GcodeLayer layer = TwoBeads();
  layer.beads[1].points = {{10, -5}, {10, 5}};
  const Layout layout = LayOut(layer, {});
  const Picture picture(*DrawLayer(layer, {}));
  ExpectColour(picture.At(layout.ToPixel({10, 0})), FeatureColour("Solid infill"));
}

TEST(DrawLayer, ColoursByWidth) {
  const GcodeLayer layer = TwoBeads();
  const DrawingOptions options = {.colour_by = ColourBy::kWidth};
  const Layout layout = LayOut(layer, options);
  const Picture picture(*DrawLayer(layer, options));
  ExpectColour(picture.At(layout.ToPixel({10, 0})), ScaleColour(1));
  ExpectColour(picture.At(layout.ToPixel({10, 5})), ScaleColour(0));
}

TEST(DrawLayer, ColoursBySpeedAndFlow) {
  GcodeLayer layer = TwoBeads();
  layer.beads[0].speed_mm_s = 20;
  layer.beads[1].speed_mm_s = 60;
  layer.beads[0].flow_mm3_s = 9;
  layer.beads[1].flow_mm3_s = 3;
  for (const ColourBy by : {ColourBy::kSpeed, ColourBy::kFlow}) {
    const DrawingOptions options = {.colour_by = by};
    const Layout layout = LayOut(layer, options);
    const Picture picture(*DrawLayer(layer, options));
    const double first = by == ColourBy::kSpeed ? 0 : 1;
    ExpectColour(picture.At(layout.ToPixel({10, 0})), ScaleColour(first));
    ExpectColour(picture.At(layout.ToPixel({10, 5})), ScaleColour(1 - first));
  }
}

TEST(DrawLayer, DrawsTravelsOnlyWhenAsked) {
  const GcodeLayer layer = TwoBeads();
  const Layout layout = LayOut(layer, {});
  const Vector2 between = layout.ToPixel({8, 2});
  ExpectColour(Picture(*DrawLayer(layer, {})).At(between), {1, 1, 1});
  const Colour line = Picture(*DrawLayer(layer, {.travels = true})).At(between);
  EXPECT_LT(line.red + line.green + line.blue, 2.5);
}

TEST(DrawLayer, WritesSvg) {
  const auto svg = DrawLayer(TwoBeads(), {.format = ImageFormat::kSvg});
  ASSERT_TRUE(svg.ok());
  EXPECT_THAT(*svg, HasSubstr("<svg"));
  EXPECT_THAT(*svg, HasSubstr("</svg>"));
  EXPECT_THAT(*svg, HasSubstr("stroke-linecap:round"));
}

TEST(DrawLayer, DrawsAnEmptyLayer) {
  EXPECT_TRUE(DrawLayer({.index = 0, .layer_count = 1}, {}).ok());
}

TEST(DrawLayer, KeepsTheLongerSideToItsSize) {
  GcodeLayer layer = TwoBeads();
  const Layout wide = LayOut(layer, {.size_px = 500});
  EXPECT_NEAR(wide.part_width_px, 500, 1);
  layer.beads = {{"Perimeter", 0.4, {{0, 0}, {0, 50}}}};
  EXPECT_NEAR(LayOut(layer, {.size_px = 900}).height_px, 900, 1);
}

TEST(DrawLayer, IsTheSameEveryTime) {
  EXPECT_EQ(*DrawLayer(TwoBeads(), {}), *DrawLayer(TwoBeads(), {}));
}

TEST(FeatureColour, TellsFeaturesApart) {
  const char* const kFeatures[] = {"External perimeter", "Perimeter",       "Overhang perimeter",
                                   "Gap fill",           "Internal infill", "Solid infill",
                                   "Top solid infill",   "Bridge infill",   "Skirt/Brim",
                                   "Support material",   "Ironing",         "Something else"};
  for (const char* a : kFeatures) {
    for (const char* b : kFeatures) {
      const Colour x = FeatureColour(a);
      const Colour y = FeatureColour(b);
      const double apart =
          std::abs(x.red - y.red) + std::abs(x.green - y.green) + std::abs(x.blue - y.blue);
      if (std::string(a) == b) continue;
      EXPECT_GT(apart, 0.15) << a << ", " << b;
    }
  }
}

}  // namespace
}  // namespace slicefarm::cli::layer_drawing_test
