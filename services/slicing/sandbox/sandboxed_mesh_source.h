#pragma once

#include <functional>
#include <memory>
#include <string>

#include "common/base/byte_budget.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"
#include "services/slicing/sandbox/confinement.h"

namespace slicefarm::slicing {

struct SandboxOptions {
  Confinement confinement = Confinement::kStrict;
  std::string program;  ///< path of slicefarm-mesh-reader
  std::function<ReaderLimits(std::string_view file)> limits = ReaderLimitsFor;
  /// What all readers may take together: each waits until what it may take fits, and may take no
  /// more than the whole. Null: as much as `limits` says, each.
  ByteBudget* memory = nullptr;
};

/// Reads each mesh in a process of its own that is shut in (confinement.h), ends with the call, and
/// is killed as soon as it is cancelled. What it answers is checked before it is believed.
///
/// Errors of Read: those of ReadMeshFile, and
///   MESH_READER_CRASHED  InvalidArgument: the reader ended by a signal, or answered nonsense;
///                        metadata `signal` or `exit_code`
///   MESH_TOO_EXPENSIVE   InvalidArgument: it needed more than its limits; metadata `resource`
///                        (`memory_bytes` or `cpu_s`), `limit`
///   MESH_READER_KILLED   Unavailable: it was killed from outside
///   UNAVAILABLE          the system cannot start one (now)
///   BUILD_MISMATCH       FailedPrecondition: the program was replaced since
/// Cost besides the reading: a process (some milliseconds), a copy of the file and one of the mesh.
class SandboxedMeshSource : public MeshSource {
 public:
  explicit SandboxedMeshSource(SandboxOptions options) : options_(std::move(options)) {}

  /// Whether a mesh can be read so on this machine: reads one. FailedPrecondition or what Read
  /// gives.
  absl::Status Probe() const;

  absl::StatusOr<MeshFileContents> Read(std::string bytes, MeshFormat format,
                                        double coordinate_limit, ReadDepth depth,
                                        const CancelToken& cancel) const override;

 private:
  const SandboxOptions options_;
};

}  // namespace slicefarm::slicing
