#include "services/slicing/server/project_reading.h"

#include <utility>

#include "common/base/sha256.h"
#include "common/config/projects/project.h"
#include "common/model/limits.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/scene_wire.h"
#include "common/wire/support/wire_error.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"

namespace slicefarm::slicing {
namespace {

/// Returns the numbers (from 1) of the plates that can become a job. If all objects are on one
/// plate, returns only 0.
std::vector<int> PlatesToPrint(const Project& project) {
  std::vector<int> plates;
  for (size_t i = 0; i < project.plates.size(); ++i)
    if (!project.plates[i].members.empty()) plates.push_back(static_cast<int>(i) + 1);
  if (plates.empty()) plates.push_back(0);
  return plates;
}

void ToProto(const config::ProjectJob& job, const StoredMesh& file,
             v1::ReadProjectResponse::Plate* proto) {
  for (const SceneObject& object : job.objects)
    slicefarm::ToProto(object, {&file, 1}, proto->mutable_spec()->add_objects());
  SettingsToProto(job.settings, proto->mutable_spec()->mutable_project_settings());
  proto->mutable_spec()->mutable_without_effect()->Assign(job.without_effect.begin(),
                                                          job.without_effect.end());
  for (const std::string& warning : job.warnings) {
    proto->add_warnings(warning);
    proto->mutable_spec()->add_notes()->set_text(warning);
  }
  for (const config::MissingFeature& each : job.missing) {
    proto->add_warnings(each.text);
    v1::ProjectNote& note = *proto->mutable_spec()->add_notes();
    note.set_text(each.text);
    note.set_feature(each.feature);
  }
}

}  // namespace

ReadProjects MakeReadProjects(std::shared_ptr<const MeshSource> meshes) {
  return [meshes = std::move(meshes)](
             const MeshFile& file,
             const CancelToken& cancel) -> absl::StatusOr<v1::ReadProjectResponse> {
    if (DetectFormat(file.bytes) != MeshFormat::k3mf)
      return Malformed("mesh", "is not a 3MF project");
    const auto read = meshes->Read(file.bytes, MeshFormat::k3mf, limits::kMaxMeshCoordinateMm,
                                   ReadDepth::kStructure, cancel);
    if (!read.ok()) return read.status();
    const StoredMesh stored = {Sha256Hex(file.bytes), file.name, MeshFormat::k3mf};
    v1::ReadProjectResponse response;
    response.set_application(read->project.application);
    for (const int number : PlatesToPrint(read->project)) {
      const auto job = config::JobOfProject(read->project, number);
      if (!job.ok()) return job.status();
      v1::ReadProjectResponse::Plate& plate = *response.add_plates();
      plate.set_number(std::max(number, 1));
      if (number > 0) plate.set_name(read->project.plates[static_cast<size_t>(number) - 1].name);
      ToProto(*job, stored, &plate);
    }
    return response;
  };
}

}  // namespace slicefarm::slicing
