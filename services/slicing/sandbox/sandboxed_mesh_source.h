#pragma once

#include <functional>
#include <memory>
#include <string>

#include "common/base/byte_budget.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"
#include "services/slicing/sandbox/confinement.h"

namespace slicefarm::slicing {

/// Options of a SandboxedMeshSource.
struct SandboxOptions {
  Confinement confinement = Confinement::kStrict;
  std::string program;  ///< path of slicefarm-mesh-reader
  std::function<ReaderLimits(std::string_view file)> limits = ReaderLimitsFor;
  /// Memory budget of all readers together. Each reader waits until its memory limit fits into the
  /// rest of the budget; a limit is never more than the whole budget. Null: no common budget; each
  /// reader may use the memory of `limits`.
  ByteBudget* memory = nullptr;
};

/// Reads each mesh in a separate confined program, the reader (confinement.h). The reader ends with
/// the call and is killed as soon as the call is cancelled. Its answer is checked before it is
/// used.
///
/// Errors of Read: any error of ReadMeshFile, and
///   MESH_READER_CRASHED  InvalidArgument: the reader ended by a signal or gave an invalid answer;
///                        metadata `signal` or `exit_code`
///   MESH_TOO_EXPENSIVE   InvalidArgument: the reader needed more than its limits; metadata
///                        `resource` (`memory_bytes` or `cpu_s`), `limit`
///   MESH_READER_KILLED   Unavailable: the reader was killed from outside
///   UNAVAILABLE          the system cannot start a reader now
///   BUILD_MISMATCH       FailedPrecondition: the program has been replaced
/// Cost besides the reading: a program start (some milliseconds), a copy of the file and one of the
/// mesh.
class SandboxedMeshSource : public MeshSource {
 public:
  explicit SandboxedMeshSource(SandboxOptions options) : options_(std::move(options)) {}

  /// Checks by reading a small mesh that readers work on this machine in this mode. Errors:
  /// FailedPrecondition, or any error of Read.
  absl::Status Probe() const;

  absl::StatusOr<MeshFileContents> Read(std::string bytes, MeshFormat format,
                                        double coordinate_limit, ReadDepth depth,
                                        const CancelToken& cancel) const override;

 private:
  const SandboxOptions options_;
};

}  // namespace slicefarm::slicing
