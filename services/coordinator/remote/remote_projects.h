#pragma once

#include "absl/status/statusor.h"
#include "common/model/scene/mesh.h"
#include "common/stage/stages.h"
#include "services/coordinator/remote/stage_client.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Reader of project files (3MF). The files may come from untrusted clients.
class ProjectReader {
 public:
  virtual ~ProjectReader() = default;

  /// Returns all printable plates of a project, each with its job spec. Errors: REQUEST_MALFORMED
  /// if the file is no project; other errors of the slicing service's ReadProject; Unavailable;
  /// Cancelled.
  virtual absl::StatusOr<v1::ReadProjectResponse> Read(const StageCall& call,
                                                       MeshFile file) const = 0;
};

/// Client of the slicing service, which reads projects as well as meshes.
class RemoteProjects : public ProjectReader {
 public:
  /// Sends the calls to `replicas`, which must outlive this object.
  explicit RemoteProjects(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("slicing", replicas, options) {}

  absl::StatusOr<v1::ReadProjectResponse> Read(const StageCall& call, MeshFile file) const override;

 private:
  const StageClient client_;
};

}  // namespace slicefarm::coordinator
