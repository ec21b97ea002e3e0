#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/stage/plates.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/slicing.pb.h"

namespace slicefarm {

/// The start of a stream. After it come the bytes of the files in chunks, in order; a chunk may
/// hold the end of one file and the beginning of the next.
absl::Status ToProto(const StageCall& call, const SliceInput& input, const SlicingOptions& options,
                     v1::SliceStart* proto);

/// Calls `send` with each chunk, until it returns false. Chunks are views of the input.
void ForEachChunk(const SliceInput& input, const std::function<bool(std::string_view)>& send);

/// The other end: puts the files together.
class SliceInputReader {
 public:
  /// Errors: REQUEST_MALFORMED; MESH_TOO_LARGE when all files together are announced beyond
  /// limits::kMaxMeshBytes.
  static absl::StatusOr<SliceInputReader> Begin(const v1::SliceStart& start);

  /// Errors: REQUEST_MALFORMED for more bytes than were announced.
  absl::Status Add(std::string_view chunk);

  /// Bytes of all files, as announced.
  int64_t size() const;

  /// Errors: REQUEST_MALFORMED for fewer bytes than were announced.
  absl::StatusOr<SliceInput> Finish();

 private:
  SliceInput input_;
  std::vector<size_t> sizes_;
  size_t file_ = 0;  ///< being filled
};

/// What begins the stream, and what the files are read into.
struct SliceStart {
  StageCall call;
  SlicingOptions options;
  SliceInputReader files;
};
absl::StatusOr<SliceStart> FromProto(const v1::SliceStart& proto);

/// All of a sliced job but its layers, which follow one by one.
absl::Status ToProto(const SlicedJob& job, v1::SliceSummary* proto);
absl::StatusOr<SlicedJob> FromProto(const v1::SliceSummary& proto);

absl::Status ToProto(const PlatePlace& place, v1::PlatePlace* proto);
/// Errors: REQUEST_MALFORMED for a plate that no job can have.
absl::StatusOr<PlatePlace> FromProto(const v1::PlatePlace& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
