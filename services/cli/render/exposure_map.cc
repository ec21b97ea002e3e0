#include "services/cli/render/exposure_map.h"

#include <cairo.h>

#include <memory>

namespace slicefarm::cli {
namespace {

/// What one pass adds to a pixel of 255 levels.
constexpr double kLevels = 17;

struct Release {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

/// One stroke a run: where a run crosses itself it counts once.
void AddRuns(cairo_t* cairo, const GcodeLayer& layer, const Layout& layout) {
  cairo_scale(cairo, layout.px_per_mm, -layout.px_per_mm);
  cairo_translate(cairo, -layout.left_mm, -layout.top_mm);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_operator(cairo, CAIRO_OPERATOR_ADD);
  cairo_set_source_rgba(cairo, 0, 0, 0, kLevels / 255);
  for (const BeadRun& run : layer.beads) {
    cairo_new_path(cairo);
    for (const PointMm& p : run.points) cairo_line_to(cairo, p.x, p.y);
    cairo_set_line_width(cairo, run.width_mm);
    cairo_stroke(cairo);
  }
}

}  // namespace

std::vector<double> ExposureMap(const GcodeLayer& layer, const Layout& layout) {
  const int width = layout.part_width_px;
  const int height = layout.height_px;
  const std::unique_ptr<cairo_surface_t, Release> surface(
      cairo_image_surface_create(CAIRO_FORMAT_A8, width, height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) return {};
  const std::unique_ptr<cairo_t, Release> cairo(cairo_create(surface.get()));
  AddRuns(cairo.get(), layer, layout);
  cairo_surface_flush(surface.get());
  const unsigned char* rows = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  std::vector<double> passes;
  passes.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) passes.push_back(rows[y * stride + x] / kLevels);
  return passes;
}

}  // namespace slicefarm::cli
