#include "services/planning/algo/support/columns.h"

#include <algorithm>
#include <utility>

#include "common/base/parallel.h"
#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/rings/simplify.h"
#include "services/planning/algo/support/raster.h"

namespace slicefarm::planning {
namespace {

/// Above a top that carries nothing the part is not nearer than this beyond the gap: what lies
/// nearer would look like a contact, at the wrong distance.
constexpr Coord kUselessNm = 500'000;
constexpr Coord kSimplifyNm = 10'000;
/// Islands of columns with less are left out: no bead fits in.
constexpr double kLeastAreaNm2 = 0.05e12;
/// A cell of the grid belongs to a contact that holds one of this many by this many points in it.
constexpr int kPointsAcross = 6;

MultiPolygon Turned(MultiPolygon region, double cosine, double sine) {
  const auto turn = [&](Polygon& ring) {
    for (Point& p : ring)
      p = {std::llround(p.x * cosine - p.y * sine), std::llround(p.x * sine + p.y * cosine)};
  };
  for (PolygonWithHoles& island : region) {
    turn(island.outer);
    for (Polygon& hole : island.holes) turn(hole);
  }
  return region;
}

/// The cells of the grid that hold some of `contact`.
MultiPolygon Cells(const MultiPolygon& contact, const SupportOptions& options) {
  const Coord cell = std::max<Coord>(options.spacing_nm / 2, options.width_nm);
  const double cosine = Cos(options.angle_rad), sine = Sin(options.angle_rad);
  const MultiPolygon level = Turned(contact, cosine, -sine);
  const PixelGrid coarse = GridOver(Bounds(level), cell);
  PixelGrid fine = coarse;
  fine.pixel_nm = cell / kPointsAcross;
  // Whole pixels, so that cells of all layers lie on each other.
  fine.width = coarse.width * kPointsAcross;
  fine.height = coarse.height * kPointsAcross;
  PixelGrid whole = coarse;
  whole.pixel_nm = fine.pixel_nm * kPointsAcross;
  const Coord column = coarse.origin.x / cell, row = coarse.origin.y / cell;
  fine.origin = whole.origin = {column * whole.pixel_nm, row * whole.pixel_nm};
  Bitmap points(fine), cells(whole);
  points.Fill(level);
  for (int32_t y = 0; y < fine.height; ++y)
    for (int32_t x = 0; x < fine.width; ++x)
      if (points.At(x, y)) cells.Row(y / kPointsAcross)[x / kPointsAcross] = 1;
  return Turned(Outline(cells), cosine, sine);
}

/// Columns of one style, layer by layer downwards.
class ColumnMaker {
 public:
  ColumnMaker(const SupportProblem& problem, const SupportOptions& options)
      : problem_(problem), options_(options) {}

  /// The column under the contacts of one layer of support.
  MultiPolygon Shape(const MultiPolygon& contact, Coord top_nm) const {
    if (contact.empty()) return {};
    const MultiPolygon wide =
        options_.style == SupportStyle::kGrid
            ? Cells(contact, options_)
            : OffsetTwice(contact, options_.width_nm + options_.closing_radius_nm,
                          -options_.closing_radius_nm);
    std::vector<Polygon> undersides;
    const Box box = Bounds(wide).Grown(options_.width_nm);
    for (const PartLayer& layer : problem_.part) {
      if (layer.bottom_nm() < top_nm) continue;
      if (layer.bottom_nm() > top_nm + options_.top_gap_nm + kUselessNm) break;
      AppendRingsNear(*layer.outlines, box, undersides);
    }
    return Union(WithoutRings(wide, undersides), contact);
  }

  /// What columns must not stand on, by layer of support: all that lies below it.
  std::vector<MultiPolygon> Shadows(const SupportHeights& heights) const {
    std::vector<MultiPolygon> shadows(heights.layers.size());
    MultiPolygon shadow;
    std::vector<size_t> next(problem_.others.size() + 1, 0);
    for (size_t i = 0; i < heights.layers.size(); ++i) {
      std::vector<Polygon> rings = Rings(shadow);
      const size_t known = rings.size();
      const auto add = [&](const auto& stack, size_t& at) {
        for (; at < stack.size() && stack[at].bottom_nm() < heights.layers[i].top_nm; ++at)
          for (const Polygon& ring : Rings(FastOffset(*stack[at].outlines, options_.xy_gap_nm)))
            rings.push_back(ring);
      };
      for (size_t k = 0; k < problem_.others.size(); ++k) add(problem_.others[k], next[k]);
      if (options_.bed_only) add(problem_.part, next.back());
      if (rings.size() > known) shadow = Simplify(Union(rings, FillRule::kNonZero), kSimplifyNm);
      shadows[i] = shadow;
    }
    return shadows;
  }

 private:
  const SupportProblem& problem_;
  const SupportOptions& options_;
};

}  // namespace

absl::StatusOr<std::vector<MultiPolygon>> Columns(const SupportProblem& problem,
                                                  const SupportHeights& heights,
                                                  const Contacts& contacts,
                                                  const Clearance& clearance,
                                                  const SupportOptions& options, int threads,
                                                  const CancelToken& cancel) {
  const ColumnMaker maker(problem, options);
  const size_t count = heights.layers.size();
  std::vector<MultiPolygon> shapes(count), columns(count), shadows;
  if (options.bed_only || !problem.others.empty()) shadows = maker.Shadows(heights);
  ForEachIndex(threads, count, [&](size_t i, int) {
    if (contacts[i].empty() || cancel.Cancelled()) return;
    shapes[i] = maker.Shape(contacts[i], heights.layers[i].top_nm);
    if (!shadows.empty()) shapes[i] = Difference(shapes[i], shadows[i]);
  });
  MultiPolygon column;
  for (size_t i = count; i-- > 0;) {
    if (cancel.Cancelled()) return cancel.Check();
    if (!shapes[i].empty()) column = Simplify(Union(column, shapes[i]), kSimplifyNm);
    column = clearance.Free(column, heights.layers[i].bottom_nm, heights.layers[i].top_nm);
    std::erase_if(column,
                  [](const PolygonWithHoles& island) { return Area(island) < kLeastAreaNm2; });
    columns[i] = column;
  }
  return columns;
}

}  // namespace slicefarm::planning
