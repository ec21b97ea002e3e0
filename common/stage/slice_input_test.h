#pragma once

#include <utility>
#include <vector>

#include "common/model/options/slicing_options.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/placement.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm {

/// Returns an object of one part made from a file.
inline ObjectInput ObjectOf(const MeshFile& file, int32_t index, const Placement& placement = {}) {
  ObjectInput object;
  object.name = file.name;
  object.parts.resize(1);
  object.parts[0].mesh.file = index;
  object.to_plate = TransformOf(placement);
  if (!placement.centers.empty()) object.copies.clear();
  for (const Point center : placement.centers)
    object.copies.push_back({CopyInput::Place::kMiddleAt, center});
  return object;
}

/// Returns an input with one object per file. Objects beyond the end of `placements` have the
/// default placement.
inline SliceInput InputOf(std::vector<MeshFile> files, std::vector<Placement> placements = {}) {
  SliceInput input;
  placements.resize(files.size());
  for (size_t i = 0; i < files.size(); ++i)
    input.objects.push_back(ObjectOf(files[i], static_cast<int32_t>(i), placements[i]));
  input.files = std::move(files);
  return input;
}

/// Returns options for the given number of objects, all alike.
inline SlicingOptions ForObjects(SlicingOptions options, size_t objects) {
  options.objects.resize(objects, options.objects.front());
  return options;
}

}  // namespace slicefarm
