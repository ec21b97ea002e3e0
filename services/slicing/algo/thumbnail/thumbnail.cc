#include "services/slicing/algo/thumbnail/thumbnail.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "common/base/error.h"
#include "common/geometry/vector.h"
#include "common/model/limits.h"
#include "services/slicing/algo/thumbnail/btt_image.h"
#include "services/slicing/algo/thumbnail/colpic_image.h"
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

bool IsFromAbove(PictureRole role) {
  return role == PictureRole::kTop || role == PictureRole::kPick;
}

/// Returns the coordinates in the picture's axes: right, up and towards the viewer.
Vector3 ToView(const Vertex& v, Point center, bool from_above) {
  const double x = static_cast<double>(v.x + center.x), y = static_cast<double>(v.y + center.y),
               z = static_cast<double>(v.z);
  if (from_above) return {x, y, z};
  return {(x + y) * kInverseRoot2, (y - x + 2 * z) * kInverseRoot6, (x - y + z) * kInverseRoot3};
}

/// Mapping from a view position to buffer samples: x to the right, y down, z towards the viewer.
struct Viewport {
  bool from_above = false;
  double scale = 0;
  double left = 0;
  double top = 0;

  Vector3 ToBuffer(const Vertex& vertex, Point center) const {
    const Vector3 view = ToView(vertex, center, from_above);
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
  DepthBuffer(int32_t width, int32_t height, bool lit)
      : width_(width),
        height_(height),
        lit_(lit),
        depth_(static_cast<size_t>(width) * height, kNothing),
        shade_(depth_.size(), 0),
        copy_(depth_.size(), 0) {}

  /// Returns true if faces are shaded.
  bool lit() const { return lit_; }

  /// Selects the copy to which the next facets belong.
  void BeginCopy(int32_t copy) { drawn_copy_ = static_cast<uint16_t>(copy); }

  /// Fills the samples with centres inside the facet that are nearer than the stored ones.
  void Draw(const Vector3& a, const Vector3& b, const Vector3& c, bool from_behind) {
    const double left = std::max(0.0, std::min({a.x(), b.x(), c.x()}));
    const double right = std::max({a.x(), b.x(), c.x()});
    const int32_t top = SampleFrom(std::max(0.0, std::min({a.y(), b.y(), c.y()})));
    const int32_t bottom = std::min(SampleFrom(std::max({a.y(), b.y(), c.y()})), height_);
    if (SampleFrom(left) >= SampleFrom(right) || top >= bottom) return;
    const Facet facet(a, b, c);
    if (facet.area == 0 || (facet.area > 0 && !from_behind)) return;
    const std::array<Slope, 3> weights = facet.Weights();
    const Slope depth{weights[1].x * facet.ab.z() + weights[2].x * facet.ac.z(),
                      weights[1].y * facet.ab.z() + weights[2].y * facet.ac.z(), a.z()};
    const uint8_t shade = lit_ ? facet.Shade() : UINT8_MAX;
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

  /// Copies another buffer's samples to this one as samples of the selected copy, with the first
  /// one at `left`, `top` and nearer by `depth`.
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

  /// Returns the id of the copy at a sample as a colour.
  Rgba PickPixel(int32_t x, int32_t y) const {
    const size_t at = static_cast<size_t>(y) * width_ + x;
    if (depth_[at] == kNothing) return {0, 0, 0, 0};
    const auto id = static_cast<uint32_t>(PickId(copy_[at]));
    return {static_cast<uint8_t>(id), static_cast<uint8_t>(id >> 8), static_cast<uint8_t>(id >> 16),
            UINT8_MAX};
  }

  /// Returns the mean of fine x fine samples; parts that no face covers are transparent.
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
    copy_[at] = drawn_copy_;
  }

  int32_t width_;
  int32_t height_;
  bool lit_;
  std::vector<float> depth_;
  std::vector<uint8_t> shade_;
  std::vector<uint16_t> copy_;
  uint16_t drawn_copy_ = 0;
};

static_assert(limits::kMaxObjects <= UINT16_MAX);

/// Rectangle in the picture's axes.
struct ViewBox {
  double left = HUGE_VAL, bottom = HUGE_VAL, right = -HUGE_VAL, top = -HUGE_VAL;

  void Add(double x, double y) {
    left = std::min(left, x), bottom = std::min(bottom, y);
    right = std::max(right, x), top = std::max(top, y);
  }
};

ViewBox BoxOf(std::span<const SceneMesh> scene, bool from_above) {
  ViewBox box;
  for (const SceneMesh& object : scene) {
    if (object.centers.empty()) continue;
    const Vector3 first = ToView({}, object.centers.front(), from_above);
    ViewBox own;  // box at the first centre
    for (const Vertex& vertex : object.mesh->vertices) {
      const Vector3 view = ToView(vertex, object.centers.front(), from_above);
      own.Add(view.x(), view.y());
    }
    for (const Point center : object.centers) {
      const Vector3 here = ToView({}, center, from_above);
      const double x = here.x() - first.x(), y = here.y() - first.y();
      box.Add(own.left + x, own.bottom + y);
      box.Add(own.right + x, own.top + y);
    }
  }
  return box;
}

/// Returns the viewport that shows the bed from above, or the objects with a margin.
Viewport FitViewport(std::span<const SceneMesh> scene, const Polygon& bed, bool from_above,
                     int32_t width, int32_t height) {
  const bool shows_bed = from_above && !bed.empty();
  ViewBox box;
  for (const Point corner : bed)
    if (shows_bed) box.Add(static_cast<double>(corner.x), static_cast<double>(corner.y));
  if (!shows_bed) box = BoxOf(scene, from_above);
  const double margin = shows_bed ? 1 : 1 + 2 * kMarginOfSize;
  const double across = std::max(box.right - box.left, 1.0) * margin;
  const double along = std::max(box.top - box.bottom, 1.0) * margin;
  const double scale = std::min(width / across, height / along);
  Viewport viewport = {from_above, scale, (box.left + box.right - width / scale) / 2,
                       (box.bottom + box.top + height / scale) / 2};
  if (!from_above) return viewport;
  // Edges of a part may run exactly through samples of this view. A sample on the edge between two
  // faces may belong to neither of them, so the view is moved by a fraction of a sample.
  constexpr double kAsideX = 0.0137, kAsideY = 0.0071;
  viewport.left += kAsideX / scale;
  viewport.top += kAsideY / scale;
  return viewport;
}

/// Returns the vertices in buffer coordinates, with the object's origin at `center`.
std::vector<Vector3> CornersOf(const IndexedMesh& mesh, Point center, const Viewport& viewport) {
  std::vector<Vector3> corners;
  corners.reserve(mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) corners.push_back(viewport.ToBuffer(vertex, center));
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
                    static_cast<int32_t>(high.y() - low.y()) + 1, buffer.lit());
  if (absl::Status status = DrawFacets(object, corners, stamp, cancel); !status.ok()) return status;
  const Vector3 first = viewport.ToBuffer({}, object.centers.front());
  int32_t copy = object.first_copy;
  for (const Point center : object.centers) {
    if (cancel.Cancelled()) return cancel.Check();
    const Vector3 here = viewport.ToBuffer({}, center);
    buffer.BeginCopy(copy++);
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
  buffer.BeginCopy(object.first_copy);
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
  const int32_t width = size.width_px, height = size.height_px;
  switch (size.format) {
    case PictureFormat::kPng:
      return EncodePng(pixels, width, height);
    case PictureFormat::kQoi:
      return EncodeQoi(pixels, width, height);
    case PictureFormat::kJpg:
      return EncodeJpg(pixels, width, height);
    case PictureFormat::kBtt:
      return EncodeBtt(pixels, width, height);
    case PictureFormat::kColPic:
      return EncodeColPic(pixels, width, height);
  }
  return SizeError(size);
}

}  // namespace

absl::StatusOr<Thumbnail> RenderThumbnail(std::span<const SceneMesh> scene, const Polygon& bed,
                                          const ThumbnailSize& size, const CancelToken& cancel) {
  const int32_t width = size.width_px, height = size.height_px;
  if (std::min(width, height) < 1 || std::max(width, height) > kMaxSizePx) return SizeError(size);
  const bool picks = size.role == PictureRole::kPick;
  const int32_t fine = picks ? 1 : std::max(width, height) <= 128 ? 4 : 2;
  const Viewport viewport =
      FitViewport(scene, bed, IsFromAbove(size.role), width * fine, height * fine);
  DepthBuffer buffer(width * fine, height * fine, size.role != PictureRole::kUnlit);
  for (const SceneMesh& object : scene)
    if (absl::Status status = DrawObject(object, viewport, buffer, cancel); !status.ok())
      return status;
  std::vector<Rgba> pixels;
  pixels.reserve(static_cast<size_t>(width) * height);
  for (int32_t y = 0; y < height; ++y)
    for (int32_t x = 0; x < width; ++x)
      pixels.push_back(picks ? buffer.PickPixel(x, y) : buffer.Pixel(x, y, fine));
  absl::StatusOr<std::string> data = Encode(pixels, size);
  if (!data.ok()) return data.status();
  return Thumbnail{width, height, *std::move(data), size.format, size.role};
}

}  // namespace slicefarm::slicing
