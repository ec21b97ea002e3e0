#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "common/geometry/measure.h"
#include "services/slicing/algo/local_slicing_stage.h"

namespace {

using slicefarm::MultiPolygon;
using slicefarm::SlicedJob;

/// What later stages rely on.
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

}  // namespace

/// The first byte picks the settings, the rest is a mesh of any format.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  slicefarm::SlicingOptions options;
  options.layer_height_nm = options.first_layer_height_nm = 2'000'000;
  options.fill_rule = static_cast<slicefarm::FillRule>(data[0] % 3);
  options.resolution_nm = data[0] & 4 ? 5'000 : 0;
  options.max_gap_nm = data[0] & 8 ? 2'000'000 : 0;
  options.xy_compensation_nm = data[0] & 16 ? -100'000 : 0;
  options.hole_compensation_nm = data[0] & 32 ? 100'000 : 0;
  options.thumbnails_px = {{16, 16}};
  options.bed = {};
  slicefarm::SliceInput input;
  input.files.push_back(
      {"fuzz", slicefarm::MeshFormat::kUnknown, std::string(data + 1, data + size)});
  input.placements.push_back({.rotate_deg = {data[0] & 64 ? 30.0 : 0.0, 0, 0}});
  const auto job = slicefarm::slicing::MakeLocalSlicing()->Slice({}, std::move(input), options);
  if (!job.ok()) return 0;
  for (const slicefarm::SlicedLayer& layer : job->layers)
    for (const slicefarm::ObjectSection& object : layer.objects)
      if (!IsSound(object.outlines)) std::abort();
  return 0;
}
