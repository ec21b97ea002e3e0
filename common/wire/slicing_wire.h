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

/// Converts the input of slicing to the first message of a stream, without the bytes of the files.
/// The bytes of all files follow in chunks, in the order of the files. A chunk may contain the end
/// of one file and the beginning of the next.
absl::Status ToProto(const StageCall& call, const SliceInput& input, const SlicingOptions& options,
                     v1::SliceStart* proto);

/// Calls `send` with each chunk of the files, until `send` returns false. The chunks are views of
/// `input`.
void ForEachChunk(const SliceInput& input, const std::function<bool(std::string_view)>& send);

/// Assembles the files from chunks.
class SliceInputReader {
 public:
  /// Creates a reader for the announced files. Errors: REQUEST_MALFORMED; MESH_TOO_LARGE if all
  /// announced files together exceed limits::kMaxMeshBytes.
  static absl::StatusOr<SliceInputReader> Begin(const v1::SliceStart& start);

  /// Adds a chunk. Errors: REQUEST_MALFORMED for more bytes than announced.
  absl::Status Add(std::string_view chunk);

  /// Returns the announced size of all files.
  int64_t size() const;

  /// Returns the input. Errors: REQUEST_MALFORMED for fewer bytes than announced.
  absl::StatusOr<SliceInput> Finish();

 private:
  SliceInput input_;
  std::vector<size_t> sizes_;
  size_t file_ = 0;  ///< index of the file to which the next bytes belong
};

/// First message of the stream, and the reader for the files.
struct SliceStart {
  StageCall call;
  SlicingOptions options;
  SliceInputReader files;
};
absl::StatusOr<SliceStart> FromProto(const v1::SliceStart& proto);

/// Converts a sliced job without its layers, which are sent afterwards, one per message.
absl::Status ToProto(const SlicedJob& job, v1::SliceSummary* proto);
absl::StatusOr<SlicedJob> FromProto(const v1::SliceSummary& proto);

/// Converts the position of a copy on a plate to a message.
absl::Status ToProto(const PlatePosition& position, v1::PlatePosition* proto);
/// Converts a message to the position of a copy. Errors: REQUEST_MALFORMED for an invalid plate
/// number.
absl::StatusOr<PlatePosition> FromProto(const v1::PlatePosition& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
