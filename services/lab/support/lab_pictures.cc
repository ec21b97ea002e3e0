#include "services/lab/support/lab_pictures.h"

#include <algorithm>

#include "common/geometry/measure.h"
#include "common/picture/cairo_picture.h"

namespace slicefarm::lab {
namespace {

using planning::SupportRole;

constexpr double kLongerSidePx = 1200;
constexpr double kEdgeMm = 3;

/// A picture of a rectangle of the plane; in mm, y upwards.
class LabCanvas {
 public:
  LabCanvas(double left, double bottom, double right, double top)
      : scale_(kLongerSidePx / std::max(right - left, top - bottom)),
        surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                            static_cast<int>((right - left) * scale_) + 1,
                                            static_cast<int>((top - bottom) * scale_) + 1)),
        cairo_(cairo_create(surface_.get())) {
    cairo_set_source_rgb(cairo_.get(), 1, 1, 1);
    cairo_paint(cairo_.get());
    cairo_scale(cairo_.get(), scale_, -scale_);
    cairo_translate(cairo_.get(), -left, -top);
    cairo_set_fill_rule(cairo_.get(), CAIRO_FILL_RULE_EVEN_ODD);
  }

  void Use(SupportRole role, double alpha) {
    switch (role) {
      case SupportRole::kBase:
        return cairo_set_source_rgba(cairo_.get(), 0.3, 0.65, 0.3, alpha);
      case SupportRole::kBranch:
        return cairo_set_source_rgba(cairo_.get(), 0.2, 0.55, 0.85, alpha);
      case SupportRole::kThickBranch:
        return cairo_set_source_rgba(cairo_.get(), 0.15, 0.25, 0.7, alpha);
      case SupportRole::kTopInterface:
        return cairo_set_source_rgba(cairo_.get(), 0.9, 0.4, 0.1, alpha);
      case SupportRole::kBottomInterface:
        return cairo_set_source_rgba(cairo_.get(), 0.75, 0.2, 0.6, alpha);
    }
  }
  void UseGrey(double alpha) { cairo_set_source_rgba(cairo_.get(), 0.6, 0.6, 0.6, alpha); }

  void Fill(const MultiPolygon& region) {
    ForEachRing(region, [&](const Polygon& ring) {
      cairo_new_sub_path(cairo_.get());
      for (const Point p : ring) cairo_line_to(cairo_.get(), ToMm(p.x), ToMm(p.y));
      cairo_close_path(cairo_.get());
    });
    cairo_fill(cairo_.get());
  }
  void FillBox(double left, double bottom, double right, double top) {
    cairo_rectangle(cairo_.get(), left, bottom, right - left, top - bottom);
    cairo_fill(cairo_.get());
  }

  absl::StatusOr<std::string> Png() { return PngOf(surface_.get()); }

 private:
  double scale_;
  CairoSurface surface_;
  CairoContext cairo_;
};

Box BoundsOfAll(const planning::SupportProblem& problem, const planning::SupportPlan& plan) {
  Box box;
  for (const planning::PartLayer& layer : problem.part) box.Add(Bounds(*layer.outlines));
  for (const planning::SupportLayer& layer : plan.layers)
    for (const planning::SupportRegion& region : layer.regions) box.Add(Bounds(region.outlines));
  return box;
}

}  // namespace

absl::StatusOr<std::string> DrawSupportLayer(const planning::SupportProblem& problem,
                                             const planning::SupportPlan& plan, size_t layer) {
  const Box box = BoundsOfAll(problem, plan);
  LabCanvas canvas(ToMm(box.min.x) - kEdgeMm, ToMm(box.min.y) - kEdgeMm, ToMm(box.max.x) + kEdgeMm,
                   ToMm(box.max.y) + kEdgeMm);
  const planning::SupportLayer& support = plan.layers[layer];
  const Coord middle = support.top_nm - support.height_nm / 2;
  for (const planning::PartLayer& part : problem.part) {
    if (part.top_nm <= middle || part.bottom_nm() > middle) continue;
    canvas.UseGrey(1);
    canvas.Fill(*part.outlines);
  }
  for (const planning::SupportRegion& region : support.regions) {
    canvas.Use(region.role, 1);
    canvas.Fill(region.outlines);
  }
  return canvas.Png();
}

absl::StatusOr<std::string> DrawSupportView(const planning::SupportProblem& problem,
                                            const planning::SupportPlan& plan, bool from_right) {
  const Box box = BoundsOfAll(problem, plan);
  const auto across = [&](Point p) { return ToMm(from_right ? p.y : p.x); };
  Coord top = 0;
  for (const planning::PartLayer& layer : problem.part) top = std::max(top, layer.top_nm);
  LabCanvas canvas(across(box.min) - kEdgeMm, -1, across(box.max) + kEdgeMm,
                   ToMm(static_cast<double>(top)) + 1);
  const auto draw = [&](const MultiPolygon& region, Coord bottom_nm, Coord top_nm) {
    for (const PolygonWithHoles& island : region) {
      const Box around = Bounds(island.outer);
      canvas.FillBox(across(around.min), ToMm(static_cast<double>(bottom_nm)), across(around.max),
                     ToMm(static_cast<double>(top_nm)));
    }
  };
  canvas.UseGrey(0.5);
  for (const planning::PartLayer& layer : problem.part)
    draw(*layer.outlines, layer.bottom_nm(), layer.top_nm);
  for (const planning::SupportLayer& layer : plan.layers) {
    for (const planning::SupportRegion& region : layer.regions) {
      canvas.Use(region.role, 0.5);
      draw(region.outlines, layer.top_nm - layer.height_nm, layer.top_nm);
    }
  }
  return canvas.Png();
}

}  // namespace slicefarm::lab
