#include "services/exposure/algo/scan/melted_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/geometry/measure.h"
#include "services/exposure/algo/scan/exposed_seconds.h"
#include "services/exposure/algo/scan/layer_shift.h"
#include "services/exposure/algo/scan/scan_lines.h"

namespace slicefarm::exposure {
namespace {

constexpr int kProbes = 3;
constexpr double kPieceMm = 1;
/// Shortest part of a probe line for a measurement of energy per area. Shorter parts meet only
/// single vectors.
constexpr double kLeastPieceMm = 0.5;

/// Part of a probe line, from u0 to u1 in nm, that one vector melts.
struct Run {
  double u0 = 0, u1 = 0;
  double j_mm2 = 0;  ///< energy per area of a vector
};

/// Returns the part of the line at height v (parallel to the x axis) that is within `radius` of the
/// segment ab. The area around the segment is convex. Therefore this part is the union of the parts
/// in the discs around both ends and in the band between them.
Run RunOf(Point a, Point b, double v, double radius) {
  Run run{INFINITY, -INFINITY};
  const auto add = [&](double u0, double u1) {
    run.u0 = std::min(run.u0, u0);
    run.u1 = std::max(run.u1, u1);
  };
  const auto x = [](Point p) { return static_cast<double>(p.x); };
  const auto y = [](Point p) { return static_cast<double>(p.y); };
  for (const Point p : {a, b}) {
    const double up = v - y(p), left = radius * radius - up * up;
    if (left >= 0) add(x(p) - std::sqrt(left), x(p) + std::sqrt(left));
  }
  const double dx = x(b) - x(a), dy = y(b) - y(a), length = std::sqrt(dx * dx + dy * dy);
  if (length <= 0 || dy == 0) return run;
  for (const double side : {-1.0, 1.0}) {  // the band's long sides
    const double ox = -dy / length * radius * side, oy = dx / length * radius * side;
    const double t = (v - y(a) - oy) / dy;
    if (t >= 0 && t <= 1) add(x(a) + ox + t * dx, x(a) + ox + t * dx);
  }
  return run;
}

/// Evenly spaced probe lines across a region.
class Probes {
 public:
  Probes(const MultiPolygon& outline, int32_t layer) {
    const Box box = Bounds(outline);
    low_ = static_cast<double>(box.min.y);
    step_ = static_cast<double>(box.max.y - box.min.y) / kProbes;
    share_ = RingStart(layer + 1);  // not 0, which would be the border
    if (step_ <= 0) return;
    for (int i = 0; i < kProbes; ++i) {
      const auto inside =
          CutScanLines(outline, LineAxes::OfDegrees(0), {.pitch_nm = 1e18, .phase = V(i) / 1e18});
      if (!inside.ok()) continue;
      for (const ScanPiece& piece : *inside) inside_[At(i)].push_back({piece.u0, piece.u1});
    }
  }

  void Add(Point a, Point b, double radius, double j_mm2) {
    const auto low = static_cast<double>(std::min(a.y, b.y)),
               high = static_cast<double>(std::max(a.y, b.y));
    for (int i = 0; i < kProbes; ++i) {
      if (V(i) <= low - radius || V(i) >= high + radius || step_ <= 0) continue;
      Run run = RunOf(a, b, V(i), radius);
      run.j_mm2 = j_mm2;
      if (run.u0 < run.u1) melted_[At(i)].push_back(run);
    }
  }

  MeltedSample Sum() {
    MeltedSample sample;
    for (int i = 0; i < kProbes; ++i) {
      auto& melted = melted_[At(i)];
      std::sort(melted.begin(), melted.end(),
                [](const Run& a, const Run& b) { return a.u0 < b.u0; });
      for (const Run& run : inside_[At(i)]) AddRun(run, melted, sample);
    }
    return sample;
  }

 private:
  static size_t At(int probe) { return static_cast<size_t>(probe); }
  double V(int probe) const { return low_ + (probe + share_) * step_; }

  static void AddRun(const Run& inside, const std::vector<Run>& melted, MeltedSample& sample) {
    const double length = inside.u1 - inside.u0, mm = length / kNmPerMm;
    const auto pieces = static_cast<size_t>(std::max(1.0, std::floor(mm / kPieceMm)));
    const double piece = length / static_cast<double>(pieces);
    std::vector<double> energy(pieces);  // J/mm2 times nm
    double reached = inside.u0, covered = 0;
    for (const Run& run : melted) {
      const double u0 = std::max(run.u0, inside.u0), u1 = std::min(run.u1, inside.u1);
      if (u0 >= u1) continue;
      covered += std::max(0.0, u1 - std::max(u0, reached));
      reached = std::max(reached, u1);
      const auto first = static_cast<size_t>((u0 - inside.u0) / piece);
      for (size_t i = first; i < pieces; ++i) {
        const double begin = inside.u0 + static_cast<double>(i) * piece;
        if (begin >= u1) break;
        energy[i] += run.j_mm2 * (std::min(u1, begin + piece) - std::max(u0, begin));
      }
    }
    sample.length_mm += mm;
    sample.melted_mm += covered / kNmPerMm;
    for (const double e : energy) {
      sample.energy_j_mm += e / kNmPerMm;
      if (piece >= kLeastPieceMm * kNmPerMm) sample.AddPiece(e / piece);
    }
  }

  double low_ = 0, step_ = 0, share_ = 0;
  std::array<std::vector<Run>, kProbes> inside_, melted_;
};

}  // namespace

MeltedSample SampleMelted(std::span<const ExposureGroup> groups, const MultiPolygon& outline,
                          const ExposureOptions& options, int32_t layer) {
  if (outline.empty() || options.spot_nm <= 0) return {};
  Probes probes(outline, layer);
  const double radius = static_cast<double>(options.spot_nm) / 2;
  const double spot_mm = ToMm(static_cast<double>(options.spot_nm));
  for (const ExposureGroup& group : groups) {
    const ExposureStyle& style = options.StyleOf(group.kind);
    const double j_mm2 = style.power_w * LaserOnSecondsPerMm(style) / spot_mm;
    group.ForEachLine([&](std::span<const Point> line) {
      for (size_t i = 1; i < line.size(); ++i) probes.Add(line[i - 1], line[i], radius, j_mm2);
    });
  }
  return probes.Sum();
}

}  // namespace slicefarm::exposure
