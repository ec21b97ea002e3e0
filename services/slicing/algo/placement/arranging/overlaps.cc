#include "services/slicing/algo/placement/arranging/overlaps.h"

#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"

namespace slicefarm::slicing {
namespace {

constexpr double kLeastAreaNm2 = 1e9;  // 0.001 mm2: where copies only touch, roundings have less

/// Outlines of an object in one layer.
struct Slice {
  const ObjectSection* section = nullptr;
  Coord bottom_nm = 0;
};

/// Returns true if the areas overlap after `b` is moved by `shift`.
bool ShareArea(const MultiPolygon& a, const MultiPolygon& b, Point shift) {
  const Box left = Bounds(a);
  Box right = Bounds(b);
  if (left.Empty() || right.Empty()) return false;
  right = {right.min + shift, right.max + shift};
  if (!left.Intersects(right)) return false;
  return Area(Intersection(a, Moved(b, shift))) > kLeastAreaNm2;
}

/// Pair of neighbouring objects, followed from the top of the job downwards.
class Neighbours {
 public:
  Neighbours(int32_t a, int32_t b, Point shift) : objects_{a, b}, shift_(shift) {}

  /// Returns true if the outlines of both objects overlap in `layer`. Call it for all layers, from
  /// the top down.
  bool ShareRoom(const SlicedLayer& layer) {
    for (const ObjectSection& section : layer.sections)
      for (size_t i = 0; i < 2; ++i)
        if (section.stack.object == objects_[i])
          slices_[i] = {&section, layer.frame.print_z_nm - section.height_nm};
    const Coord bottom_nm = layer.frame.print_z_nm - layer.frame.height_nm;
    for (const Slice& slice : slices_)
      if (slice.section == nullptr || slice.bottom_nm > bottom_nm) return false;
    const MultiPolygon& a = OutlineOf(*slices_[0].section);
    const MultiPolygon& b = OutlineOf(*slices_[1].section);
    if (seen_[0] != nullptr && *seen_[0] == a && *seen_[1] == b) return false;
    seen_[0] = &a;
    seen_[1] = &b;
    return ShareArea(a, b, shift_);
  }

 private:
  int32_t objects_[2];
  Point shift_;
  Slice slices_[2] = {};
  const MultiPolygon* seen_[2] = {};  ///< outlines compared last, of both objects
};

/// Two objects, and the position of the second one's copy relative to the first one's.
using Standing = std::tuple<size_t, size_t, Point>;

absl::StatusOr<bool> ShareRoom(std::span<const SlicedLayer> layers, const Standing& standing,
                               const CancelToken& cancel) {
  Neighbours neighbours(static_cast<int32_t>(std::get<0>(standing)),
                        static_cast<int32_t>(std::get<1>(standing)), std::get<2>(standing));
  for (size_t i = layers.size(); i-- > 0;) {
    if (absl::Status going = cancel.Check(); !going.ok()) return going;
    if (neighbours.ShareRoom(layers[i])) return true;
  }
  return false;
}

}  // namespace

absl::StatusOr<std::vector<int64_t>> CountOverlapping(std::span<const SlicedLayer> layers,
                                                      std::span<const Copies> objects,
                                                      const CancelToken& cancel) {
  std::map<Standing, bool> known;
  std::set<CopyOf> overlapping;
  for (const auto& [a, b] : OverlappingFootprints(objects)) {
    if (overlapping.contains(a) && overlapping.contains(b)) continue;
    const Standing standing = {a.part, b.part,
                               objects[b.part].centers[b.copy] - objects[a.part].centers[a.copy]};
    const auto [found, is_new] = known.try_emplace(standing, false);
    if (is_new) {
      const absl::StatusOr<bool> share = ShareRoom(layers, standing, cancel);
      if (!share.ok()) return share.status();
      found->second = *share;
    }
    if (found->second) overlapping.insert({a, b});
  }
  std::vector<int64_t> counts(objects.size(), 0);
  for (const CopyOf& copy : overlapping) ++counts[copy.part];
  return counts;
}

}  // namespace slicefarm::slicing
