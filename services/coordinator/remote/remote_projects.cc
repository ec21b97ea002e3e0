#include "services/coordinator/remote/remote_projects.h"

#include <utility>

#include "common/wire/slicing_wire.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/remote/slice_files.h"
#include "slicefarm/v1/slicing.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

constexpr char kReader[] = "slicing";

}  // namespace

absl::StatusOr<v1::ReadProjectResponse> RemoteProjects::Read(const StageCall& call,
                                                             MeshFile file) const {
  SliceInput input;
  input.files.push_back(std::move(file));
  v1::ReadProjectResponse project;
  const absl::Status status = StreamOver(
      replicas_, options_.deadline, call, kReader, &v1::Slicing::Stub::PrepareAsyncReadProject,
      [&](auto& stream) { return WriteFiles(stream, call, input, {}); },
      [&](auto& stream) {
        stream.Read(&project);  // if there is none, the call's end says why
        return absl::OkStatus();
      });
  if (!status.ok()) return status;
  if (project.plates().empty()) return BadAnswer(kReader, Malformed("plates", "are none"));
  return project;
}

}  // namespace slicefarm::coordinator
