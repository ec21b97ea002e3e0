#pragma once

#include "absl/status/statusor.h"
#include "common/model/scene/mesh.h"
#include "common/stage/stages.h"
#include "services/coordinator/remote/stage_client.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Reads project files where strangers' files are read.
class ProjectReader {
 public:
  virtual ~ProjectReader() = default;

  /// All plates that can be printed, each with its spec. Errors: REQUEST_MALFORMED for a file that
  /// is no project; those of reading one; Unavailable; Cancelled.
  virtual absl::StatusOr<v1::ReadProjectResponse> Read(const StageCall& call,
                                                       MeshFile file) const = 0;
};

/// The slicing service reads them, which reads meshes as well.
class RemoteProjects : public ProjectReader {
 public:
  /// `replicas` outlives it.
  explicit RemoteProjects(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("slicing", replicas, options) {}

  absl::StatusOr<v1::ReadProjectResponse> Read(const StageCall& call, MeshFile file) const override;

 private:
  const StageClient client_;
};

}  // namespace slicefarm::coordinator
