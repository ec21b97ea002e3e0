#include "services/cli/render/cli_layer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::cli::cli_layer_test {
namespace {

constexpr char kHeader[] = "$$HEADERSTART\n$$ASCII\n$$UNITS/0.01\n$$LAYERS/2\n$$HEADEREND\n";

std::string Ascii(const std::string& geometry) {
  return std::string(kHeader) + "$$GEOMETRYSTART\n" + geometry + "$$GEOMETRYEND\n";
}

const char kTwoLayers[] =
    "$$LAYER/10\n$$POLYLINE/1,1,3,0,0,100,0,0,0\n"
    "$$LAYER/30\n$$POLYLINE/1,2,2,0,0,100,0\n$$HATCHES/1,2,0,1,100,1,100,2,0,2\n";

template <class T>
std::string Bytes(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

TEST(ReadCliLayer, ReadsContoursAndHatchesInOrder) {
  const auto layer = ReadCliLayer(Ascii(kTwoLayers), 1, 0.1);
  ASSERT_TRUE(layer.ok()) << layer.status();
  EXPECT_EQ(layer->layer_count, 2);
  EXPECT_DOUBLE_EQ(layer->z_mm, 0.3);
  EXPECT_NEAR(layer->height_mm, 0.2, 1e-12);
  ASSERT_EQ(layer->beads.size(), 3u);
  EXPECT_EQ(layer->beads[0].feature, "contour");
  EXPECT_EQ(layer->beads[0].width_mm, 0.1);
  EXPECT_EQ(layer->beads[0].points, (std::vector<Vector2>{{0, 0}, {1, 0}}));
  EXPECT_EQ(layer->beads[2].feature, "hatch");
  EXPECT_EQ(layer->beads[2].points, (std::vector<Vector2>{{1, 0.02}, {0, 0.02}}));
  ASSERT_EQ(layer->travels.size(), 2u);
  EXPECT_EQ(layer->travels[1].back(), (Vector2{1, 0.02}));
  EXPECT_EQ(ReadCliLayer(Ascii(kTwoLayers), 0, 0.1)->beads[0].points.size(), 3u);
}

TEST(ReadCliLayer, LabelsTellSpeedAndEnergy) {
  const std::string file =
      "$$HEADERSTART\n$$ASCII\n$$UNITS/0.01\n$$LABEL/1,contour 100 W 400 mm/s\n"
      "$$LABEL/2,hatch 300 W 600 mm/s\n$$HEADEREND\n"
      "$$LAYER/10\n$$POLYLINE/1,2,2,0,0,100,0\n$$HATCHES/2,1,0,1,100,1\n$$HATCHES/3,1,0,1,9,1\n";
  const auto layer = ReadCliLayer(file, 0, 0.1);
  ASSERT_TRUE(layer.ok()) << layer.status();
  ASSERT_EQ(layer->beads.size(), 3u);
  EXPECT_EQ(layer->beads[0].speed_mm_s, 400);
  EXPECT_DOUBLE_EQ(layer->beads[0].energy_j_mm, 0.25);
  EXPECT_DOUBLE_EQ(layer->beads[1].energy_j_mm, 0.5);
  EXPECT_EQ(layer->beads[2].energy_j_mm, 0);  // the hatch has no label
}

TEST(ReadCliLayer, LabelsOfSlicefarmTellKindsApart) {
  const std::string file =
      "$$HEADERSTART\n$$ASCII\n$$UNITS/0.01\n$$LABEL/1,contour 100 W 400 mm/s\n"
      "$$LABEL/2,upskin 300 W 600 mm/s\n$$LABEL/3,thin wall 300 W 600 mm/s\n"
      "$$LABEL/4,bracket\n$$HEADEREND\n$$LAYER/10\n$$POLYLINE/1,2,2,0,0,100,0\n"
      "$$HATCHES/2,1,0,1,100,1\n$$POLYLINE/3,2,2,0,1,9,1\n$$HATCHES/4,1,0,1,9,1\n";
  const auto layer = ReadCliLayer(file, 0, 0.1);
  ASSERT_TRUE(layer.ok()) << layer.status();
  std::vector<std::string> kinds;
  for (const BeadRun& run : layer->beads) kinds.push_back(run.feature);
  EXPECT_EQ(kinds, (std::vector<std::string>{"contour", "upskin", "thin wall", "hatch"}));
}

TEST(ReadCliLayer, PassesOverComments) {
  const std::string file =
      "// made by hand // $$HEADERSTART // $$UNITS/7 //\n$$ASCII $$UNITS/0.01 // mm //\n"
      "$$HEADEREND $$GEOMETRYSTART\n// first // $$LAYER/10.0 // z //\n"
      "$$POLYLINE/1,2,2,0,0, // to // 100,0\n$$GEOMETRYEND";
  EXPECT_TRUE(IsCliFile(file));
  const auto layer = ReadCliLayer(file, 0, 0.1);
  ASSERT_TRUE(layer.ok()) << layer.status();
  EXPECT_DOUBLE_EQ(layer->z_mm, 0.1);
  EXPECT_EQ(layer->beads.at(0).points, (std::vector<Vector2>{{0, 0}, {1, 0}}));
}

TEST(ReadCliLayer, ReadsBinaryLongAndShort) {
  const std::string header = "$$HEADERSTART$$BINARY$$UNITS/0.5\n$$HEADEREND";
  std::string body = Bytes<uint16_t>(127) + Bytes(2.F);
  body += Bytes<uint16_t>(130) + Bytes<int32_t>(1) + Bytes<int32_t>(1) + Bytes<int32_t>(2);
  for (const float f : {0.F, 0.F, 4.F, 2.F}) body += Bytes(f);
  body += Bytes<uint16_t>(131) + Bytes<uint16_t>(1) + Bytes<uint16_t>(1);
  for (const uint16_t v : {1, 2, 3, 4}) body += Bytes(v);
  const auto layer = ReadCliLayer(header + body, 0, 0.1);
  ASSERT_TRUE(layer.ok()) << layer.status();
  EXPECT_DOUBLE_EQ(layer->z_mm, 1);
  ASSERT_EQ(layer->beads.size(), 2u);
  EXPECT_EQ(layer->beads[0].points[1], (Vector2{2, 1}));
  EXPECT_EQ(layer->beads[1].points[1], (Vector2{1.5, 2}));
  // A file cut at any position is refused or has fewer lines.
  for (size_t size = 0; size < body.size(); ++size) {
    const auto cut = ReadCliLayer(header + body.substr(0, size), 0, 0.1);
    if (cut.ok()) {
      EXPECT_LT(cut->beads.size(), 2u) << size;
    }
  }
}

TEST(ReadCliLayer, RefusesWhatTheFormatDoesNotHave) {
  const std::string cases[] = {"",
                               "G1 X1",
                               "$$HEADERSTART\n$$UNITS/1\n",
                               "$$HEADERSTART\n$$ASCII\n$$HEADEREND\n",
                               "$$HEADERSTART\n$$UNITS/x\n$$HEADEREND\n",
                               Ascii("$$LAYER/\n"),
                               Ascii("$$LAYER/1\n$$POLYLINE/1,1,3,0,0\n"),
                               Ascii("$$LAYER/1\n$$HATCHES/1,-1,0\n"),
                               Ascii("$$LAYER/1\n$$POLYLINE/1,1,a,0,0\n"),
                               "$$HEADERSTART$$BINARY$$UNITS/1\n$$HEADEREND" + Bytes<uint16_t>(7)};
  for (const std::string& bytes : cases) {
    EXPECT_EQ(DetailOf(ReadCliLayer(bytes, 0, 0.1).status()).reason, Reason::kRequestMalformed)
        << bytes;
  }
}

TEST(ReadCliLayer, NamesTheLastLayer) {
  const absl::Status status = ReadCliLayer(Ascii(kTwoLayers), 2, 0.1).status();
  EXPECT_EQ(status.message(), "there is no layer 2: the last layer is 1");
}

}  // namespace
}  // namespace slicefarm::cli::cli_layer_test
