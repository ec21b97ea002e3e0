#include "tests/load/generator/algo/latency_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "common/geometry/polygon.h"

namespace slicefarm::load {
namespace {

constexpr double kWidth = 720, kHeight = 440;
constexpr double kLeft = 80, kRight = 620, kTop = 50, kBottom = 370;

struct Line {
  std::string_view name;
  std::string_view color;
  double percent;
};

// Colours of Okabe and Ito, which colour-blind people can distinguish.
constexpr std::array kLines = {Line{"p50", "#009e73", 50}, Line{"p90", "#56b4e9", 90},
                               Line{"p99", "#0072b2", 99}, Line{"p99.9", "#e69f00", 99.9},
                               Line{"max", "#d55e00", 100}};

double LoadOf(const RunReport& run) {
  return run.open_loop() ? run.intended_rps : run.AchievedRps();
}

double LatencyMs(const RunReport& run, const Line& line) {
  return static_cast<double>(run.record.latency.PercentileNs(line.percent)) / 1e6;
}

/// Scale of the plot: loads from 0 on, and latencies in whole powers of ten around the values.
struct Scale {
  double max_rps = 1;
  int low_decade = 0;
  int high_decade = 1;

  double X(double rps) const { return kLeft + (kRight - kLeft) * rps / max_rps; }
  double Y(double ms) const {
    const double share = (std::log10(std::max(ms, 1e-6)) - low_decade) / (high_decade - low_decade);
    return kBottom - (kBottom - kTop) * std::clamp(share, 0.0, 1.0);
  }
};

Scale ScaleOf(const std::vector<RunReport>& runs) {
  double rps = 0, least_ms = INFINITY, most_ms = 0;
  for (const RunReport& run : runs) {
    rps = std::max(rps, LoadOf(run));
    if (run.record.latency.count() == 0) continue;
    least_ms = std::min(least_ms, LatencyMs(run, kLines.front()));
    most_ms = std::max(most_ms, LatencyMs(run, kLines.back()));
  }
  Scale scale;
  if (rps > 0) scale.max_rps = rps * 1.05;
  if (most_ms <= 0) return scale;
  scale.low_decade = static_cast<int>(std::floor(std::log10(std::max(least_ms, 1e-6))));
  scale.high_decade =
      std::max(scale.low_decade + 1, static_cast<int>(std::ceil(std::log10(most_ms))));
  return scale;
}

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

class Drawing {
 public:
  Drawing() {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        kWidth, kHeight);
  }

  void Text(double x, double y, std::string_view anchor, std::string_view text,
            std::string_view color = "#333") {
    Append("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n", x, y,
           anchor, color, Escaped(text));
  }

  void Rule(double x1, double y1, double x2, double y2) {
    Append("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ddd\"/>\n", x1,
           y1, x2, y2);
  }

  void Dot(double x, double y, std::string_view color) {
    Append("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", x, y, color);
  }

  void Polyline(std::string_view points, std::string_view color) {
    Append("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", points,
           color);
  }

  std::string Take() { return std::move(text_) + "</svg>\n"; }

 private:
  template <typename... Args>
  void Append(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  std::string text_;
};

std::string LossText(const RunRecord& record) {
  if (record.arrivals == 0) return "no arrivals";
  const int64_t lost = record.arrivals - record.succeeded();
  if (lost == 0) return "";
  const double percent = 100.0 * static_cast<double>(lost) / static_cast<double>(record.arrivals);
  return fmt::format("{:.3g} % lost", percent);
}

void DrawAxes(const std::vector<RunReport>& runs, const Scale& scale, Drawing& drawing) {
  for (int decade = scale.low_decade; decade <= scale.high_decade; ++decade) {
    const double ms = std::pow(10, decade);
    drawing.Rule(kLeft, scale.Y(ms), kRight, scale.Y(ms));
    drawing.Text(kLeft - 8, scale.Y(ms) + 4, "end", fmt::format("{:g} ms", ms));
  }
  for (const RunReport& run : runs) {
    const double x = scale.X(LoadOf(run));
    drawing.Rule(x, kTop, x, kBottom);
    drawing.Text(x, kBottom + 18, "middle", fmt::format("{:g}", LoadOf(run)));
    drawing.Text(x, kBottom + 33, "middle", LossText(run.record), "#d55e00");
  }
  drawing.Text((kLeft + kRight) / 2, kBottom + 56, "middle", "requests per second");
}

void DrawLine(const std::vector<RunReport>& runs, const Scale& scale, const Line& line,
              Drawing& drawing) {
  std::string points;
  double y = kBottom;
  for (const RunReport& run : runs) {
    if (run.record.latency.count() == 0) continue;
    const double x = scale.X(LoadOf(run));
    y = scale.Y(LatencyMs(run, line));
    fmt::format_to(std::back_inserter(points), "{:.1f},{:.1f} ", x, y);
    drawing.Dot(x, y, line.color);
  }
  if (points.empty()) return;
  drawing.Polyline(points, line.color);
}

void DrawLegend(Drawing& drawing) {
  double y = kTop + 8;
  for (auto line = kLines.rbegin(); line != kLines.rend(); ++line, y += 20) {
    drawing.Dot(kRight + 24, y - 4, line->color);
    drawing.Text(kRight + 34, y, "start", line->name);
  }
}

std::string Title(const RunReport& run) {
  return fmt::format("{} ({}), {} loop, latency from the {} start", run.scenario, run.mix,
                     run.open_loop() ? "open" : "closed", run.open_loop() ? "intended" : "actual");
}

}  // namespace

std::string LatencyPlot(const std::vector<RunReport>& runs) {
  const Scale scale = ScaleOf(runs);
  Drawing drawing;
  if (!runs.empty()) drawing.Text(kLeft, 28, "start", Title(runs.front()));
  DrawAxes(runs, scale, drawing);
  for (const Line& line : kLines) DrawLine(runs, scale, line, drawing);
  DrawLegend(drawing);
  return drawing.Take();
}

}  // namespace slicefarm::load
