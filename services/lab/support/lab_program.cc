#include "services/lab/support/lab_program.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::lab {
namespace {

using planning::SupportRole;

constexpr double kFilamentMm2 = 1.75 * 1.75 * std::numbers::pi / 4;

/// Writes beads, layer height by layer height.
class Writer {
 public:
  void Height(Coord top_nm, Coord height_nm) {
    height_mm_ = ToMm(static_cast<double>(height_nm));
    Append(
        fmt::format(";HEIGHT:{:.5f}\nG1 Z{:.5f}\n", height_mm_, ToMm(static_cast<double>(top_nm))));
  }
  void Type(std::string_view type) { Append(fmt::format(";TYPE:{}\n", type)); }

  void Loops(const MultiPolygon& region, double width_mm) {
    ForEachRing(region, [&](const Polygon& ring) {
      Go(ring.back());
      for (const Point p : ring) Lay(p, width_mm);
    });
  }

  void Line(Point a, Point b, double width_mm) {
    Go(a);
    Lay(b, width_mm);
  }

  std::string Text() const { return fmt::to_string(text_); }

 private:
  void Append(std::string_view text) { text_.append(text.data(), text.data() + text.size()); }
  void Go(Point p) {
    Append(fmt::format("G0 X{:.4f} Y{:.4f}\n", ToMm(p.x), ToMm(p.y)));
    at_ = p;
  }
  void Lay(Point p, double width_mm) {
    const double section = height_mm_ * (width_mm - height_mm_ * (1 - std::numbers::pi / 4));
    const double volume = section * ToMm(Distance(at_, p));
    Append(
        fmt::format("G1 X{:.4f} Y{:.4f} E{:.6f}\n", ToMm(p.x), ToMm(p.y), volume / kFilamentMm2));
    at_ = p;
  }

  fmt::memory_buffer text_;
  double height_mm_ = 0.2;
  Point at_;
};

/// Writes horizontal or vertical lines inside the region, `pitch_nm` apart.
void Hatch(const MultiPolygon& region, Coord pitch_nm, double width_mm, bool upright,
           Writer& writer) {
  std::map<Coord, std::vector<Coord>> crossings;
  const auto turned = [&](Point p) { return upright ? Point{p.y, p.x} : p; };
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      Point a = turned(ring[i]), b = turned(ring[(i + 1) % ring.size()]);
      if (a.y > b.y) std::swap(a, b);
      const Coord first = a.y / pitch_nm - 1;
      for (Coord row = first; row * pitch_nm < b.y; ++row) {
        const Coord y = row * pitch_nm;
        if (y < a.y) continue;
        crossings[y].push_back(
            a.x + std::llround(static_cast<double>(b.x - a.x) * static_cast<double>(y - a.y) /
                               static_cast<double>(b.y - a.y)));
      }
    }
  });
  for (auto& [y, xs] : crossings) {
    std::sort(xs.begin(), xs.end());
    for (size_t k = 0; k + 1 < xs.size(); k += 2)
      writer.Line(turned({xs[k], y}), turned({xs[k + 1], y}), width_mm);
  }
}

/// Writes `count` loops along the region's boundary, from the outside in. Returns the region inside
/// the loops.
MultiPolygon Loops(MultiPolygon region, int count, Coord width_nm, Writer& writer) {
  for (int i = 0; i < count; ++i) {
    writer.Loops(FastOffset(region, -width_nm / 2), ToMm(static_cast<double>(width_nm)));
    region = FastOffset(region, -width_nm);
  }
  return region;
}

void Support(const planning::SupportLayer& layer, const LabBeads& beads, Writer& writer) {
  writer.Height(layer.top_nm, layer.height_nm);
  const double width_mm = ToMm(static_cast<double>(beads.support_width_nm));
  for (const planning::SupportRegion& region : layer.regions) {
    const bool interface =
        region.role == SupportRole::kTopInterface || region.role == SupportRole::kBottomInterface;
    const bool branch =
        region.role == SupportRole::kBranch || region.role == SupportRole::kThickBranch;
    writer.Type(interface ? "Support material interface" : "Support material");
    const int loops = region.role == SupportRole::kThickBranch ? 2 : 1;
    const MultiPolygon rest = Loops(region.outlines, loops, beads.support_width_nm, writer);
    if (interface || layer.first)
      Hatch(rest, beads.support_width_nm, width_mm, true, writer);  // across the lines of the base
    else if (!branch)
      Hatch(rest, beads.support_width_nm + beads.spacing_nm, width_mm, false, writer);
  }
}

}  // namespace

std::string LabProgram(const planning::SupportProblem& problem, const planning::SupportPlan& plan,
                       const LabBeads& beads) {
  Writer writer;
  size_t next = 0;
  const auto supports_up_to = [&](Coord top_nm) {
    for (; next < plan.layers.size() && plan.layers[next].top_nm < top_nm; ++next)
      Support(plan.layers[next], beads, writer);
  };
  for (const planning::PartLayer& layer : problem.part) {
    supports_up_to(layer.top_nm + 1);
    writer.Height(layer.top_nm, layer.height_nm);
    writer.Type("External perimeter");
    Loops(*layer.outlines, 1, beads.part_width_nm, writer);
  }
  supports_up_to(INT64_MAX);
  return "M83\n" + writer.Text();
}

}  // namespace slicefarm::lab
