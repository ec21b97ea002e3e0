#include "services/exposure/algo/writers/svg_writer.h"

#include <fmt/core.h>

#include <array>

#include "common/base/decimal_text.h"

namespace slicefarm::exposure {
namespace {

/// Colour of each ExposureKind.
constexpr std::array<const char*, kExposureKindCount> kColours = {"#c02020", "#2050c0", "#20a040",
                                                                  "#e08020", "#802080"};

std::string Mm(Coord nm) {
  std::string text;
  AppendMm(text, nm, 6);
  return text;
}

void AppendPlace(std::string& text, char command, Point p) {
  text += command;
  AppendMm(text, p.x, 6);
  text += ' ';
  AppendMm(text, p.y, 6);
}

}  // namespace

std::string SvgHeader(const FileFacts& facts) {
  const Box box = facts.bounds.Empty() ? Box{{0, 0}, {0, 0}} : facts.bounds.Grown(kNmPerMm);
  const std::string width = Mm(box.max.x - box.min.x), height = Mm(box.max.y - box.min.y);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"{2} {3} {0} {1}\">\n"
      "<g transform=\"scale(1,-1)\" fill=\"none\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">\n",
      width, height, Mm(box.min.x), Mm(-box.max.y));
}

std::string SvgLayer(const ExposedLayer& layer, const FileFacts& facts) {
  std::string text = fmt::format("<g id=\"layer{}\" data-z=\"{}\">\n", layer.frame.index,
                                 Mm(layer.frame.print_z_nm));
  for (const ExposureVisit& visit : layer.visits) {
    for (const ExposureGroup& group : layer.groups) {
      if (group.object != visit.object) continue;
      const ExposureOptions& options = facts.regions[static_cast<size_t>(group.settings)];
      text += fmt::format("<path class=\"{}\" stroke=\"{}\" stroke-width=\"{}\" d=\"",
                          ExposureKindName(group.kind), kColours[static_cast<size_t>(group.kind)],
                          Mm(options.spot_nm));
      group.ForEachLine([&](std::span<const Point> line) {
        const bool closed = line.size() > 3 && line.front() == line.back();
        AppendPlace(text, 'M', line[0] + visit.shift);
        for (const Point p : line.subspan(1, line.size() - (closed ? 2 : 1)))
          AppendPlace(text, 'L', p + visit.shift);
        if (closed) text += 'Z';
      });
      text += "\"/>\n";
    }
  }
  return text + "</g>\n";
}

std::string SvgFooter(const FileFacts& /*facts*/) { return "</g>\n</svg>\n"; }

}  // namespace slicefarm::exposure
