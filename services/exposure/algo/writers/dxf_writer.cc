#include "services/exposure/algo/writers/dxf_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "common/base/decimal_text.h"

namespace slicefarm::exposure {
namespace {

/// Returns the kind's name in capitals with underscores, because R12 has no blanks in names.
std::string LayerName(ExposureKind kind) {
  std::string name(ExposureKindName(kind));
  std::replace(name.begin(), name.end(), ' ', '_');
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  });
  return name;
}

/// Appends a group code and its value, each on its own line.
void AppendPair(std::string& text, int code, std::string_view value) {
  text += fmt::format("{}\n{}\n", code, value);
}

/// Appends x with `code`, y with code + 10, z with code + 20.
void AppendPlace(std::string& text, int code, Point p, Coord z) {
  for (const Coord value : {p.x, p.y, z}) {
    text += fmt::format("{}\n", code);
    AppendMm(text, value, 6);
    text += '\n';
    code += 10;
  }
}

void AppendHatchLine(std::string& text, std::string_view layer, Point a, Point b, Coord z) {
  AppendPair(text, 0, "LINE");
  AppendPair(text, 8, layer);
  AppendPlace(text, 10, a, z);
  AppendPlace(text, 11, b, z);
}

void AppendPolyline(std::string& text, std::string_view layer, std::span<const Point> line,
                    Point shift, Coord z) {
  const bool closed = line.size() > 3 && line.front() == line.back();
  AppendPair(text, 0, "POLYLINE");
  AppendPair(text, 8, layer);
  AppendPair(text, 66, "1");  // vertices follow
  AppendPair(text, 70, closed ? "1" : "0");
  AppendPlace(text, 10, {}, z);
  for (const Point p : line.first(line.size() - (closed ? 1 : 0))) {
    AppendPair(text, 0, "VERTEX");
    AppendPair(text, 8, layer);
    AppendPlace(text, 10, p + shift, z);
  }
  AppendPair(text, 0, "SEQEND");
  AppendPair(text, 8, layer);
}

}  // namespace

std::string DxfHeader(const FileFacts& /*facts*/) {
  return "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
}

std::string DxfLayer(const ExposedLayer& layer, const FileFacts& facts) {
  std::string text;
  if (layer.frame.index != facts.output.layer) return text;
  const Coord z = layer.frame.print_z_nm;
  for (const ExposureVisit& visit : layer.visits) {
    for (const ExposureGroup& group : layer.groups) {
      if (group.object != visit.object) continue;
      const std::string name = LayerName(group.kind);
      group.ForEachLine([&](std::span<const Point> line) {
        if (line.size() == 2)
          AppendHatchLine(text, name, line[0] + visit.shift, line[1] + visit.shift, z);
        else
          AppendPolyline(text, name, line, visit.shift, z);
      });
    }
  }
  return text;
}

std::string DxfFooter(const FileFacts& /*facts*/) { return "0\nENDSEC\n0\nEOF\n"; }

}  // namespace slicefarm::exposure
