#include "services/slicing/algo/mesh_io/threemf/threemf_reader.h"

#include "services/slicing/algo/mesh_io/threemf/package.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive.h"
#include "services/slicing/algo/mesh_io/threemf/project.h"
#include "services/slicing/algo/mesh_io/threemf/settings/metadata.h"

namespace slicefarm::slicing {

bool LooksLike3mf(std::string_view bytes) {
  constexpr std::string_view kLocalHeader = "PK\x03\x04";
  return bytes.starts_with(kLocalHeader);
}

absl::StatusOr<MeshFileContents> Read3mf(std::string_view bytes, double coordinate_limit,
                                         ReadDepth depth, const CancelToken& cancel) {
  const absl::StatusOr<threemf::Archive> archive = threemf::Archive::Open(bytes);
  if (!archive.ok()) return archive.status();
  threemf::MeshReading reading;
  reading.keep = depth != ReadDepth::kStructure;
  reading.coordinate_limit_mm = coordinate_limit;
  absl::StatusOr<threemf::Package> package = threemf::ReadPackage(*archive, reading, cancel);
  if (!package.ok()) return package.status();
  absl::StatusOr<threemf::Metadata> metadata = threemf::ReadMetadata(*archive);
  if (!metadata.ok()) return metadata.status();
  const absl::StatusOr<std::vector<std::string>> idle = threemf::FilesWithoutEffect(*archive);
  if (!idle.ok()) return idle.status();
  absl::StatusOr<Project> project = threemf::MakeProject(*package, *std::move(metadata));
  if (!project.ok()) return project.status();
  project->without_effect.insert(project->without_effect.end(), idle->begin(), idle->end());
  MeshFileContents contents;
  if (reading.keep) contents.meshes = std::move(package->meshes);
  contents.project = *std::move(project);
  return contents;
}

}  // namespace slicefarm::slicing
