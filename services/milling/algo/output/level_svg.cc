#include "services/milling/algo/output/level_svg.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <iterator>

#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling {
namespace {

void AppendRing(const Polygon& ring, fmt::memory_buffer& text) {
  char word = 'M';
  for (const Point p : ring) {
    const Eigen::Vector2d place = PointMmOf(p);
    fmt::format_to(std::back_inserter(text), "{}{:.3f} {:.3f}", word, place.x(), -place.y());
    word = 'L';
  }
  text.push_back('Z');
}

}  // namespace

std::string LevelSvg(const MillingJob& job, const MilledStep& level) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  const Eigen::Vector3d low = job.stock_box.min(), size = job.stock_box.sizes();
  const double edge = 2 * job.options.cutter.radius_mm() + job.options.machining.clearance_mm;
  fmt::format_to(out,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.3f} {:.3f} {:.3f} "
                 "{:.3f}\" fill-rule=\"evenodd\" stroke-width=\"0.1\">\n",
                 low.x() - edge, -low.y() - size.y() - edge, size.x() + 2 * edge,
                 size.y() + 2 * edge);
  fmt::format_to(out,
                 "<rect x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\" "
                 "fill=\"#ddd\"/>\n",
                 low.x(), -low.y() - size.y(), size.x(), size.y());
  for (const CutArea& cut : level.areas) {
    text.append(std::string_view("<path fill=\"#bfd\" d=\""));
    AppendRing(cut.area.outer, text);
    for (const Polygon& hole : cut.area.holes) AppendRing(hole, text);
    text.append(std::string_view("\"/>\n"));
    for (size_t i = 0; i < cut.passes.size(); ++i) {
      const size_t red = 255 * (i + 1) / cut.passes.size();
      fmt::format_to(out, "<path fill=\"none\" stroke=\"rgb({},0,{})\" d=\"", red, 255 - red);
      AppendRing(cut.passes[i], text);
      text.append(std::string_view("\"/>\n"));
    }
  }
  for (const RestRun& run : level.runs) {
    text.append(std::string_view("<polyline fill=\"none\" stroke=\"#00f\" points=\""));
    for (const Eigen::Vector3d& p : run) fmt::format_to(out, "{:.3f},{:.3f} ", p.x(), -p.y());
    text.append(std::string_view("\"/>\n"));
  }
  text.append(std::string_view("</svg>\n"));
  return fmt::to_string(text);
}

}  // namespace slicefarm::milling
