#include "services/exposure/algo/writers/writers.h"

#include "services/exposure/algo/writers/cli_writer.h"
#include "services/exposure/algo/writers/dxf_writer.h"
#include "services/exposure/algo/writers/laser_gcode.h"
#include "services/exposure/algo/writers/svg_writer.h"

namespace slicefarm::exposure {
namespace {

struct Writer {
  std::string (*header)(const FileFacts&);
  std::string (*layer)(const ExposedLayer&, const FileFacts&);
  std::string (*footer)(const FileFacts&);
};

Writer WriterOf(OutputFormat format) {
  switch (format) {
    case OutputFormat::kCliAscii:
    case OutputFormat::kCliBinary:
      return {CliHeader, CliLayer, CliFooter};
    case OutputFormat::kGrbl:
    case OutputFormat::kMarlin:
      return {LaserGcodeHeader, LaserGcodeLayer, LaserGcodeFooter};
    case OutputFormat::kSvg:
      return {SvgHeader, SvgLayer, SvgFooter};
    case OutputFormat::kDxf:
      break;
  }
  return {DxfHeader, DxfLayer, DxfFooter};
}

}  // namespace

std::string FileHeader(const FileFacts& facts) {
  return WriterOf(facts.output.format).header(facts);
}
bool HasLayerHeads(OutputFormat format) {
  return format == OutputFormat::kGrbl || format == OutputFormat::kMarlin;
}
std::string LayerHead(const LayerFrame& layer, const LayerCode& code) {
  return LaserGcodeLayerHead(layer, code);
}
std::string LayerText(const ExposedLayer& layer, const FileFacts& facts) {
  return WriterOf(facts.output.format).layer(layer, facts);
}
std::string FileFooter(const FileFacts& facts) {
  return WriterOf(facts.output.format).footer(facts);
}

}  // namespace slicefarm::exposure
