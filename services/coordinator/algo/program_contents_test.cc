#include "services/coordinator/algo/program_contents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "absl/strings/escaping.h"
#include "common/gcode/binary/binary_gcode.h"

namespace slicefarm::coordinator::program_contents_test {
namespace {

const std::string kProgram =
    "; head\nG28\nG1 X1\n;LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\nG1 X1 Y2\nG2 X3\nM107\n;HEIGHT:0.4\n"
    "G10\n;LAYER_CHANGE\n;Z:0.45\n;HEIGHT:0.25\nG0 X1\nG1 X" +
    std::string(1000, '1') + "\nG1\n;LAYER_CHANGE";

std::vector<LayerPlace> Expected() {
  const auto offset = [](int layer) {
    size_t at = 0;
    for (int i = 0; i <= layer; ++i) at = kProgram.find(";LAYER_CHANGE", i == 0 ? 0 : at + 1);
    return static_cast<int64_t>(at);
  };
  return {{offset(0), 0.2, 0.2, 2}, {offset(1), 0.45, 0.25, 3}, {offset(2), 0, 0, 0}};
}

TEST(LayerScan, FindsLayersHoweverTheBytesCome) {
  for (const size_t piece : {size_t{1}, size_t{7}, size_t{64}, kProgram.size()}) {
    LayerScan scan;
    for (size_t at = 0; at < kProgram.size(); at += piece)
      scan.Add(std::string_view(kProgram).substr(at, piece));
    EXPECT_EQ(std::move(scan).Layers(), Expected()) << piece;
  }
}

// Each layer's offset is that of its block: a printer reads whole blocks.
TEST(LayerScan, FindsTheLayersOfBinaryGcode) {
  std::string text;
  for (int i = 0; i < 9000; ++i) text += ";LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\nG1 X1 Y2\n";
  const std::string binary = gcode::BinaryGcode(text).value();
  for (const size_t piece : {size_t{1000}, binary.size()}) {
    LayerScan scan;
    for (size_t at = 0; at < binary.size(); at += piece)
      scan.Add(std::string_view(binary).substr(at, piece));
    const std::vector<LayerPlace> layers = std::move(scan).Layers();
    ASSERT_EQ(layers.size(), 9000u);
    EXPECT_EQ(layers.back().moves, 1);
    EXPECT_EQ(layers.back().z_mm, 0.2);
    EXPECT_EQ(binary[static_cast<size_t>(layers.front().offset)], '\1') << "a block of G-code";
    EXPECT_LT(layers.front().offset, layers.back().offset);
  }
  LayerScan cut_off;
  cut_off.Add(std::string_view(binary).substr(0, binary.size() - 5));
  EXPECT_THAT(std::move(cut_off).Layers(), testing::IsEmpty());
}

TEST(LayerScan, OtherTextsHaveNone) {
  LayerScan scan;
  scan.Add(std::string(5000, 'x'));
  scan.Add("\n1,2,3\nG1 X1\n");
  EXPECT_THAT(std::move(scan).Layers(), testing::IsEmpty());
}

TEST(LayersJson, HasTimesIfThereIsOneForEach) {
  const auto json = nlohmann::json::parse(LayersJson(Expected(), {1, 2, 3}));
  EXPECT_EQ(json["layers"].size(), 3u);
  EXPECT_EQ(json["layers"][1]["time_s"], 2);
  EXPECT_EQ(json["layers"][1]["z_mm"], 0.45);
  EXPECT_EQ(json["layers"][1]["moves"], 3);
  EXPECT_FALSE(nlohmann::json::parse(LayersJson(Expected(), {1}))["layers"][0].contains("time_s"));
}

std::string Thumbnail(const std::string& size, const std::string& bytes) {
  std::string base64 = absl::Base64Escape(bytes), text = "; thumbnail begin " + size + " 99\n";
  for (; !base64.empty(); base64.erase(0, 78)) text += "; " + base64.substr(0, 78) + "\n";
  return text + "; thumbnail end\n;\n";
}

TEST(LargestThumbnail, IsTheOneOfMostPixels) {
  const std::string large(500, '\xf0');
  const std::string program = "; by\n" + Thumbnail("16x16", "small") + Thumbnail("220x124", large) +
                              Thumbnail("64x64", "middle") +
                              "; thumbnail_JPG begin 999x999 4\n; abcd\nG1 X1\n";
  EXPECT_EQ(LargestThumbnail(program), large);
  const std::string binary = gcode::BinaryGcode("; by\n" + Thumbnail("16x16", "small") +
                                                Thumbnail("220x124", large) + "G1 X1\n")
                                 .value();
  EXPECT_EQ(LargestThumbnail(binary), large);
  EXPECT_EQ(LargestThumbnail(std::string_view(binary).substr(0, binary.size() - 3)), large)
      << "what stands behind the pictures need not be there";
  EXPECT_EQ(LargestThumbnail("G1 X1\n"), std::nullopt);
  EXPECT_EQ(LargestThumbnail("; thumbnail begin 16x16 9\n; no base 64!\n; thumbnail end\n"),
            std::nullopt);
}

TEST(Report, SaysHowLongLayersTakeAndWhatTheProgramIsCalled) {
  const std::string report = R"({"file_name": "part.gcode", "times": {"layers_s": [1.5, 2]}})";
  EXPECT_THAT(LayerTimesOf(report), testing::ElementsAre(1.5, 2));
  EXPECT_EQ(ProgramName(report, "id"), "part.gcode");
  for (const char* other :
       {"", "[]", "{}", R"({"times": 5, "file_name": 5})", R"({"file_name": "../x"})"}) {
    EXPECT_THAT(LayerTimesOf(other), testing::IsEmpty()) << other;
    EXPECT_EQ(ProgramName(other, "id"), "id.gcode") << other;
  }
}

TEST(MediaType, FollowsTheEnding) {
  EXPECT_EQ(MediaTypeOf("a.gcode"), "text/x.gcode");
  EXPECT_EQ(MediaTypeOf("a.svg"), "image/svg+xml");
  EXPECT_EQ(MediaTypeOf("a"), "application/octet-stream");
}

}  // namespace
}  // namespace slicefarm::coordinator::program_contents_test
