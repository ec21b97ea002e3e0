#include "services/coordinator/remote/remote_projects.h"

#include <utility>

#include "common/wire/slicing_wire.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/remote/slice_files.h"
#include "slicefarm/v1/slicing.grpc.pb.h"

namespace slicefarm::coordinator {

absl::StatusOr<v1::ReadProjectResponse> RemoteProjects::Read(const StageCall& call,
                                                             MeshFile file) const {
  SliceInput input;
  input.files.push_back(std::move(file));
  return client_.Fitting(
      client_.Ask<v1::ReadProjectResponse>(
          call, client_.options().deadline, &v1::Slicing::Stub::PrepareAsyncReadProject,
          [&](auto& stream) { return WriteFiles(stream, call, input, {}); },
          [](v1::ReadProjectResponse& response, v1::ReadProjectResponse& project) {
            project = std::move(response);
            return absl::OkStatus();
          }),
      [](const v1::ReadProjectResponse& project) {
        return project.plates().empty() ? Malformed("plates", "are none") : absl::OkStatus();
      });
}

}  // namespace slicefarm::coordinator
