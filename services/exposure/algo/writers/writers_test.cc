#include "services/exposure/algo/writers/writers.h"

#include <gtest/gtest.h>

#include <string>

#include "services/exposure/algo/writers/cli_writer.h"
#include "services/exposure/algo/writers/dxf_writer.h"
#include "services/exposure/algo/writers/laser_gcode.h"
#include "services/exposure/algo/writers/sample_layers_test.h"
#include "services/exposure/algo/writers/svg_writer.h"

namespace slicefarm::exposure::writers_test {
namespace {

struct Case {
  OutputFormat format;
  std::string (*header)(const FileFacts&);
  std::string (*layer)(const ExposedLayer&, const FileFacts&);
  std::string (*footer)(const FileFacts&);
  bool heads = false;
};

constexpr Case kCases[] = {
    {OutputFormat::kCliAscii, CliHeader, CliLayer, CliFooter},
    {OutputFormat::kCliBinary, CliHeader, CliLayer, CliFooter},
    {OutputFormat::kGrbl, LaserGcodeHeader, LaserGcodeLayer, LaserGcodeFooter, true},
    {OutputFormat::kMarlin, LaserGcodeHeader, LaserGcodeLayer, LaserGcodeFooter, true},
    {OutputFormat::kSvg, SvgHeader, SvgLayer, SvgFooter},
    {OutputFormat::kDxf, DxfHeader, DxfLayer, DxfFooter},
};

TEST(Writers, EachFormatHasItsOwn) {
  for (const Case& c : kCases) {
    SCOPED_TRACE(static_cast<int>(c.format));
    const FileFacts facts = SampleFacts(c.format);
    EXPECT_FALSE(FileHeader(facts).empty());
    EXPECT_EQ(FileHeader(facts), c.header(facts));
    EXPECT_EQ(LayerText(SampleLayers()[0], facts), c.layer(SampleLayers()[0], facts));
    EXPECT_EQ(FileFooter(facts), c.footer(facts));
    EXPECT_EQ(HasLayerHeads(c.format), c.heads);
  }
}

}  // namespace
}  // namespace slicefarm::exposure::writers_test
