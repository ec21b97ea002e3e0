#include "services/slicing/algo/placement/scene_plates.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "absl/strings/escaping.h"
#include "common/base/error.h"
#include "common/geometry/moved.h"
#include "services/slicing/algo/placement/arrange.h"
#include "services/slicing/algo/placement/copy_places.h"
#include "services/slicing/algo/placement/placed_object.h"

namespace slicefarm::slicing {
namespace {

using Plates = std::vector<std::vector<SceneObject>>;

/// A copy, and what it covers of the bed.
struct Copy {
  size_t object = 0;
  const Instance* instance = nullptr;
  size_t shape = 0;  ///< of Shapes
};

/// An object turned as some of its copies are.
struct Shapes {
  std::vector<ObjectInput> inputs;
  std::vector<PlacedObject> placed;
};

ObjectInput InputOf(const SceneObject& object, const Transform& to_plate) {
  ObjectInput input;
  input.name = object.name;
  input.to_plate = to_plate;
  for (const Part& part : object.parts) {
    PartInput& added = input.parts.emplace_back();
    added.name = part.name;
    added.mesh = part.mesh;
    added.role = part.role;
    added.to_object = part.to_object;
  }
  return input;
}

/// All copies that are printed; those of an object that are turned alike share a shape.
std::vector<Copy> CopiesOf(const std::vector<SceneObject>& objects, Shapes& shapes) {
  std::vector<Copy> copies;
  for (size_t i = 0; i < objects.size(); ++i) {
    const size_t first = shapes.inputs.size();
    for (const Instance& instance : objects[i].instances) {
      if (!instance.printable) continue;
      Transform turned = instance.to_plate;
      turned(0, 3) = turned(1, 3) = 0;
      const auto same = std::find_if(
          shapes.inputs.begin() + static_cast<std::ptrdiff_t>(first), shapes.inputs.end(),
          [&](const ObjectInput& input) { return input.to_plate == turned; });
      copies.push_back({i, &instance, static_cast<size_t>(same - shapes.inputs.begin())});
      if (same == shapes.inputs.end()) shapes.inputs.push_back(InputOf(objects[i], turned));
    }
  }
  return copies;
}

absl::Status PlaceShapes(std::vector<MeshFile> files, const MeshSource& source,
                         const CancelToken& cancel, Shapes& shapes) {
  PartMeshes meshes(std::move(files), shapes.inputs, source, cancel);
  for (const ObjectInput& input : shapes.inputs) {
    absl::StatusOr<PlacedObject> placed = PlaceParts(input, meshes);
    if (!placed.ok()) return placed.status();
    placed->parts.clear();
    shapes.placed.push_back(*std::move(placed));
  }
  return absl::OkStatus();
}

/// Where the middle of the copy's box stands.
Point MiddleOf(const Instance& instance, const PlacedObject& shape) {
  const Point at{FromMm(instance.to_plate(0, 3)), FromMm(instance.to_plate(1, 3))};
  if (instance.by_middle) return at;
  return at + Point{-shape.to_origin.x, -shape.to_origin.y};
}

absl::Status TooLarge(const std::vector<SceneObject>& objects, const std::vector<Copy>& free,
                      const std::vector<size_t>& left_over) {
  std::map<size_t, std::string> names;
  for (const size_t item : left_over) {
    const size_t object = free[item].object;
    names[object] = "\"" + absl::Utf8SafeCEscape(objects[object].name) + "\"";
  }
  std::string text;
  for (const auto& [object, name] : names) text += (text.empty() ? "" : ", ") + name;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfBuildVolume,
                   "too large for the bed: " + text, {{"object", text}});
}

/// The scene with the copies of one plate alone.
class PlateBuilder {
 public:
  explicit PlateBuilder(const std::vector<SceneObject>& objects) : objects_(objects) {}

  void Add(size_t object, int plate, const Instance& instance) {
    const auto index = static_cast<size_t>(plate);
    if (plates_.size() <= index) plates_.resize(index + 1);
    plates_[index][object].push_back(instance);
  }

  Plates Take() const {
    Plates plates;
    for (const auto& copies_of : plates_) {
      if (copies_of.empty()) continue;
      std::vector<SceneObject>& plate = plates.emplace_back();
      for (const auto& [object, instances] : copies_of) {
        plate.push_back(objects_[object]);
        plate.back().instances = instances;
      }
    }
    return plates;
  }

 private:
  const std::vector<SceneObject>& objects_;
  std::vector<std::map<size_t, std::vector<Instance>>> plates_;  ///< by object
};

Instance At(Instance instance, Point middle) {
  instance.placed = instance.by_middle = true;
  instance.to_plate(0, 3) = ToMm(static_cast<double>(middle.x));
  instance.to_plate(1, 3) = ToMm(static_cast<double>(middle.y));
  return instance;
}

}  // namespace

absl::StatusOr<Plates> PutOnPlates(std::vector<MeshFile> files,
                                   const std::vector<SceneObject>& objects,
                                   const SlicingOptions& options, const MeshSource& source,
                                   const CancelToken& cancel) {
  Shapes shapes;
  const std::vector<Copy> copies = CopiesOf(objects, shapes);
  if (absl::Status ok = PlaceShapes(std::move(files), source, cancel, shapes); !ok.ok()) return ok;
  PlateBuilder plates(objects);
  std::vector<Copy> free;
  std::vector<ArrangeItem> items;
  std::vector<FixedFootprint> fixed;
  for (const Copy& copy : copies) {
    const PlacedObject& shape = shapes.placed[copy.shape];
    if (!copy.instance->placed) {
      free.push_back(copy);
      items.push_back({shape.footprint});
      continue;
    }
    plates.Add(copy.object, 0, *copy.instance);
    if (shape.footprint.size() >= 3)
      fixed.push_back({Moved(shape.footprint, MiddleOf(*copy.instance, shape))});
  }
  const auto arranged = Arrange(items, fixed, ArrangeOptionsOf(options), cancel);
  if (!arranged.ok()) return arranged.status();
  if (!arranged->left_over.empty()) return TooLarge(objects, free, arranged->left_over);
  for (size_t i = 0; i < free.size(); ++i) {
    const ItemPlace& place = *arranged->places[i];
    plates.Add(free[i].object, place.plate, At(*free[i].instance, place.translation));
  }
  return plates.Take();
}

}  // namespace slicefarm::slicing
