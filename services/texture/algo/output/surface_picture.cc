#include "services/texture/algo/output/surface_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>

#include "common/picture/cairo_picture.h"
#include "common/picture/colour.h"

namespace slicefarm::texture {
namespace {

constexpr double kMarginPx = 20;

/// Canvas that converts mm of the picture's plane to pixels.
class Canvas {
 public:
  Canvas(const Eigen::Vector2d& low, const Eigen::Vector2d& high, int size_px)
      : low_(low), scale_((size_px - 2 * kMarginPx) / std::max((high - low).maxCoeff(), 1e-9)) {
    const Eigen::Vector2d size = scale_ * (high - low);
    height_ = size.y() + 2 * kMarginPx;
    surface_.reset(cairo_image_surface_create(
        CAIRO_FORMAT_RGB24, static_cast<int>(size.x() + 2 * kMarginPx), static_cast<int>(height_)));
    context_.reset(cairo_create(surface_.get()));
    cairo_set_source_rgb(context_.get(), 1, 1, 1);
    cairo_paint(context_.get());
    cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  }

  void Triangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                const Colour& colour) {
    cairo_t* context = context_.get();
    cairo_set_source_rgb(context, colour.red, colour.green, colour.blue);
    Go(cairo_move_to, a);
    Go(cairo_line_to, b);
    Go(cairo_line_to, c);
    cairo_close_path(context);
    cairo_fill_preserve(context);
    cairo_set_line_width(context, 0.6);  // otherwise the background shows between triangles
    cairo_stroke(context);
  }

  void Line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Colour& colour,
            double width_px) {
    cairo_set_source_rgb(context_.get(), colour.red, colour.green, colour.blue);
    cairo_set_line_width(context_.get(), width_px);
    Go(cairo_move_to, a);
    Go(cairo_line_to, b);
    cairo_stroke(context_.get());
  }

  absl::StatusOr<std::string> Png() { return PngOf(surface_.get()); }

 private:
  void Go(void (*step)(cairo_t*, double, double), const Eigen::Vector2d& p) {
    step(context_.get(), kMarginPx + scale_ * (p.x() - low_.x()),
         height_ - kMarginPx - scale_ * (p.y() - low_.y()));
  }

  Eigen::Vector2d low_;
  double scale_;
  double height_ = 0;
  CairoSurface surface_;
  CairoContext context_;
};

/// Returns the view matrix, with the rows right, up and towards the viewer.
Eigen::Matrix3d ViewOf(const Eigen::Vector3d& towards_viewer) {
  const Eigen::Vector3d back = towards_viewer.normalized();
  Eigen::Vector3d right = Eigen::Vector3d(0, 0, 1).cross(back);
  if (right.norm() < 1e-6) right = Eigen::Vector3d(1, 0, 0);
  right.normalize();
  Eigen::Matrix3d view;
  view << right.transpose(), back.cross(right).transpose(), back.transpose();
  return view;
}

}  // namespace

absl::StatusOr<std::string> DrawSurface(const SurfaceMesh& mesh, std::span<const PictureLine> lines,
                                        const SurfacePictureOptions& options) {
  const Eigen::Matrix3d view = ViewOf(options.towards_viewer);
  std::vector<Eigen::Vector3d> seen;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector3d& p : mesh.points_mm) {
    seen.push_back(view * p);
    low = low.cwiseMin(seen.back().head<2>());
    high = high.cwiseMax(seen.back().head<2>());
  }
  std::vector<size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto depth = [&](size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return seen[a].z() + seen[b].z() + seen[c].z();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return depth(a) < depth(b); });
  Canvas canvas(low, high, options.size_px);
  for (const size_t t : order) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double facing = (view * DoubleAreaVector(mesh, t).normalized()).z();
    const double grey = facing > 0 ? 0.45 + 0.4 * facing : 0.3 - 0.1 * facing;
    canvas.Triangle(seen[a].head<2>(), seen[b].head<2>(), seen[c].head<2>(), {grey, grey, grey});
  }
  for (const PictureLine& line : lines) {
    if ((view * line.normal).z() <= 0.05) continue;
    const Eigen::Vector3d from = view * line.from_mm, to = view * line.to_mm;
    canvas.Line(from.head<2>(), to.head<2>(), ScaleColour(line.shade), 1);
  }
  return canvas.Png();
}

absl::StatusOr<std::string> DrawMap(const SurfaceMesh& mesh,
                                    std::span<const Eigen::Vector2d> map_mm,
                                    std::span<const double> values, double most, int size_px) {
  Eigen::Vector2d low = map_mm[mesh.triangles[0][0]], high = low;
  for (const auto& triangle : mesh.triangles) {
    for (const int32_t vertex : triangle) {
      low = low.cwiseMin(map_mm[vertex]);
      high = high.cwiseMax(map_mm[vertex]);
    }
  }
  Canvas canvas(low, high, size_px);
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double share = std::clamp((values[t] - 1) / std::max(most - 1, 1e-9), 0.0, 1.0);
    canvas.Triangle(map_mm[a], map_mm[b], map_mm[c], ScaleColour(share));
  }
  return canvas.Png();
}

}  // namespace slicefarm::texture
