#include "services/planning/algo/supports/generator/columns.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/rings/simplify.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/raster.h"
#include "services/planning/algo/supports/generator/reach_field.h"
#include "services/planning/algo/supports/generator/slender.h"
#include "services/planning/algo/supports/generator/tolerances.h"
#include "services/planning/algo/supports/generator/widened.h"

namespace slicefarm::planning {
namespace {

/// Distance in addition to top_gap_nm that the top of a column keeps from an underside of the part
/// that it does not support. A nearer top would resemble a contact at the wrong distance.
constexpr Coord kUselessNm = 500'000;
/// Smallest area of a column's island. No bead fits into less.
constexpr double kLeastAreaNm2 = 0.05e12;
constexpr double kMostPixels = 2'000'000;
/// Height between two checks for slender columns. A wall of one bead falls over.
constexpr Coord kSlenderStepNm = 2'000'000;
/// Number of layers that are processed together. Their pixels are in memory at the same time.
constexpr size_t kLayersAtOnce = 32;

/// Pixels of one layer during the computation.
struct RasterLayer {
  explicit RasterLayer(const PixelGrid& grid)
      : contact(grid), beside(grid), blocked(grid), useless(grid), column(grid) {}

  Bitmap contact;  ///< contacts that begin in this layer
  Bitmap beside;   ///< area of the columns that these contacts request
  Bitmap blocked;  ///< pixels that are not free
  Bitmap useless;  ///< pixels so near below the part that a top would resemble a contact
  Bitmap column;   ///< columns in this layer, without contacts of the layers just above
};

/// Returns the pixels within `radius_nm` of set ones.
Bitmap Grown(const Bitmap& bitmap, Coord radius_nm) {
  const PixelGrid& grid = bitmap.grid();
  Bitmap grown(grid);
  const double pixels = static_cast<double>(radius_nm) / static_cast<double>(grid.pixel_nm);
  if (pixels < 3) {
    const std::vector<PixelDistance> set(bitmap.Row(0), bitmap.Row(0) + grid.size());
    const auto near = MostWithin(set, grid, static_cast<int32_t>(pixels * pixels));
    std::copy(near.begin(), near.end(), grown.Row(0));
    return grown;
  }
  const std::vector<PixelDistance> distance = DistanceTo(bitmap);
  const auto least = static_cast<PixelDistance>(
      std::clamp<double>((pixels - 0.5) * kDistanceSteps, 0, kFarthest - 1));
  for (size_t i = 0; i < distance.size(); ++i) grown.Row(0)[i] = distance[i] <= least ? 1 : 0;
  return grown;
}

/// Returns the bitmap grown and shrunk again, which closes narrow gaps.
Bitmap Closed(const Bitmap& bitmap, Coord radius_nm) {
  Bitmap outside = Grown(bitmap, radius_nm);
  const size_t size = bitmap.grid().size();
  for (size_t i = 0; i < size; ++i) outside.Row(0)[i] ^= 1;
  Bitmap closed = Grown(outside, radius_nm);
  for (size_t i = 0; i < size; ++i) closed.Row(0)[i] = (closed.Row(0)[i] ^ 1) | bitmap.Row(0)[i];
  return closed;
}

/// Returns the squares of the plane, `side` pixels wide, that contain a set pixel.
Bitmap Cells(const Bitmap& bitmap, int32_t side) {
  const PixelGrid& grid = bitmap.grid();
  const auto first = [&](Coord at) {  // first pixel of the first square
    const Coord pixels = at / grid.pixel_nm % side;
    return static_cast<int32_t>(pixels > 0 ? side - pixels : -pixels) - side;
  };
  Bitmap cells(grid);
  for (int32_t y0 = first(grid.origin.y); y0 < grid.height; y0 += side) {
    for (int32_t x0 = first(grid.origin.x); x0 < grid.width; x0 += side) {
      const int32_t xa = std::max(0, x0), xb = std::min(grid.width, x0 + side);
      const int32_t ya = std::max(0, y0), yb = std::min(grid.height, y0 + side);
      if (xa >= xb || ya >= yb) continue;
      bool holds = false;
      for (int32_t y = ya; y < yb && !holds; ++y)
        holds = std::find(bitmap.Row(y) + xa, bitmap.Row(y) + xb, 1) != bitmap.Row(y) + xb;
      for (int32_t y = ya; y < yb && holds; ++y) std::fill(cells.Row(y) + xa, cells.Row(y) + xb, 1);
    }
  }
  return cells;
}

/// Computes columns of one style, a block of layers at a time, from the top down.
class ColumnMaker {
 public:
  ColumnMaker(const SupportProblem& problem, const SupportHeights& heights,
              const Contacts& contacts, const Clearance& clearance, const SupportOptions& options,
              const PixelGrid& grid, int threads)
      : problem_(problem),
        heights_(heights),
        contacts_(contacts),
        clearance_(clearance),
        options_(options),
        grid_(grid),
        threads_(threads),
        state_(grid.size(), 0),
        wanted_(grid.size(), 0),
        stood_(grid) {}

  absl::StatusOr<std::vector<MultiPolygon>> Run(const CancelToken& cancel) {
    std::vector<MultiPolygon> columns(heights_.layers.size());
    if (options_.bed_only || !problem_.others.empty()) LeaveOutForbidden();
    for (size_t end = columns.size(); end > 0;) {
      if (cancel.Cancelled()) return cancel.Check();
      const size_t begin = end > kLayersAtOnce ? end - kLayersAtOnce : 0;
      std::vector<RasterLayer> layers(end - begin, RasterLayer(grid_));
      ForEachIndex(threads_, layers.size(), [&](size_t i, int) {
        if (cancel.Cancelled()) return;
        const SupportHeight& height = heights_.layers[begin + i];
        clearance_.FillBlocked(height.bottom_nm, height.top_nm, layers[i].blocked);
        if (!contacts_[begin + i].empty()) Begin(begin + i, layers[i]);
        FillUseless(height.top_nm, layers[i]);
      });
      for (size_t i = layers.size(); i-- > 0;) {
        GoDown(layers[i]);
        WidenSlender(begin + i, layers[i].column);
      }
      ForEachIndex(threads_, layers.size(), [&](size_t i, int) {
        if (!cancel.Cancelled()) columns[begin + i] = Drawn(layers[i], begin + i);
      });
      end = begin;
    }
    if (cancel.Cancelled()) return cancel.Check();
    return columns;
  }

 private:
  /// Marks the new contacts of a layer and the columns around them. Squares have stair-shaped
  /// edges, and a printer slows down at each corner. Closing turns the stairs into slopes.
  void Begin(size_t index, RasterLayer& layer) const {
    layer.contact.Fill(contacts_[index]);
    layer.contact.FillEdges(contacts_[index]);  // so that the thinnest contact gets a column
    const Coord cell = std::max(options_.spacing_nm / 2, options_.width_nm);
    const auto side = std::max<Coord>(1, cell / grid_.pixel_nm);
    layer.beside =
        options_.style == SupportStyle::kGrid
            ? Closed(Cells(layer.contact, static_cast<int32_t>(side)), options_.closing_radius_nm)
            : Closed(Grown(layer.contact, options_.width_nm), options_.closing_radius_nm);
    if (highest_start_.empty()) return;
    for (size_t i = 0; i < grid_.size(); ++i)
      layer.beside.Row(0)[i] &= static_cast<uint8_t>(MayStart(index, i));
  }

  void FillUseless(Coord top_nm, RasterLayer& layer) const {
    auto part = std::partition_point(problem_.part.begin(), problem_.part.end(),
                                     [&](const PartLayer& l) { return l.bottom_nm() < top_nm; });
    const Coord highest = top_nm + options_.top_gap_nm + kUselessNm;
    for (; part != problem_.part.end() && part->bottom_nm() <= highest; ++part)
      layer.useless.Fill(*part->outlines);
    layer.useless = Grown(layer.useless, 2 * grid_.pixel_nm);
  }

  bool MayStart(size_t layer, size_t pixel) const {
    return highest_start_.empty() || static_cast<int32_t>(layer) <= highest_start_[pixel];
  }

  /// Finds, for each pixel above a forbidden surface, the highest layer at which a column may
  /// begin. A forbidden surface is another object or, with bed_only, the part. Removes the contacts
  /// that no column may reach.
  void LeaveOutForbidden() {
    highest_start_.assign(grid_.size(), std::numeric_limits<int32_t>::max());
    SupportProblem forbidden;
    forbidden.others = problem_.others;
    if (options_.bed_only) forbidden.part = problem_.part;
    const Clearance clearance(forbidden, options_, heights_.layers.back().top_nm, threads_);
    for (size_t i = 0; i < heights_.layers.size(); ++i) {
      Bitmap blocked(grid_);
      clearance.FillBlocked(heights_.layers[i].bottom_nm, heights_.layers[i].top_nm, blocked);
      for (size_t k = 0; k < grid_.size(); ++k) {
        if (blocked.Row(0)[k])
          highest_start_[k] = std::min(highest_start_[k], static_cast<int32_t>(i));
        blocked.Row(0)[k] = MayStart(i, k) ? 0 : 1;
      }
      if (!contacts_[i].empty()) contacts_[i] = WithoutRings(contacts_[i], Outline(blocked));
    }
  }

  /// Updates the state of each pixel for the next layer down. State 0: nothing; 1: column; n + 1: a
  /// column begins n layers below.
  void GoDown(RasterLayer& layer) {
    const uint8_t *contact = layer.contact.Row(0), *beside = layer.beside.Row(0);
    const uint8_t *blocked = layer.blocked.Row(0), *useless = layer.useless.Row(0);
    uint8_t* column = layer.column.Row(0);
    for (size_t i = 0; i < grid_.size(); ++i) {
      uint8_t state = state_[i];
      state = static_cast<uint8_t>(state > 1 ? state - 1 : state);
      wanted_[i] = static_cast<uint8_t>((wanted_[i] | beside[i]) & (blocked[i] ^ 1));
      if (wanted_[i] & (useless[i] ^ 1)) state = 1;
      if (blocked[i]) state = 0;
      // Beside the part, the pixel of a contact may be free only in a lower layer.
      if (contact[i] && state == 0) state = support::kExactLayers + 1;
      state_[i] = state;
      column[i] = state == 1 ? 1 : 0;
    }
    FillCracks(layer);
  }

  /// Fills pixels with column pixels on both sides. Such cracks occur where steps of contacts meet
  /// between pixels.
  void FillCracks(RasterLayer& layer) {
    for (int32_t y = 1; y + 1 < grid_.height; ++y) {
      const uint8_t *row = layer.column.Row(y), *up = layer.column.Row(y + 1);
      const uint8_t *down = layer.column.Row(y - 1), *blocked = layer.blocked.Row(y);
      uint8_t* state = state_.data() + static_cast<size_t>(y) * grid_.width;
      for (int32_t x = 1; x + 1 < grid_.width; ++x) {
        const int between = (row[x - 1] & row[x + 1]) | (up[x] & down[x]);
        if (between & (blocked[x] ^ 1)) state[x] = 1;
      }
    }
    for (size_t i = 0; i < grid_.size(); ++i) layer.column.Row(0)[i] = state_[i] == 1 ? 1 : 0;
  }

  /// Widens columns that are slender at this check and the one before, so that a closed cell of
  /// lines fits into them from here down.
  void WidenSlender(size_t index, const Bitmap& column) {
    if (heights_.layers[index].top_nm > next_look_nm_) return;
    next_look_nm_ = heights_.layers[index].top_nm - kSlenderStepNm;
    const Bitmap around = AroundSlender(column, stood_, options_.width_nm * 5 / 3);
    for (size_t i = 0; i < grid_.size(); ++i)
      wanted_[i] |= static_cast<uint8_t>(around.Row(0)[i] & MayStart(index, i));
    stood_ = column;
  }

  /// Returns the columns of a layer with exact boundaries: their pixels, grown by one pixel towards
  /// blocked areas, without the blocked areas.
  MultiPolygon Drawn(const RasterLayer& layer, size_t index) const {
    Bitmap wide = layer.column;
    for (int32_t y = 0; y < grid_.height; ++y) {
      const uint8_t* blocked = layer.blocked.Row(y);
      for (int32_t x = 0; x < grid_.width; ++x)
        if (blocked[x] && HasNeighbour(layer.column, x, y)) wide.Row(y)[x] = 1;
    }
    std::vector<Polygon> rings;
    for (const Polygon& ring : Outline(wide)) {
      Polygon simple = SimplifyRing(ring, grid_.pixel_nm * 105 / 100);
      if (simple.size() >= 3) rings.push_back(std::move(simple));
    }
    for (size_t i = index; i < std::min(contacts_.size(), index + support::kExactLayers); ++i)
      // Contacts of higher layers are grown slightly, so that no step is separated from the next.
      for (Polygon& ring : Rings(i == index ? contacts_[i] : FastOffset(contacts_[i], 2 * kEdgeNm)))
        rings.push_back(std::move(ring));
    const SupportHeight& height = heights_.layers[index];
    MultiPolygon column = clearance_.FreeOf(rings, height.bottom_nm, height.top_nm);
    const MultiPolygon widened = Widened(column, options_.width_nm * 4 / 5);
    if (!widened.empty())
      column = Union(column, clearance_.Free(widened, height.bottom_nm, height.top_nm));
    std::erase_if(column,
                  [](const PolygonWithHoles& island) { return Area(island) < kLeastAreaNm2; });
    return column;
  }

  bool HasNeighbour(const Bitmap& bitmap, int32_t x, int32_t y) const {
    for (int32_t v = std::max(0, y - 1); v <= std::min(grid_.height - 1, y + 1); ++v)
      for (int32_t u = std::max(0, x - 1); u <= std::min(grid_.width - 1, x + 1); ++u)
        if (bitmap.At(u, v)) return true;
    return false;
  }

  const SupportProblem& problem_;
  const SupportHeights& heights_;
  Contacts contacts_;
  const Clearance& clearance_;
  const SupportOptions& options_;
  const PixelGrid grid_;
  const int threads_;
  std::vector<uint8_t> state_;  ///< state of each pixel, see GoDown
  /// True for pixels that get a column in the first layer in which they are not useless.
  std::vector<uint8_t> wanted_;
  /// Highest layer at which a column may begin, for each pixel; empty: no limit.
  std::vector<int32_t> highest_start_;
  Bitmap stood_;  ///< columns at the last check of WidenSlender
  Coord next_look_nm_ = std::numeric_limits<Coord>::max();
};

}  // namespace

absl::StatusOr<std::vector<MultiPolygon>> Columns(const SupportProblem& problem,
                                                  const SupportHeights& heights,
                                                  const Contacts& contacts,
                                                  const Clearance& clearance,
                                                  const SupportOptions& options, int threads,
                                                  const CancelToken& cancel) {
  Box box;
  for (const MultiPolygon& contact : contacts) box.Add(Bounds(contact));
  if (cancel.Cancelled()) return cancel.Check();
  if (box.Empty()) return std::vector<MultiPolygon>(heights.layers.size());
  box = box.Grown(options.spacing_nm + 2 * options.width_nm + options.closing_radius_nm);
  Coord pixel = kColumnPixelNm;
  while (static_cast<double>(GridOver(box, pixel).size()) > kMostPixels) pixel = pixel * 5 / 4;
  return ColumnMaker(problem, heights, contacts, clearance, options, GridOver(box, pixel), threads)
      .Run(cancel);
}

}  // namespace slicefarm::planning
