#include "services/cli/render/exposure_map.h"

#include <algorithm>
#include <map>

#include "common/picture/cairo_picture.h"

namespace slicefarm::cli {
namespace {

/// Increase of a pixel's value per pass, with 255 as the largest value.
constexpr double kLevels = 17;

/// Draws each run as one stroke. A pixel that a run crosses several times counts once.
void AddRuns(cairo_t* cairo, const std::vector<const BeadRun*>& runs, const Layout& layout) {
  cairo_scale(cairo, layout.px_per_mm, -layout.px_per_mm);
  cairo_translate(cairo, -layout.left_mm, -layout.top_mm);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_operator(cairo, CAIRO_OPERATOR_ADD);
  cairo_set_source_rgba(cairo, 0, 0, 0, kLevels / 255);
  for (const BeadRun* run : runs) {
    cairo_new_path(cairo);
    for (const Vector2& p : run->points) cairo_line_to(cairo, p.x(), p.y());
    cairo_set_line_width(cairo, run->width_mm);
    cairo_stroke(cairo);
  }
}

/// Adds `amount` for each pass of the runs. Returns false if there is not enough memory.
bool AddPasses(const std::vector<const BeadRun*>& runs, const Layout& layout, double amount,
               std::vector<double>& values) {
  const int width = layout.part_width_px;
  const int height = layout.height_px;
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) return false;
  const CairoContext cairo(cairo_create(surface.get()));
  AddRuns(cairo.get(), runs, layout);
  cairo_surface_flush(surface.get());
  const unsigned char* rows = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  size_t pixel = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) values[pixel++] += amount * rows[y * stride + x] / kLevels;
  return true;
}

}  // namespace

double ExposureMap::Most() const {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

ExposureMap MapExposure(const GcodeLayer& layer, const Layout& layout) {
  ExposureMap map;
  const bool known = std::all_of(layer.beads.begin(), layer.beads.end(),
                                 [](const BeadRun& run) { return run.energy_j_mm > 0; });
  if (known) map.unit = "J/mm2";
  std::map<double, std::vector<const BeadRun*>> runs;  // runs by the dose of one pass
  for (const BeadRun& run : layer.beads)
    runs[known ? run.energy_j_mm / run.width_mm : 1].push_back(&run);
  map.values.resize(static_cast<size_t>(layout.part_width_px) *
                    static_cast<size_t>(layout.height_px));
  for (const auto& [amount, of_amount] : runs)
    if (!AddPasses(of_amount, layout, amount, map.values)) return {map.unit, {}};
  return map;
}

}  // namespace slicefarm::cli
