#include "services/exposure/algo/writers/svg_writer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "services/exposure/algo/writers/sample_layers_test.h"

namespace slicefarm::exposure::svg_writer_test {
namespace {

size_t Count(const std::string& text, const std::string& what) {
  size_t count = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(SvgWriter, TagsCloseAndLayersAreGroups) {
  const std::string file = SampleFile(OutputFormat::kSvg);
  EXPECT_EQ(Count(file, "<g "), 3u);
  EXPECT_EQ(Count(file, "</g>"), 3u);
  EXPECT_EQ(Count(file, "<path "), Count(file, "/>"));
  EXPECT_EQ(Count(file, "<path "), 10u);  // 2 layers of 2 copies of 2 groups and 1 of 1
  EXPECT_EQ(Count(file, "id=\"layer1\""), 1u);
  EXPECT_NE(file.find("viewBox=\"-6 -7.0005 37 15.1005\""), std::string::npos)
      << file.substr(0, 300);
  EXPECT_TRUE(file.ends_with("</svg>\n"));
}

TEST(SvgWriter, PathsAreReadBack) {
  std::vector<PlateLine> expected;
  for (const ExposedLayer& layer : SampleLayers())
    for (PlateLine& line : PlateLines(layer)) expected.push_back(std::move(line));
  const std::string file = SampleFile(OutputFormat::kSvg);
  size_t next = 0;
  for (size_t at = file.find(" d=\""); at != std::string::npos; at = file.find(" d=\"", at + 1)) {
    const char* text = file.c_str() + at + 4;
    std::vector<Point> line;
    const auto finish = [&] {
      if (line.empty()) return;
      ASSERT_LT(next, expected.size());
      EXPECT_EQ(line, expected[next++].points);
      line.clear();
    };
    while (*text != '"') {
      const char command = *text++;
      if (command == 'Z') {
        line.push_back(line.front());
        continue;
      }
      if (command == 'M') finish();
      char* end = nullptr;
      const double x = std::strtod(text, &end);
      const double y = std::strtod(end, &end);
      text = end;
      line.push_back({FromMm(x), FromMm(y)});
    }
    finish();
  }
  EXPECT_EQ(next, expected.size());
}

TEST(SvgWriter, OfNothing) {
  FileFacts facts = SampleFacts(OutputFormat::kSvg);
  facts.bounds = {};
  EXPECT_NE((FileHeader(facts) + FileFooter(facts)).find("viewBox=\"0 0 0 0\""), std::string::npos);
}

}  // namespace
}  // namespace slicefarm::exposure::svg_writer_test
