#include "services/lab/support/sliced_model.h"

#include <utility>

#include "services/cli/console/model_file.h"
#include "services/slicing/algo/local_slicing_stage.h"

namespace slicefarm::lab {
namespace {

constexpr Coord kHalfBedNm = 500'000'000;

}  // namespace

absl::StatusOr<SlicedJob> SliceModel(const std::string& path, Coord layer_height_nm, int threads) {
  absl::StatusOr<MeshFile> file = cli::ReadModelFile(path);
  if (!file.ok()) return file.status();
  SliceInput input;
  input.files.push_back(*std::move(file));
  ObjectInput object;
  object.name = path;
  object.parts.push_back({.name = path, .mesh = {0, kOnlyMesh}});
  object.copies = {{CopyInput::Place::kMiddleAt, {0, 0}}};
  input.objects.push_back(std::move(object));
  SlicingOptions options;
  options.first_layer_height_nm = layer_height_nm;
  options.bed = {{-kHalfBedNm, -kHalfBedNm},
                 {kHalfBedNm, -kHalfBedNm},
                 {kHalfBedNm, kHalfBedNm},
                 {-kHalfBedNm, kHalfBedNm}};
  options.thumbnails.clear();
  options.objects[0].layer_height_nm = layer_height_nm;
  StageCall call;
  call.threads = threads;
  return slicing::MakeLocalSlicing()->Slice(call, std::move(input), options);
}

}  // namespace slicefarm::lab
