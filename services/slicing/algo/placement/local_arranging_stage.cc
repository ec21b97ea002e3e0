#include "services/slicing/algo/placement/local_arranging_stage.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_join.h"
#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "services/slicing/algo/placement/arranging/arrange.h"
#include "services/slicing/algo/placement/copy_positions.h"
#include "services/slicing/algo/placement/placed_object.h"

namespace slicefarm::slicing {
namespace {

/// Returns the placed meshes of the objects, indexed by object.
absl::StatusOr<std::vector<PlacedObject>> ShapesOf(SliceInput& input, const MeshSource& source,
                                                   const CancelToken& cancel) {
  PartMeshes meshes(std::move(input.files), input.objects, source, cancel);
  std::vector<PlacedObject> shapes;
  for (const ObjectInput& object : input.objects) {
    absl::StatusOr<PlacedObject> shape = PlaceParts(object, meshes);
    if (!shape.ok()) return shape.status();
    shape->parts.clear();
    shapes.push_back(*std::move(shape));
  }
  return shapes;
}

/// Returns the middle of the box of a copy with a given position.
Point MiddleOf(const CopyInput& copy, const PlacedObject& shape) {
  if (copy.place == CopyInput::Place::kMiddleAt) return copy.at;
  return copy.at + Point{-shape.to_origin.x, -shape.to_origin.y};
}

absl::Status TooLarge(const std::vector<ObjectInput>& objects, const std::vector<size_t>& object_of,
                      const std::vector<size_t>& left_over) {
  std::vector<std::string> names;
  for (const size_t item : left_over) {
    const size_t object = object_of[item];
    const std::string name = ObjectWords(objects[object].name, object);
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  const std::string text = absl::StrJoin(names, ", ");
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfBuildVolume,
                   "too large for the bed: " + text, {{"object", text}});
}

/// Returns the smallest possible number of plates, by area; 1 if the bed is unlimited.
int FewestPlates(const std::vector<ArrangeItem>& items, const ArrangeOptions& options) {
  const double bed = std::abs(SignedArea(options.bed));
  double area = 0;
  for (const ArrangeItem& item : items) area += std::abs(SignedArea(item.footprint));
  return bed <= 0 ? 1 : std::max(1, static_cast<int>(std::ceil(area / bed)));
}

/// Arranges the items without rotation. If items are left over or the result needs more plates than
/// the minimum, also arranges them with rotations. The second result is returned if it places all
/// items, and on fewer plates than the first one if that places all too.
absl::StatusOr<Arrangement> ArrangeAll(std::vector<ArrangeItem> items,
                                       const std::vector<FixedFootprint>& fixed,
                                       const ArrangeOptions& options, const CancelToken& cancel) {
  auto straight = Arrange(items, fixed, options, cancel);
  if (!straight.ok()) return straight;
  const bool all = straight->left_over.empty();
  if (all && straight->plates <= FewestPlates(items, options)) return straight;
  for (ArrangeItem& item : items) item.rotations_deg = {0, 90};
  auto turned = Arrange(items, fixed, options, cancel);
  if (!turned.ok()) return turned;
  const bool better = turned->left_over.empty() && (!all || turned->plates < straight->plates);
  return better ? turned : straight;
}

class LocalArranging : public ArrangingStage {
 public:
  explicit LocalArranging(std::unique_ptr<const MeshSource> source) : source_(std::move(source)) {}

  absl::StatusOr<std::vector<PlatePosition>> PutOnPlates(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const override {
    const auto shapes = ShapesOf(input, *source_, call.cancel);
    if (!shapes.ok()) return shapes.status();
    std::vector<PlatePosition> places;
    std::vector<ArrangeItem> items;
    std::vector<FixedFootprint> fixed;
    std::vector<size_t> object_of, place_of;  // indices per item
    for (size_t object = 0; object < shapes->size(); ++object) {
      const PlacedObject& shape = (*shapes)[object];
      for (const CopyInput& copy : input.objects[object].copies) {
        PlatePosition& place = places.emplace_back();
        if (copy.place == CopyInput::Place::kAnywhere) {
          items.push_back({shape.footprint});
          object_of.push_back(object);
          place_of.push_back(places.size() - 1);
          continue;
        }
        place.middle = MiddleOf(copy, shape);
        if (shape.footprint.size() >= 3) fixed.push_back({Moved(shape.footprint, place.middle)});
      }
    }
    const auto arranged = ArrangeAll(items, fixed, ArrangeOptionsOf(options), call.cancel);
    if (!arranged.ok()) return arranged.status();
    if (!arranged->left_over.empty())
      return TooLarge(input.objects, object_of, arranged->left_over);
    for (size_t i = 0; i < items.size(); ++i)
      places[place_of[i]] = {arranged->places[i]->plate, arranged->places[i]->translation,
                             arranged->places[i]->rotation_deg != 0};
    return places;
  }

 private:
  const std::unique_ptr<const MeshSource> source_;
};

}  // namespace

std::unique_ptr<ArrangingStage> MakeLocalArranging(std::unique_ptr<const MeshSource> source) {
  return std::make_unique<LocalArranging>(std::move(source));
}

}  // namespace slicefarm::slicing
