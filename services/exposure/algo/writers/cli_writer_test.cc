#include "services/exposure/algo/writers/cli_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "services/exposure/algo/writers/sample_layers_test.h"

namespace slicefarm::exposure::cli_writer_test {
namespace {

/// Content of a file as a reader gets it by the format's description. Positions are in mm.
struct ReadLine {
  int id = 0;
  int direction = -1;  ///< -1 for a hatch line
  std::vector<double> mm;
};
struct ReadFile {
  bool binary = false;
  double unit = 0;
  int layers = 0;
  std::map<int, std::string> labels;
  std::vector<double> dimension;
  std::vector<double> z_mm;
  std::vector<std::vector<ReadLine>> lines;  ///< lines of each layer
};

std::vector<double> Values(const std::string& text) {
  std::vector<double> values;
  std::stringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) values.push_back(std::stod(word));
  return values;
}

void AddHatches(int id, const std::vector<double>& places, double unit, ReadFile& file) {
  for (size_t i = 0; i + 3 < places.size(); i += 4)
    file.lines.back().push_back(
        {id,
         -1,
         {places[i] * unit, places[i + 1] * unit, places[i + 2] * unit, places[i + 3] * unit}});
}

/// Reads a header line. Returns false at the end of the header.
bool ReadHeaderLine(const std::string& line, ReadFile& file) {
  const size_t slash = line.find('/');
  const std::string key = line.substr(0, slash),
                    rest = slash == std::string::npos ? "" : line.substr(slash + 1);
  if (key == "$$BINARY") file.binary = true;
  if (key == "$$UNITS") file.unit = std::stod(rest);
  if (key == "$$LAYERS") file.layers = std::stoi(rest);
  if (key == "$$DIMENSION") file.dimension = Values(rest);
  if (key == "$$LABEL") file.labels[std::stoi(rest)] = rest.substr(rest.find(',') + 1);
  EXPECT_TRUE(key != "$$VERSION" || rest == "200");
  return key != "$$HEADEREND";
}

void ReadAscii(std::istringstream& stream, ReadFile& file) {
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "$$GEOMETRYSTART");
  while (std::getline(stream, line) && line != "$$GEOMETRYEND") {
    const size_t slash = line.find('/');
    ASSERT_NE(slash, std::string::npos) << line;
    const std::string key = line.substr(0, slash);
    std::vector<double> values = Values(line.substr(slash + 1));
    if (key == "$$LAYER") {
      ASSERT_EQ(values.size(), 1u);
      file.z_mm.push_back(values[0] * file.unit);
      file.lines.emplace_back();
    } else if (key == "$$POLYLINE") {
      ASSERT_EQ(values.size(), 3 + 2 * static_cast<size_t>(values[2])) << line;
      ReadLine read{static_cast<int>(values[0]),
                    static_cast<int>(values[1]),
                    {values.begin() + 3, values.end()}};
      for (double& value : read.mm) value *= file.unit;
      file.lines.back().push_back(read);
    } else {
      ASSERT_EQ(key, "$$HATCHES");
      ASSERT_EQ(values.size(), 2 + 4 * static_cast<size_t>(values[1])) << line;
      AddHatches(static_cast<int>(values[0]), {values.begin() + 2, values.end()}, file.unit, file);
    }
  }
  EXPECT_EQ(line, "$$GEOMETRYEND");
}

class Bytes {
 public:
  explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}
  bool AtEnd() const { return next_ == bytes_.size(); }
  template <typename T>
  T Take() {
    T value{};
    EXPECT_LE(next_ + sizeof(T), bytes_.size());
    if (next_ + sizeof(T) > bytes_.size()) return value;
    std::memcpy(&value, bytes_.data() + next_,
                sizeof(T));  // the test runs on little-endian machines
    next_ += sizeof(T);
    return value;
  }

 private:
  std::string bytes_;
  size_t next_ = 0;
};

void ReadBinary(std::string rest, ReadFile& file) {
  Bytes bytes(std::move(rest));
  while (!bytes.AtEnd() && !::testing::Test::HasFailure()) {
    const auto command = bytes.Take<uint16_t>();
    if (command == 127) {
      file.z_mm.push_back(bytes.Take<float>() * file.unit);
      file.lines.emplace_back();
    } else if (command == 130) {
      ReadLine line;
      line.id = bytes.Take<int32_t>();
      line.direction = bytes.Take<int32_t>();
      for (int32_t i = 2 * bytes.Take<int32_t>(); i > 0; --i)
        line.mm.push_back(bytes.Take<float>() * file.unit);
      file.lines.back().push_back(line);
    } else {
      ASSERT_EQ(command, 132);
      const auto id = bytes.Take<int32_t>();
      std::vector<double> places;
      for (int32_t i = 4 * bytes.Take<int32_t>(); i > 0; --i) places.push_back(bytes.Take<float>());
      AddHatches(id, places, file.unit, file);
    }
  }
}

ReadFile Read(const std::string& text) {
  ReadFile file;
  const std::string end = "$$HEADEREND";
  const size_t at = text.find(end);
  std::istringstream header(text.substr(0, at));
  std::string line;
  std::getline(header, line);
  EXPECT_EQ(line, "$$HEADERSTART");
  while (std::getline(header, line)) ReadHeaderLine(line, file);
  if (file.binary) {
    ReadBinary(text.substr(at + end.size()), file);
  } else {
    std::istringstream rest(text.substr(at + end.size() + 1));
    ReadAscii(rest, file);
  }
  return file;
}

TEST(CliWriter, IsReadBack) {
  for (const OutputFormat format : {OutputFormat::kCliAscii, OutputFormat::kCliBinary}) {
    const ReadFile file = Read(SampleFile(format));
    EXPECT_EQ(file.binary, format == OutputFormat::kCliBinary);
    EXPECT_EQ(file.unit, 0.001);
    EXPECT_EQ(file.layers, 2);
    EXPECT_EQ(file.dimension, (std::vector<double>{-5, -7.1, 0, 30, 6.0005, 0.1}));
    EXPECT_EQ(file.labels.size(), 20u);
    EXPECT_EQ(file.labels.at(2), "hatch 200 W 1200 mm/s part bracket.stl");
    EXPECT_EQ(file.labels.at(20), "thin wall 50 W 300.5 mm/s part a_b__c");
    ASSERT_EQ(file.lines.size(), 2u);
    const std::vector<ExposedLayer> layers = SampleLayers();
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(file.z_mm[i], 0.05 * static_cast<double>(i + 1), 1e-9);
      const std::vector<PlateLine> expected = PlateLines(layers[i]);
      ASSERT_EQ(file.lines[i].size(), expected.size());
      for (size_t k = 0; k < expected.size(); ++k) {
        const ReadLine& line = file.lines[i][k];
        EXPECT_EQ(line.id, 5 * (2 * expected[k].object + expected[k].settings) +
                               static_cast<int>(expected[k].kind) + 1);
        EXPECT_TRUE(file.labels.contains(line.id));
        ASSERT_EQ(line.mm.size(), 2 * expected[k].points.size());
        // The tolerance is 24 bits of 30 mm in a float, or a thousandth of a unit in text.
        for (size_t p = 0; p < expected[k].points.size(); ++p) {
          EXPECT_NEAR(line.mm[2 * p], ToMm(static_cast<double>(expected[k].points[p].x)), 2e-6);
          EXPECT_NEAR(line.mm[2 * p + 1], ToMm(static_cast<double>(expected[k].points[p].y)), 2e-6);
        }
      }
      // There is one contour in each direction; the thin wall is open.
      EXPECT_EQ(file.lines[i][0].direction, 1);
      EXPECT_EQ(file.lines[i][1].direction, 0);
      EXPECT_EQ(file.lines[i][2].direction, -1);
      EXPECT_EQ(file.lines[i][4].direction, 2);
    }
  }
}

TEST(CliWriter, APartThatIsAloneNeedsNoName) {
  FileFacts facts = SampleFacts(OutputFormat::kCliAscii);
  facts.object_names = facts.object_names.first(1);
  const ReadFile file = Read(FileHeader(facts) + FileFooter(facts));
  EXPECT_EQ(file.labels.size(), 10u);
  EXPECT_EQ(file.labels.at(2), "hatch 200 W 1200 mm/s");
}

/// Far from the origin, binary numbers are 8 nm apart: slivers may be reversed or lose their area.
TEST(CliWriter, DirectionsAreThoseOfTheNumbersInTheFile) {
  for (const OutputFormat format : {OutputFormat::kCliBinary, OutputFormat::kCliAscii}) {
    FileFacts facts = SampleFacts(format);
    facts.output.unit_mm = format == OutputFormat::kCliAscii ? 0.01 : 0.001;
    ExposedLayer layer = SampleLayers()[0];
    layer.groups.resize(1);
    layer.visits = {{0, 0, {94'000'000, 101'000'000}}};
    ExposureGroup& group = layer.groups[0];
    group = {};
    group.kind = ExposureKind::kContour;
    for (Coord k = 0; k < 60; ++k)
      group.AddLine(Polyline{{0, 0}, {1'000'003 + k, 3 * k}, {2'000'006, 7 * (k % 13)}, {0, 0}});
    facts.layers = 1;
    const ReadFile file = Read(FileHeader(facts) + LayerText(layer, facts) + FileFooter(facts));
    ASSERT_EQ(file.lines[0].size(), 60u);
    std::map<int, int> counts;
    for (const ReadLine& line : file.lines[0]) {
      double area = 0;
      for (size_t i = 2; i + 3 < line.mm.size(); i += 2)
        area += (line.mm[i] - line.mm[0]) * (line.mm[i + 3] - line.mm[1]) -
                (line.mm[i + 2] - line.mm[0]) * (line.mm[i + 1] - line.mm[1]);
      ++counts[line.direction];
      const int direction = std::abs(area) < 1e-11 ? 2 : area > 0;
      EXPECT_EQ(line.direction, direction) << area;
    }
    EXPECT_GT(counts[0], 0);
    EXPECT_GT(counts[1], 0);
  }
}

TEST(CliWriter, TextIsExactToANanometre) {
  const std::string file = SampleFile(OutputFormat::kCliAscii);
  EXPECT_NE(file.find("$$HATCHES/2,2,1000.001,80,9000,80,9000,160,1234.567,160\n"),
            std::string::npos);
  EXPECT_NE(file.find("$$LAYER/50\n"), std::string::npos);
}

TEST(CliWriter, OtherUnits) {
  FileFacts facts = SampleFacts(OutputFormat::kCliAscii);
  facts.output.unit_mm = 0.0254;
  std::string text = FileHeader(facts);
  for (const ExposedLayer& layer : SampleLayers()) text += LayerText(layer, facts);
  const ReadFile file = Read(text + FileFooter(facts));
  EXPECT_EQ(file.unit, 0.0254);
  EXPECT_NEAR(file.lines[0][0].mm[2], 10, 2e-5);
}

}  // namespace
}  // namespace slicefarm::exposure::cli_writer_test
