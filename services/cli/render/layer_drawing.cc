#include "services/cli/render/layer_drawing.h"

#include <cairo-svg.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "common/picture/cairo_picture.h"
#include "services/cli/render/exposure_map.h"

namespace slicefarm::cli {
namespace {

constexpr int kLegendPx = 250;
constexpr int kMinHeightPx = 420;  // minimum for the legend
constexpr double kMarginMm = 2;
constexpr double kRim = 0.6;    // brightness of a bead's rim relative to its middle
constexpr double kCore = 0.86;  // share of a bead's width without the rims

constexpr std::pair<std::string_view, Colour> kFeatureColours[] = {
    {"External perimeter", {1.00, 0.49, 0.22}},
    {"Perimeter", {1.00, 0.90, 0.30}},
    {"Overhang perimeter", {0.12, 0.12, 1.00}},
    {"Gap fill", {0.80, 0.80, 0.80}},
    {"Internal infill", {0.69, 0.19, 0.16}},
    {"Solid infill", {0.59, 0.33, 0.80}},
    {"Top solid infill", {0.94, 0.25, 0.25}},
    {"Bridge infill", {0.30, 0.50, 0.73}},
    {"Skirt/Brim", {0.00, 0.53, 0.43}},
    {"Skirt", {0.00, 0.53, 0.43}},
    {"Support material", {0.20, 0.75, 0.20}},
    {"Ironing", {1.00, 0.55, 0.41}},
    {"Outer wall", {1.00, 0.49, 0.22}},
    {"Inner wall", {1.00, 0.90, 0.30}},
    {"Overhang wall", {0.12, 0.12, 1.00}},
    {"Gap infill", {0.80, 0.80, 0.80}},
    {"Sparse infill", {0.69, 0.19, 0.16}},
    {"Internal solid infill", {0.59, 0.33, 0.80}},
    {"Top surface", {0.94, 0.25, 0.25}},
    {"Bridge", {0.30, 0.50, 0.73}},
    {"Internal Bridge", {0.30, 0.50, 0.73}},
    {"Support", {0.20, 0.75, 0.20}},
    {"contour", {1.00, 0.49, 0.22}},
    {"hatch", {0.59, 0.33, 0.80}},
    {"upskin", {0.94, 0.25, 0.25}},
    {"downskin", {0.12, 0.12, 1.00}},
    {"thin wall", {0.20, 0.75, 0.20}},
    {"roughing", {0.30, 0.50, 0.73}},
    {"finishing", {1.00, 0.49, 0.22}},
    {"rest areas", {0.20, 0.75, 0.20}},
};
constexpr Colour kUnknownColour = {0.5, 0.5, 0.5};

/// Quantity shown by a scale of colours.
struct Quantity {
  std::string_view name;
  std::string_view unit;
  double (*of)(const BeadRun&);
};

Quantity QuantityOf(ColourBy by) {
  switch (by) {
    case ColourBy::kSpeed:
      return {"Speed", "mm/s", [](const BeadRun& bead) { return bead.speed_mm_s; }};
    case ColourBy::kFlow:
      return {"Flow", "mm3/s", [](const BeadRun& bead) { return bead.flow_mm3_s; }};
    case ColourBy::kTime:
      return {"Time", "s", [](const BeadRun& bead) { return bead.time_s; }};
    default:
      return {"Width", "mm", [](const BeadRun& bead) { return bead.width_mm; }};
  }
}

struct Range {
  double min = 0;
  double max = 0;

  double Fraction(double value) const { return max > min ? (value - min) / (max - min) : 0.5; }
};

Range RangeOf(const GcodeLayer& layer, const Quantity& quantity) {
  if (layer.beads.empty()) return {};
  const auto [least, most] = std::minmax_element(
      layer.beads.begin(), layer.beads.end(),
      [&](const BeadRun& a, const BeadRun& b) { return quantity.of(a) < quantity.of(b); });
  return {quantity.of(*least), quantity.of(*most)};
}

/// Paints one layer. Lengths in the part are in mm, and lengths in the legend are in pixels.
class Painter {
 public:
  Painter(cairo_t* cairo, const GcodeLayer& layer, const DrawingOptions& options,
          const Layout& layout)
      : cairo_(cairo),
        layer_(layer),
        options_(options),
        layout_(layout),
        quantity_(QuantityOf(options.colour_by)),
        range_(RangeOf(layer, quantity_)) {}

  void Paint() {
    Use({1, 1, 1});
    cairo_paint(cairo_);
    PaintPart();
    PaintLegend();
  }

 private:
  void Use(Colour colour) { cairo_set_source_rgb(cairo_, colour.red, colour.green, colour.blue); }

  Colour ColourOf(const BeadRun& bead) const {
    if (options_.colour_by == ColourBy::kFeature) return FeatureColour(bead.feature);
    if (options_.colour_by != ColourBy::kOrder)
      return ScaleColour(range_.Fraction(quantity_.of(bead)));
    const auto turn = static_cast<double>(&bead - layer_.beads.data());
    return ScaleColour(turn / std::max<double>(1, static_cast<double>(layer_.beads.size()) - 1));
  }

  void Trace(const std::vector<Vector2>& points) {
    cairo_new_path(cairo_);
    for (const Vector2& p : points) cairo_line_to(cairo_, p.x(), p.y());
  }

  void PaintEnergy() {
    const ExposureMap map = MapExposure(layer_, layout_);
    most_exposure_ = map.Most();
    exposure_unit_ = map.unit;
    size_t pixel = 0;
    for (int y = 0; y < layout_.height_px && !map.values.empty(); ++y) {
      for (int x = 0; x < layout_.part_width_px; ++x, ++pixel) {
        if (map.values[pixel] == 0) continue;
        Use(ScaleColour(map.values[pixel] / most_exposure_));
        cairo_rectangle(cairo_, x, y, 1, 1);
        cairo_fill(cairo_);
      }
    }
  }

  void PaintPart() {
    if (options_.colour_by == ColourBy::kEnergy) return PaintEnergy();
    cairo_save(cairo_);
    cairo_rectangle(cairo_, 0, 0, layout_.part_width_px, layout_.height_px);
    cairo_clip(cairo_);
    cairo_scale(cairo_, layout_.px_per_mm, -layout_.px_per_mm);
    cairo_translate(cairo_, -layout_.left_mm, -layout_.top_mm);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    for (const BeadRun& bead : layer_.beads) {
      const Colour colour = ColourOf(bead);
      Trace(bead.points);
      cairo_set_line_width(cairo_, bead.width_mm);
      Use(Mix({0, 0, 0}, colour, kRim));
      cairo_stroke_preserve(cairo_);
      cairo_set_line_width(cairo_, bead.width_mm * kCore);
      Use(colour);
      cairo_stroke(cairo_);
    }
    if (options_.travels) PaintTravels();
    cairo_restore(cairo_);
  }

  void PaintTravels() {
    Use({0, 0, 0});
    cairo_set_line_width(cairo_, 1 / layout_.px_per_mm);
    for (const auto& travel : layer_.travels) {
      Trace(travel);
      cairo_stroke(cairo_);
    }
  }

  void Text(double x, double y, double size, const std::string& text) {
    Use({0.1, 0.1, 0.1});
    cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, size);
    cairo_move_to(cairo_, x, y);
    cairo_show_text(cairo_, text.c_str());
  }

  void Swatch(double x, double y, Colour colour) {
    constexpr double kSide = 14;
    cairo_rectangle(cairo_, x, y - kSide + 2, kSide, kSide);
    Use(colour);
    cairo_fill(cairo_);
  }

  void PaintLegend() {
    const double x = layout_.part_width_px + 16;
    double y = 34;
    Text(x, y, 20, fmt::format("Layer {} (0 to {})", layer_.index, layer_.layer_count - 1));
    Text(x, y += 24, 13,
         fmt::format("z {:.2f} mm, height {:.2f} mm", layer_.z_mm, layer_.height_mm));
    y += 16;
    switch (options_.colour_by) {
      case ColourBy::kFeature:
        y = PaintFeatures(x, y);
        break;
      case ColourBy::kOrder:
        y = PaintSteps(x, y, "Number of the line", 1, static_cast<double>(layer_.beads.size()));
        break;
      case ColourBy::kEnergy:
        y = PaintSteps(x, y, fmt::format("Exposure, {}", exposure_unit_), 0, most_exposure_);
        break;
      default:
        y = PaintSteps(x, y, fmt::format("{} of the beads, {}", quantity_.name, quantity_.unit),
                       range_.min, range_.max);
    }
    PaintScale(x, y + 44);
  }

  double PaintFeatures(double x, double y) {
    std::vector<std::string_view> present;
    for (const BeadRun& bead : layer_.beads) {
      if (std::find(present.begin(), present.end(), bead.feature) == present.end()) {
        present.push_back(bead.feature);
      }
    }
    std::sort(present.begin(), present.end());
    for (const std::string_view feature : present) {
      y += 22;
      Swatch(x, y, FeatureColour(feature));
      Text(x + 22, y, 13, std::string(feature));
    }
    return y;
  }

  double PaintSteps(double x, double y, const std::string& title, double min, double max) {
    constexpr int kSteps = 5;
    Text(x, y += 20, 13, title);
    for (int i = 0; i < kSteps; ++i) {
      const double fraction = static_cast<double>(i) / (kSteps - 1);
      y += 22;
      Swatch(x, y, ScaleColour(max > min ? fraction : 0.5));
      Text(x + 22, y, 13, fmt::format("{:.3f}", min + fraction * (max - min)));
      if (max == min) break;
    }
    return y;
  }

  /// Paints a bar of a round length, at most as long as the legend is wide.
  void PaintScale(double x, double y) {
    const double room_mm = (kLegendPx - 40) / layout_.px_per_mm;
    double length_mm = std::pow(10, std::floor(std::log10(room_mm)));
    if (length_mm * 5 <= room_mm) {
      length_mm *= 5;
    } else if (length_mm * 2 <= room_mm) {
      length_mm *= 2;
    }
    Use({0.1, 0.1, 0.1});
    cairo_rectangle(cairo_, x, y, length_mm * layout_.px_per_mm, 4);
    cairo_fill(cairo_);
    Text(x, y + 22, 13, fmt::format("{:g} mm", length_mm));
  }

  cairo_t* cairo_;
  const GcodeLayer& layer_;
  const DrawingOptions& options_;
  const Layout& layout_;
  Quantity quantity_;
  Range range_;
  double most_exposure_ = 0;
  std::string_view exposure_unit_;
};

}  // namespace

Colour FeatureColour(std::string_view feature) {
  for (const auto& [name, colour] : kFeatureColours) {
    if (name == feature) return colour;
  }
  return kUnknownColour;
}

Layout LayOut(const GcodeLayer& layer, const DrawingOptions& options) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Vector2 min = {kFar, kFar};
  Vector2 max = {-kFar, -kFar};
  for (const BeadRun& bead : layer.beads) {
    const double reach = bead.width_mm / 2 + kMarginMm;
    for (const Vector2& p : bead.points) {
      min = min.cwiseMin(p - Vector2::Constant(reach));
      max = max.cwiseMax(p + Vector2::Constant(reach));
    }
  }
  if (layer.beads.empty()) {
    min = {0, 0};
    max = {10, 10};
  }
  Layout layout;
  layout.left_mm = min.x();
  layout.top_mm = max.y();
  layout.px_per_mm = options.size_px / std::max(max.x() - min.x(), max.y() - min.y());
  layout.part_width_px = static_cast<int>(std::ceil((max.x() - min.x()) * layout.px_per_mm));
  layout.width_px = layout.part_width_px + kLegendPx;
  layout.height_px =
      std::max(kMinHeightPx, static_cast<int>(std::ceil((max.y() - min.y()) * layout.px_per_mm)));
  return layout;
}

absl::StatusOr<std::string> DrawLayer(const GcodeLayer& layer, const DrawingOptions& options) {
  const Layout layout = LayOut(layer, options);
  std::string bytes;
  const bool svg = options.format == ImageFormat::kSvg;
  const CairoSurface surface(
      svg ? cairo_svg_surface_create_for_stream(AppendToString, &bytes, layout.width_px,
                                                layout.height_px)
          : cairo_image_surface_create(CAIRO_FORMAT_RGB24, layout.width_px, layout.height_px));
  {
    const CairoContext cairo(cairo_create(surface.get()));
    Painter(cairo.get(), layer, options, layout).Paint();
    const cairo_status_t status = cairo_status(cairo.get());
    if (status != CAIRO_STATUS_SUCCESS) return absl::InternalError(cairo_status_to_string(status));
  }
  if (!svg) return PngOf(surface.get());
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) return absl::InternalError(cairo_status_to_string(status));
  return bytes;
}

}  // namespace slicefarm::cli
