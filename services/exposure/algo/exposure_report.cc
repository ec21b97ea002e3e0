#include "services/exposure/algo/exposure_report.h"

#include <cmath>
#include <iterator>

#include "common/geometry/measure.h"
#include "services/exposure/algo/scan/skywriting.h"

namespace slicefarm::exposure {
namespace {

constexpr double kMicro = 1e-6;

/// Sums the lengths and times of lines, and of the jumps between them.
class Counter {
 public:
  explicit Counter(ExposureReport& report) : report_(report) {}

  void AddLine(std::span<const Point> line, Point shift, const ExposureGroup& group,
               const ExposureOptions& options) {
    Jump(Beyond(line[1], line[0], group.run_nm) + shift, options.jump);
    KindExposure& kind = report_.kinds[static_cast<size_t>(group.kind)];
    const ExposureStyle& style = options.StyleOf(group.kind);
    const double length = ToMm(Length(line));
    kind.vectors += std::ssize(line) - 1;
    ++kind.lines;
    kind.length_mm += length;
    const double exposed = ExposedS(length, style);
    kind.energy_j += style.power_w * LaserOnS(length, style);
    kind.time_s +=
        exposed + static_cast<double>(line.size() - 2) * options.jump.polygon_delay_us * kMicro;
    if (group.run_nm > 0) {  // a run at full speed replaces the delay
      report_.jump_mm += 2 * ToMm(static_cast<double>(group.run_nm));
      report_.jump_time_s += 2 * ToMm(static_cast<double>(group.run_nm)) / style.speed_mm_s;
    } else {
      kind.time_s += options.jump.mark_delay_us * kMicro;
    }
    for (const Point p : line) report_.bounds.Add(p + shift);
    at_ = Beyond(line[line.size() - 2], line.back(), group.run_nm) + shift;
    started_ = true;
  }

 private:
  void Jump(Point to, const JumpOptions& jump) {
    if (started_ && at_ != to) {
      const double length = ToMm(Distance(at_, to));
      ++report_.jumps;
      report_.jump_mm += length;
      report_.jump_time_s += length / jump.speed_mm_s + jump.delay_us * kMicro;
    }
  }

  static double Points(double length_mm, const ExposureStyle& style) {
    return std::floor(length_mm / ToMm(static_cast<double>(style.point_distance_nm))) + 1;
  }
  static double ExposedS(double length_mm, const ExposureStyle& style) {
    if (style.point_distance_nm <= 0) return length_mm / style.speed_mm_s;
    return Points(length_mm, style) * (style.point_time_us + style.point_delay_us) * kMicro;
  }
  static double LaserOnS(double length_mm, const ExposureStyle& style) {
    if (style.point_distance_nm <= 0) return length_mm / style.speed_mm_s;
    return Points(length_mm, style) * style.point_time_us * kMicro;
  }

  ExposureReport& report_;
  bool started_ = false;
  Point at_;
};

}  // namespace

ExposureReport ReportOf(const ExposedLayer& layer, std::span<const ExposureOptions> regions) {
  ExposureReport report;
  report.cuts = layer.cuts;
  report.melted = layer.melted;
  report.area_mm2 = layer.area_mm2;
  report.volume_mm3 = layer.area_mm2 * ToMm(static_cast<double>(layer.frame.height_nm));
  Counter counter(report);
  for (const ExposureVisit& visit : layer.visits) {
    for (const ExposureGroup& group : layer.groups) {
      if (group.object != visit.object) continue;
      const ExposureOptions& options = regions[static_cast<size_t>(group.settings)];
      group.ForEachLine(
          [&](std::span<const Point> line) { counter.AddLine(line, visit.shift, group, options); });
    }
  }
  return report;
}

}  // namespace slicefarm::exposure
