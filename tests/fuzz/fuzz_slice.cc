#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "common/geometry/measure.h"
#include "common/stage/slice_input_test.h"
#include "services/slicing/algo/local_slicing_stage.h"

namespace {

using slicefarm::MultiPolygon;

/// Returns true if the outlines meet the requirements of later stages.
bool IsSound(const MultiPolygon& outlines) {
  return std::all_of(
      outlines.begin(), outlines.end(), [](const slicefarm::PolygonWithHoles& island) {
        return island.outer.size() >= 3 && slicefarm::SignedArea(island.outer) > 0 &&
               std::all_of(island.holes.begin(), island.holes.end(),
                           [](const slicefarm::Polygon& hole) {
                             return hole.size() >= 3 && slicefarm::SignedArea(hole) < 0;
                           });
      });
}

bool IsSound(const slicefarm::ObjectSection& section) {
  return IsSound(slicefarm::OutlineOf(section)) &&
         std::ranges::all_of(section.regions, [](const slicefarm::Region& region) {
           return !region.outlines.empty() && IsSound(region.outlines);
         });
}

/// Adds half of the same mesh as a modifier with other settings.
void AddModifier(slicefarm::ObjectInput& object) {
  slicefarm::PartInput modifier = object.parts[0];
  modifier.role = slicefarm::PartRole::kModifier;
  modifier.to_object *= 0.5;
  modifier.regions.clear();
  modifier.changes = {{0, 1}};
  object.parts.push_back(modifier);
}

}  // namespace

/// The first byte selects the settings, and the rest is a mesh of any format.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  slicefarm::SlicingOptions options;
  slicefarm::ObjectSlicingOptions& object = options.objects[0];
  object.layer_height_nm = options.first_layer_height_nm = 2'000'000;
  object.fill_rule = static_cast<slicefarm::FillRule>(data[0] % 3);
  options.resolution_nm = data[0] & 4 ? 5'000 : 0;
  options.max_gap_nm = data[0] & 8 ? 2'000'000 : 0;
  object.xy_compensation_nm = data[0] & 16 ? -100'000 : 0;
  object.hole_compensation_nm = data[0] & 32 ? 100'000 : 0;
  options.thumbnails = {{16, 16}};
  options.bed = {};
  slicefarm::SliceInput input = slicefarm::InputOf(
      {{"fuzz", slicefarm::MeshFormat::kUnknown, std::string(data + 1, data + size)}},
      {{.rotate_deg = {data[0] & 64 ? 30.0 : 0.0, 0, 0}}});
  if (data[0] & 128) AddModifier(input.objects[0]);
  const auto job = slicefarm::slicing::MakeLocalSlicing()->Slice({}, std::move(input), options);
  if (!job.ok()) return 0;
  for (const slicefarm::SlicedLayer& layer : job->layers)
    for (const slicefarm::ObjectSection& section : layer.sections)
      if (!IsSound(section)) std::abort();
  return 0;
}
