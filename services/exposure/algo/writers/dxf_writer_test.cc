#include "services/exposure/algo/writers/dxf_writer.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "services/exposure/algo/writers/sample_layers_test.h"

namespace slicefarm::exposure::dxf_writer_test {
namespace {

struct Entity {
  std::string type;
  std::map<int, std::string> values;

  Point At(int code) const {
    return {FromMm(std::stod(values.at(code))), FromMm(std::stod(values.at(code + 10)))};
  }
};

std::vector<Entity> Read(const std::string& file) {
  std::vector<Entity> entities;
  std::istringstream stream(file);
  for (std::string code, value; std::getline(stream, code) && std::getline(stream, value);) {
    if (code == "0")
      entities.push_back({value, {}});
    else
      entities.back().values[std::stoi(code)] = value;
  }
  return entities;
}

TEST(DxfWriter, TheLayerAskedForIsReadBack) {
  FileFacts facts = SampleFacts(OutputFormat::kDxf);
  facts.output.layer = 1;
  std::string file = FileHeader(facts);
  for (const ExposedLayer& layer : SampleLayers()) file += LayerText(layer, facts);
  file += FileFooter(facts);
  std::vector<std::vector<Point>> lines;
  std::vector<std::string> layers;
  bool closed = false;
  std::vector<std::string> others;
  for (const Entity& entity : Read(file)) {
    if (entity.type == "LINE") {
      lines.push_back({entity.At(10), entity.At(11)});
      layers.push_back(entity.values.at(8));
      EXPECT_EQ(entity.values.at(30), "0.1");
    } else if (entity.type == "POLYLINE") {
      lines.emplace_back();
      layers.push_back(entity.values.at(8));
      closed = entity.values.at(70) == "1";
    } else if (entity.type == "VERTEX") {
      lines.back().push_back(entity.At(10));
    } else if (entity.type == "SEQEND") {
      if (closed) lines.back().push_back(lines.back().front());
    } else {
      others.push_back(entity.type);
    }
  }
  EXPECT_EQ(others, (std::vector<std::string>{"SECTION", "ENDSEC", "SECTION", "ENDSEC", "EOF"}));
  const std::vector<PlateLine> expected = PlateLines(SampleLayers()[1]);
  ASSERT_EQ(lines.size(), expected.size());
  for (size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i], expected[i].points);
  EXPECT_EQ(layers[0], "CONTOUR");
  EXPECT_EQ(layers[2], "HATCH");
  EXPECT_EQ(layers[4], "THIN_WALL");
}

}  // namespace
}  // namespace slicefarm::exposure::dxf_writer_test
