#include "common/model/scene/scene.h"

#include <algorithm>

namespace slicefarm {

SceneObject ObjectOfFile(const std::string& name, int32_t file, const Placement& placement,
                         int32_t copies) {
  SceneObject object;
  object.name = name;
  Part part;
  part.name = name;
  part.mesh.file = file;
  part.mesh.mesh = kOnlyMesh;
  object.parts.push_back(part);
  Instance instance;
  instance.to_plate = TransformOf(placement);
  instance.placed = !placement.centers.empty();
  instance.by_middle = true;
  if (!instance.placed) object.instances.assign(static_cast<size_t>(std::max(copies, 1)), instance);
  for (const Point center : placement.centers) {
    instance.to_plate(0, 3) = ToMm(static_cast<double>(center.x));
    instance.to_plate(1, 3) = ToMm(static_cast<double>(center.y));
    object.instances.push_back(instance);
  }
  return object;
}

}  // namespace slicefarm
