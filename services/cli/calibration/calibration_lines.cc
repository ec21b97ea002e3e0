#include "services/cli/calibration/calibration_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "common/model/bead_section.h"
#include "services/cli/calibration/solid_builder.h"

namespace slicefarm::cli {
namespace {

using PointMm = std::array<double, 2>;

constexpr double kPitchMm = 5;                ///< distance of the lines of neighbouring values
constexpr double kSlowMm = 20, kFastMm = 40;  ///< lengths of the parts of a straight line
constexpr double kCornerMm = 21;              ///< depth of a corner; half of its width
constexpr double kLineMarginMm = 3;           ///< gap between the lines and the frame
constexpr double kFrameMm = 2;                ///< width of the frame
constexpr double kTextMm = 3, kTextMarginMm = 1.5;

/// Part of a line, to a point, at a speed in mm/s.
struct DrawnPart {
  PointMm to;
  double speed;
};

/// Writer of the lines of one layer.
class LineWriter {
 public:
  LineWriter(const LineSettings& settings, double height_mm)
      : settings_(settings),
        filament_per_mm_(SectionMm2(FromMm(settings.width_mm), FromMm(height_mm)) * settings.flow /
                         settings.filament_mm2) {}

  void Line(const std::string& text) { out_ += text + "\n"; }

  void Draw(PointMm from, std::span<const DrawnPart> parts) {
    Line(fmt::format("G1 X{:.3f} Y{:.3f} F{:.0f}", from[0], from[1], PerMinute(settings_.travel)));
    Filament(settings_.retract_mm, settings_.restart_speed);
    for (const DrawnPart& part : parts) {
      const double length = std::hypot(part.to[0] - from[0], part.to[1] - from[1]);
      from = part.to;
      Line(fmt::format("G1 X{:.3f} Y{:.3f} E{:.5f} F{:.0f}", from[0], from[1],
                       length * filament_per_mm_, PerMinute(part.speed)));
    }
    Filament(-settings_.retract_mm, settings_.retract_speed);
  }

  std::string Take() && {
    out_.pop_back();
    return std::move(out_);
  }

 private:
  static double PerMinute(double mm_s) { return mm_s * 60; }

  void Filament(double mm, double speed) {
    if (mm != 0) Line(fmt::format("G1 E{:g} F{:.0f}", mm, PerMinute(speed)));
  }

  const LineSettings& settings_;
  const double filament_per_mm_;
  std::string out_;
};

/// Geometry of a print. Coordinates begin at the lower left corner of the frame.
class LineLayout {
 public:
  LineLayout(LineShape shape, const std::vector<ValueLine>& lines, const LineSettings& settings)
      : shape_(shape), lines_(lines), settings_(settings) {
    for (const ValueLine& line : lines)
      text_mm_ = std::max(text_mm_, static_cast<double>(TextWidth(line.label, kTextMm)));
  }

  LinePrint Make() const {
    LinePrint print;
    const int layers = shape_ == LineShape::kCorner ? kCornerLayers : 1;
    print.stl = Solid();
    for (int i = 0; i < layers; ++i) print.codes.push_back(CodeOfLayer(i));
    return print;
  }

 private:
  double LineMm() const {
    return shape_ == LineShape::kCorner ? 2 * kCornerMm : 2 * kSlowMm + kFastMm;
  }
  double Width() const {
    return 2 * kFrameMm + 2 * kLineMarginMm + LineMm() + text_mm_ + 2 * kTextMarginMm;
  }
  /// Returns the distance of a value's line from the lower edge of the frame, along y.
  double RowY(size_t i) const {
    return kFrameMm + kLineMarginMm + (shape_ == LineShape::kCorner ? kCornerMm : 0) +
           static_cast<double>(i) * kPitchMm;
  }
  double Depth() const { return RowY(lines_.size() - 1) + kLineMarginMm + kFrameMm; }
  /// Converts coordinates of the frame to coordinates of the bed.
  PointMm OnBed(double x, double y) const {
    return {settings_.middle[0] - Width() / 2 + x, settings_.middle[1] - Depth() / 2 + y};
  }

  /// Returns the height of the frame: that of the corners, and more than the depth of the labels.
  double FrameTop() const {
    constexpr double kLeastMm = 0.35;
    double top_mm = settings_.first_layer_mm;
    if (shape_ == LineShape::kCorner) top_mm += (kCornerLayers - 1) * settings_.layer_mm;
    while (top_mm < kLeastMm) top_mm += settings_.layer_mm;
    return top_mm;
  }

  /// Returns the frame, the plate and the labels on it.
  std::string Solid() const {
    const auto width = static_cast<float>(Width()), depth = static_cast<float>(Depth());
    const auto top = static_cast<float>(FrameTop()), side = static_cast<float>(kFrameMm);
    const auto plate = static_cast<float>(Width() - kFrameMm - text_mm_ - 2 * kTextMarginMm);
    SolidBuilder solid;
    solid.AddBox({0, 0, 0}, {width, side, top});
    solid.AddBox({0, depth - side, 0}, {width, depth, top});
    solid.AddBox({0, 0, 0}, {side, depth, top});
    solid.AddBox({plate, 0, 0}, {width, depth, top});
    for (size_t i = 0; i < lines_.size(); ++i)
      solid.AddTextOnTop(lines_[i].label,
                         {plate + static_cast<float>(kTextMarginMm),
                          static_cast<float>(RowY(i) - kTextMm / 2), top},
                         kTextMm, 2 * static_cast<float>(settings_.layer_mm));
    return solid.Stl();
  }

  HeightCode CodeOfLayer(int layer) const {
    const double height = layer == 0 ? settings_.first_layer_mm : settings_.layer_mm;
    LineWriter out(settings_, height);
    for (size_t i = 0; i < lines_.size(); ++i) {
      out.Line(lines_[i].code);
      if (shape_ == LineShape::kCorner) {
        DrawCorners(RowY(i), out);
      } else {
        DrawStraight(RowY(i), out);
      }
    }
    if (!settings_.code_after.empty()) out.Line(settings_.code_after);
    constexpr double kAboveMm = 0.01;  // selects the first layer above the height
    const double below =
        layer == 0 ? 0 : settings_.first_layer_mm + (layer - 1) * settings_.layer_mm;
    return {FromMm(below + kAboveMm), HeightCodeKind::kCustom, std::move(out).Take()};
  }

  void DrawStraight(double y, LineWriter& out) const {
    const double x = kFrameMm + kLineMarginMm;
    const DrawnPart parts[] = {{OnBed(x + kSlowMm, y), settings_.slow},
                               {OnBed(x + kSlowMm + kFastMm, y), settings_.fast},
                               {OnBed(x + LineMm(), y), settings_.slow}};
    out.Draw(OnBed(x, y), parts);
  }

  /// Draws three lines beside each other. Their distance along y is that of lines at 45 degrees.
  void DrawCorners(double y, LineWriter& out) const {
    const double x = kFrameMm + kLineMarginMm;
    for (int i = 0; i < 3; ++i) {
      const double top = y - i * settings_.width_mm * std::numbers::sqrt2;
      const DrawnPart parts[] = {{OnBed(x + kCornerMm, top - kCornerMm), settings_.fast},
                                 {OnBed(x + LineMm(), top), settings_.fast}};
      out.Draw(OnBed(x, top), parts);
    }
  }

  const LineShape shape_;
  const std::vector<ValueLine>& lines_;
  const LineSettings& settings_;
  double text_mm_ = 0;
};

}  // namespace

LinePrint MakeLinePrint(LineShape shape, const std::vector<ValueLine>& lines,
                        const LineSettings& settings) {
  return LineLayout(shape, lines, settings).Make();
}

}  // namespace slicefarm::cli
