#include "common/wire/slicing_wire.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/slice_object_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/mesh_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

/// Largest memory reserved for an announced file. More is allocated when its bytes arrive.
constexpr int64_t kMaxReservedBytes = 64 << 20;

absl::StatusOr<MeshFile> FileFromProto(const v1::SliceFile& proto) {
  const absl::StatusOr<MeshFormat> format = FromProto(proto.format());
  if (!format.ok()) return format.status();
  MeshFile file;
  file.name = proto.name();
  file.format = *format;
  file.bytes.reserve(std::min(proto.size_bytes(), kMaxReservedBytes));
  return file;
}

absl::Status CheckSizes(const v1::SliceStart& start) {
  if (start.files_size() < 1) return Malformed("files", "there are none");
  if (start.files_size() > limits::kMaxObjects) {
    return LimitError(Reason::kRequestTooLarge, "files", limits::kMaxObjects, start.files_size());
  }
  if (start.objects_size() > limits::kMaxObjects) {
    return LimitError(Reason::kRequestTooLarge, "objects", limits::kMaxObjects,
                      start.objects_size());
  }
  int64_t left = limits::kMaxMeshBytes;
  for (const v1::SliceFile& file : start.files()) {
    if (file.size_bytes() < 0) return Malformed("files.size_bytes", "is negative");
    if (file.size_bytes() > left) {
      const int64_t before = limits::kMaxMeshBytes - left;
      return LimitError(Reason::kMeshTooLarge, "bytes of meshes", limits::kMaxMeshBytes,
                        before + std::min(file.size_bytes(), INT64_MAX - before));
    }
    left -= file.size_bytes();
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status ToProto(const StageCall& call, const SliceInput& input, const SlicingOptions& options,
                     v1::SliceStart* start) {
  *start->mutable_call() = ToProto(call);
  start->set_options(PackFields(options));
  for (const MeshFile& file : input.files) {
    v1::SliceFile* proto = start->add_files();
    proto->set_name(file.name);
    proto->set_format(ToProto(file.format));
    proto->set_size_bytes(static_cast<int64_t>(file.bytes.size()));
  }
  start->set_advise_orientations(input.advise_orientations);
  return AllToProto(input.objects, "objects", start->mutable_objects());
}

void ForEachChunk(const SliceInput& input, const std::function<bool(std::string_view)>& send) {
  for (const MeshFile& file : input.files) {
    for (std::string_view rest = file.bytes; !rest.empty();) {
      const std::string_view chunk = rest.substr(0, limits::kUploadChunkBytes);
      if (!send(chunk)) return;
      rest.remove_prefix(chunk.size());
    }
  }
}

absl::StatusOr<SliceInputReader> SliceInputReader::Begin(const v1::SliceStart& start) {
  if (absl::Status status = CheckSizes(start); !status.ok()) return status;
  SliceInputReader reader;
  for (int i = 0; i < start.files_size(); ++i) {
    absl::StatusOr<MeshFile> file = FileFromProto(start.files(i));
    if (!file.ok()) return Within("files", i, file.status());
    reader.input_.files.push_back(*std::move(file));
    reader.sizes_.push_back(static_cast<size_t>(start.files(i).size_bytes()));
  }
  reader.input_.advise_orientations = start.advise_orientations();
  absl::Status status = AllFromProto(start.objects(), "objects", &reader.input_.objects);
  if (!status.ok()) return status;
  return reader;
}

absl::Status SliceInputReader::Add(std::string_view chunk) {
  while (!chunk.empty()) {
    if (file_ == sizes_.size()) return Malformed("chunk", "more bytes than were announced");
    std::string& bytes = input_.files[file_].bytes;
    const std::string_view part = chunk.substr(0, sizes_[file_] - bytes.size());
    bytes.append(part);
    chunk.remove_prefix(part.size());
    if (bytes.size() == sizes_[file_]) ++file_;
  }
  return absl::OkStatus();
}

int64_t SliceInputReader::size() const {
  return static_cast<int64_t>(std::accumulate(sizes_.begin(), sizes_.end(), size_t{0}));
}

absl::StatusOr<SliceInput> SliceInputReader::Finish() {
  for (size_t i = 0; i < sizes_.size(); ++i) {
    if (input_.files[i].bytes.size() != sizes_[i]) {
      return Malformed("chunk", "fewer bytes than were announced");
    }
  }
  return std::move(input_);
}

absl::StatusOr<SliceStart> FromProto(const v1::SliceStart& proto) {
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  auto options = OptionsFromBytes<SlicingOptions>(proto.options());
  if (!options.ok()) return Within("options", options.status());
  absl::StatusOr<SliceInputReader> files = SliceInputReader::Begin(proto);
  if (!files.ok()) return files.status();
  return SliceStart{*std::move(call), *std::move(options), *std::move(files)};
}

absl::Status ToProto(const SlicedJob& job, v1::SliceSummary* summary) {
  v1::SliceSummary& proto = *summary;
  proto.set_layer_count(static_cast<int32_t>(job.layers.size()));
  proto.mutable_object_names()->Assign(job.object_names.begin(), job.object_names.end());
  for (const MeshReport& mesh : job.meshes) *proto.add_meshes() = ToProto(mesh);
  for (const Thumbnail& thumbnail : job.thumbnails) *proto.add_thumbnails() = ToProto(thumbnail);
  for (const OrientationAdvice& advice : job.orientations)
    *proto.add_orientations() = ToProto(advice);
  return AllToProto(job.copies, "copies", proto.mutable_copies());
}

absl::StatusOr<SlicedJob> FromProto(const v1::SliceSummary& proto) {
  if (proto.layer_count() < 0 || proto.layer_count() > limits::kMaxLayers) {
    return Malformed("layer_count", "is out of range");
  }
  SlicedJob job;
  job.layers.reserve(proto.layer_count());
  job.object_names.assign(proto.object_names().begin(), proto.object_names().end());
  absl::Status status = AllFromProto(proto.meshes(), "meshes", &job.meshes);
  status.Update(AllFromProto(proto.thumbnails(), "thumbnails", &job.thumbnails));
  status.Update(AllFromProto(proto.copies(), "copies", &job.copies));
  status.Update(AllFromProto(proto.orientations(), "orientations", &job.orientations));
  if (!status.ok()) return status;
  return job;
}

absl::Status ToProto(const PlatePosition& position, v1::PlatePosition* proto) {
  proto->set_plate(position.plate);
  proto->set_turned(position.turned);
  return ToProto(position.middle, proto->mutable_middle());
}

absl::StatusOr<PlatePosition> FromProto(const v1::PlatePosition& proto) {
  if (proto.plate() < 0 || proto.plate() >= limits::kMaxObjects)
    return Malformed("plate", "is none that copies could need");
  return PlatePosition{proto.plate(), FromProto(proto.middle()), proto.turned()};
}

}  // namespace slicefarm
