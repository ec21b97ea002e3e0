#include "services/slicing/algo/thumbnail/thumbnail.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "common/base/error.h"
#include "common/geometry/vector.h"
#include "services/slicing/algo/thumbnail/jpg_image.h"
#include "services/slicing/algo/thumbnail/png_image.h"
#include "services/slicing/algo/thumbnail/qoi_image.h"

namespace slicefarm::slicing {
namespace {

constexpr int32_t kMaxSizePx = 2048;
constexpr double kMarginOfSize = 0.04;
constexpr double kHalfSample = 0.5;
constexpr size_t kDrawnPerPoll = 1 << 16;
constexpr std::array<double, 3> kColor = {237, 122, 44};

constexpr double kInverseRoot2 = 0.70710678118654752;
constexpr double kInverseRoot6 = 0.40824829046386302;
constexpr double kInverseRoot3 = 0.57735026918962576;

/// Returns the coordinates in the picture's axes: right, up and towards the viewer.
Vector3 ToView(const Vertex& v, Point center) {
  const double x = static_cast<double>(v.x + center.x), y = static_cast<double>(v.y + center.y),
               z = static_cast<double>(v.z);
  return {(x + y) * kInverseRoot2, (y - x + 2 * z) * kInverseRoot6, (x - y + z) * kInverseRoot3};
}

/// Mapping from a view position to buffer samples: x to the right, y down, z towards the viewer.
struct Viewport {
  double scale = 0;
  double left = 0;
  double top = 0;

  Vector3 ToBuffer(const Vector3& view) const {
    return {(view.x() - left) * scale, (top - view.y()) * scale, view.z() * scale};
  }
};

/// Linear function of x and y in the picture, relative to a corner of a triangle.
struct Slope {
  double x = 0;
  double y = 0;
  double at_corner = 0;
};

/// Triangle in view coordinates. It computes its samples, depth and brightness.
struct Facet {
  Vector3 a, ab, ac;
  /// Twice the signed area; below zero if it faces the viewer, because the screen's y points down.
  double area;

  Facet(const Vector3& a, const Vector3& b, const Vector3& c)
      : a(a), ab(b - a), ac(c - a), area(ab.x() * ac.y() - ab.y() * ac.x()) {}

  /// Returns the weights of the corners a, b, c; all three are positive inside.
  std::array<Slope, 3> Weights() const {
    const Slope b{ac.y() / area, -ac.x() / area, 0}, c{-ab.y() / area, ab.x() / area, 0};
    return {Slope{-b.x - c.x, -b.y - c.y, 1}, b, c};
  }

  /// Returns the brightness: some ambient light, and more light from above the viewer's left
  /// shoulder. Both sides are lit.
  uint8_t Shade() const {
    const double nx = ab.y() * ac.z() - ab.z() * ac.y(), ny = ab.z() * ac.x() - ab.x() * ac.z(),
                 nz = area;
    const double towards = nz < 0 ? -1 : 1;
    const double light =
        towards * (-0.32 * nx - 0.64 * ny + 0.70 * nz) / std::sqrt(nx * nx + ny * ny + nz * nz);
    return static_cast<uint8_t>(255 * std::clamp(0.35 + 0.65 * light, 0.15, 1.0));
  }
};

/// Returns the index of the first sample with its centre at or after `low`, for values from 0 on.
/// Sample centres are at halves. For the upper limit of a range, the result is one past the range's
/// last sample.
int32_t SampleFrom(double low) { return static_cast<int32_t>(low + kHalfSample); }

/// Depth buffer with several samples per pixel on each axis.
class DepthBuffer {
 public:
  DepthBuffer(int32_t width, int32_t height)
      : width_(width),
        height_(height),
        depth_(static_cast<size_t>(width) * height, kNothing),
        shade_(depth_.size(), 0) {}

  /// Fills the samples with centres inside the facet if the facet is nearer there than the stored
  /// depth. REQUIRES: the facet is within the buffer.
  void Draw(const Vector3& a, const Vector3& b, const Vector3& c, bool from_behind) {
    const double left = std::min({a.x(), b.x(), c.x()}), right = std::max({a.x(), b.x(), c.x()});
    const int32_t top = SampleFrom(std::min({a.y(), b.y(), c.y()}));
    const int32_t bottom = std::min(SampleFrom(std::max({a.y(), b.y(), c.y()})), height_);
    if (SampleFrom(left) == SampleFrom(right) || top >= bottom) return;
    const Facet facet(a, b, c);
    if (facet.area == 0 || (facet.area > 0 && !from_behind)) return;
    const std::array<Slope, 3> weights = facet.Weights();
    const Slope depth{weights[1].x * facet.ab.z() + weights[2].x * facet.ac.z(),
                      weights[1].y * facet.ab.z() + weights[2].y * facet.ac.z(), a.z()};
    const uint8_t shade = facet.Shade();
    for (int32_t y = top; y < bottom; ++y) {
      const double dy = y + 0.5 - a.y();
      double from = left, to = right;
      for (const Slope& weight : weights) {
        const double zero = a.x() - (weight.at_corner + weight.y * dy) / weight.x;
        if (weight.x > 0) from = std::max(from, zero);
        if (weight.x < 0) to = std::min(to, zero);
      }
      if (from < to)
        DrawRow(y, SampleFrom(from), SampleFrom(to),
                {depth.x, 0, a.z() + depth.y * dy - depth.x * a.x()}, shade);
    }
  }

  /// Copies another buffer's samples to this buffer. The other buffer's first sample is put at
  /// column `left` and row `top`, and its depths are changed by `depth` towards the viewer.
  void Stamp(const DepthBuffer& other, int32_t left, int32_t top, float depth) {
    const int32_t from = std::max(-left, 0), to = std::min(width_ - left, other.width_);
    for (int32_t y = std::max(-top, 0); y < std::min(height_ - top, other.height_); ++y) {
      for (int32_t x = from; x < to; ++x) {
        const size_t at = static_cast<size_t>(y) * other.width_ + x;
        if (other.depth_[at] != kNothing)
          Put(static_cast<size_t>(y + top) * width_ + left + x, other.depth_[at] + depth,
              other.shade_[at]);
      }
    }
  }

  /// Returns the mean of the pixel's fine x fine samples. Samples that no face covers are
  /// transparent.
  Rgba Pixel(int32_t x, int32_t y, int32_t fine) const {
    int32_t covered = 0, shade = 0;
    for (int32_t j = 0; j < fine; ++j) {
      const size_t row = static_cast<size_t>(y * fine + j) * width_ + static_cast<size_t>(x) * fine;
      for (size_t at = row; at < row + fine; ++at) {
        if (depth_[at] == kNothing) continue;
        ++covered;
        shade += shade_[at];
      }
    }
    if (covered == 0) return {0, 0, 0, 0};
    Rgba pixel;
    for (int i = 0; i < 3; ++i)
      pixel[i] = static_cast<uint8_t>(std::lround(kColor[i] * shade / (255.0 * covered)));
    pixel[3] = static_cast<uint8_t>((255 * covered + fine * fine / 2) / (fine * fine));
    return pixel;
  }

 private:
  static constexpr float kNothing = -HUGE_VALF;

  /// Draws the samples [from, to) of row y; `depth` is relative to x = 0.
  void DrawRow(int32_t y, int32_t from, int32_t to, const Slope& depth, uint8_t shade) {
    size_t at = static_cast<size_t>(y) * width_ + from;
    for (int32_t x = from; x < std::min(to, width_); ++x, ++at)
      Put(at, static_cast<float>(depth.at_corner + depth.x * (x + 0.5)), shade);
  }

  void Put(size_t at, float depth, uint8_t shade) {
    if (depth < depth_[at] || (depth == depth_[at] && shade <= shade_[at])) return;
    depth_[at] = depth;
    shade_[at] = shade;
  }

  int32_t width_;
  int32_t height_;
  std::vector<float> depth_;
  std::vector<uint8_t> shade_;
};

Viewport FitViewport(std::span<const SceneMesh> scene, int32_t width, int32_t height) {
  Vector3 low{HUGE_VAL, HUGE_VAL, 0}, high{-HUGE_VAL, -HUGE_VAL, 0};
  for (const SceneMesh& object : scene) {
    if (object.centers.empty()) continue;
    const Vector3 first = ToView({}, object.centers.front());
    Vector3 least{HUGE_VAL, HUGE_VAL, 0}, most{-HUGE_VAL, -HUGE_VAL, 0};  // box at the first centre
    for (const Vertex& vertex : object.mesh->vertices) {
      const Vector3 view = ToView(vertex, object.centers.front());
      least.x() = std::min(least.x(), view.x()), least.y() = std::min(least.y(), view.y());
      most.x() = std::max(most.x(), view.x()), most.y() = std::max(most.y(), view.y());
    }
    for (const Point center : object.centers) {
      const Vector3 here = ToView({}, center);
      const double x = here.x() - first.x(), y = here.y() - first.y();
      low.x() = std::min(low.x(), least.x() + x), low.y() = std::min(low.y(), least.y() + y);
      high.x() = std::max(high.x(), most.x() + x), high.y() = std::max(high.y(), most.y() + y);
    }
  }
  const double margin = 1 + 2 * kMarginOfSize;
  const double across = std::max(high.x() - low.x(), 1.0) * margin;
  const double along = std::max(high.y() - low.y(), 1.0) * margin;
  const double scale = std::min(width / across, height / along);
  return {scale, (low.x() + high.x() - width / scale) / 2,
          (low.y() + high.y() + height / scale) / 2};
}

/// Returns the vertices in buffer coordinates, with the object's origin at `center`.
std::vector<Vector3> CornersOf(const IndexedMesh& mesh, Point center, const Viewport& viewport) {
  std::vector<Vector3> corners;
  corners.reserve(mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices)
    corners.push_back(viewport.ToBuffer(ToView(vertex, center)));
  return corners;
}

absl::Status DrawFacets(const SceneMesh& object, const std::vector<Vector3>& corners,
                        DepthBuffer& buffer, const CancelToken& cancel) {
  size_t count = 0;
  for (const auto& t : object.mesh->triangles) {
    if (++count % kDrawnPerPoll == 0 && cancel.Cancelled()) return cancel.Check();
    buffer.Draw(corners[t[0]], corners[t[1]], corners[t[2]], !object.solid);
  }
  return absl::OkStatus();
}

/// Draws the copies of an object. The first copy is drawn into a separate buffer, which is stamped
/// at all positions.
absl::Status StampCopies(const SceneMesh& object, const Viewport& viewport, DepthBuffer& buffer,
                         const CancelToken& cancel) {
  std::vector<Vector3> corners = CornersOf(*object.mesh, object.centers.front(), viewport);
  Vector3 low{HUGE_VAL, HUGE_VAL, 0}, high{0, 0, 0};
  for (const Vector3& corner : corners) {
    low.x() = std::min(low.x(), std::floor(corner.x())),
    low.y() = std::min(low.y(), std::floor(corner.y()));
    high.x() = std::max(high.x(), corner.x()), high.y() = std::max(high.y(), corner.y());
  }
  if (corners.empty()) return absl::OkStatus();
  for (Vector3& corner : corners) corner.x() -= low.x(), corner.y() -= low.y();
  DepthBuffer stamp(static_cast<int32_t>(high.x() - low.x()) + 1,
                    static_cast<int32_t>(high.y() - low.y()) + 1);
  if (absl::Status status = DrawFacets(object, corners, stamp, cancel); !status.ok()) return status;
  const Vector3 first = viewport.ToBuffer(ToView({}, object.centers.front()));
  for (const Point center : object.centers) {
    if (cancel.Cancelled()) return cancel.Check();
    const Vector3 here = viewport.ToBuffer(ToView({}, center));
    buffer.Stamp(stamp, static_cast<int32_t>(std::lround(low.x() + here.x() - first.x())),
                 static_cast<int32_t>(std::lround(low.y() + here.y() - first.y())),
                 static_cast<float>(here.z() - first.z()));
  }
  return absl::OkStatus();
}

absl::Status DrawObject(const SceneMesh& object, const Viewport& viewport, DepthBuffer& buffer,
                        const CancelToken& cancel) {
  if (object.centers.empty()) return absl::OkStatus();
  if (object.centers.size() > 1) return StampCopies(object, viewport, buffer, cancel);
  return DrawFacets(object, CornersOf(*object.mesh, object.centers.front(), viewport), buffer,
                    cancel);
}

absl::Status SizeError(const ThumbnailSize& size) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("thumbnails: {} x {} is not within 1 x 1 and {} x {}", size.width_px,
                               size.height_px, kMaxSizePx, kMaxSizePx),
                   {{"setting", "thumbnails"},
                    {"limit", std::to_string(kMaxSizePx)},
                    {"got", fmt::format("{}x{}", size.width_px, size.height_px)}});
}

absl::StatusOr<std::string> Encode(const std::vector<Rgba>& pixels, const ThumbnailSize& size) {
  if (size.format == PictureFormat::kQoi) return EncodeQoi(pixels, size.width_px, size.height_px);
  if (size.format == PictureFormat::kJpg) return EncodeJpg(pixels, size.width_px, size.height_px);
  return EncodePng(pixels, size.width_px, size.height_px);
}

}  // namespace

absl::StatusOr<Thumbnail> RenderThumbnail(std::span<const SceneMesh> scene,
                                          const ThumbnailSize& size, const CancelToken& cancel) {
  const int32_t width = size.width_px, height = size.height_px;
  if (std::min(width, height) < 1 || std::max(width, height) > kMaxSizePx) return SizeError(size);
  const int32_t fine = std::max(width, height) <= 128 ? 4 : 2;
  const Viewport viewport = FitViewport(scene, width * fine, height * fine);
  DepthBuffer buffer(width * fine, height * fine);
  for (const SceneMesh& object : scene)
    if (absl::Status status = DrawObject(object, viewport, buffer, cancel); !status.ok())
      return status;
  std::vector<Rgba> pixels;
  pixels.reserve(static_cast<size_t>(width) * height);
  for (int32_t y = 0; y < height; ++y)
    for (int32_t x = 0; x < width; ++x) pixels.push_back(buffer.Pixel(x, y, fine));
  absl::StatusOr<std::string> data = Encode(pixels, size);
  if (!data.ok()) return data.status();
  return Thumbnail{width, height, *std::move(data), size.format};
}

}  // namespace slicefarm::slicing
