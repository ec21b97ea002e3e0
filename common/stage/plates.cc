#include "common/stage/plates.h"

#include <map>
#include <utility>

#include "common/stage/copy_groups.h"

namespace slicefarm {
namespace {

ObjectInput InputOf(const SceneObject& object, const CopyGroup& group) {
  ObjectInput input;
  input.name = object.name;
  input.to_plate = group.to_plate;
  input.copies = CopiesOf(group);
  for (const Part& part : object.parts) {
    PartInput& added = input.parts.emplace_back();
    added.name = part.name;
    added.mesh = part.mesh;
    added.role = part.role;
    added.to_object = part.to_object;
  }
  return input;
}

/// Turns a copy by 90 degrees about the vertical, counter-clockwise. Coordinates are exchanged
/// without a cosine, so the result is exact.
void Turn(Transform& to_plate) {
  const Transform before = to_plate;
  to_plate.row(0) = -before.row(1);
  to_plate.row(1) = before.row(0);
}

/// Returns the copy at its new position.
Instance At(Instance instance, const PlatePosition& position) {
  if (instance.placed) return instance;
  const Point middle = position.middle;
  if (position.turned) Turn(instance.to_plate);
  instance.placed = instance.by_middle = true;
  instance.to_plate(0, 3) = ToMm(static_cast<double>(middle.x));
  instance.to_plate(1, 3) = ToMm(static_cast<double>(middle.y));
  return instance;
}

}  // namespace

std::vector<ObjectInput> ObjectsToArrange(std::span<const SceneObject> objects) {
  std::vector<ObjectInput> inputs;
  for (const SceneObject& object : objects)
    for (const CopyGroup& group : GroupsOf(object.instances))
      inputs.push_back(InputOf(object, group));
  return inputs;
}

std::vector<std::vector<SceneObject>> OnPlates(std::span<const SceneObject> objects,
                                               std::span<const PlatePosition> positions) {
  std::map<int32_t, std::map<size_t, std::vector<Instance>>> by_plate;  // then by object
  auto position = positions.begin();
  for (size_t object = 0; object < objects.size(); ++object) {
    for (const CopyGroup& group : GroupsOf(objects[object].instances)) {
      for (const Instance* copy : group.instances) {
        by_plate[position->plate][object].push_back(At(*copy, *position));
        ++position;
      }
    }
  }
  std::vector<std::vector<SceneObject>> plates;
  for (auto& [number, copies_of] : by_plate) {
    std::vector<SceneObject>& plate = plates.emplace_back();
    for (auto& [object, instances] : copies_of) {
      plate.push_back(objects[object]);
      plate.back().instances = std::move(instances);
    }
  }
  return plates;
}

}  // namespace slicefarm
