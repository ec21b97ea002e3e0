#include "services/coordinator/server/api/derived_artifacts.h"

#include <fmt/core.h>

#include <optional>
#include <utility>

#include "common/base/cancel_scope.h"
#include "common/base/error.h"
#include "services/coordinator/algo/program_contents.h"
#include "services/coordinator/server/api/artifact.h"
#include "services/coordinator/store/blobs/checking_reader.h"

namespace slicefarm::coordinator {
namespace {

/// Size of the beginning of a program that contains the thumbnails. Each has at most some hundred
/// KiB.
constexpr int64_t kBeginningBytes = 4 << 20;

absl::Status HasNone(const JobRecord& job, std::string_view what) {
  return MakeError(absl::StatusCode::kNotFound, Reason::kBlobNotFound,
                   fmt::format("the program of job {} has no {}", job.id, what), {{"job", job.id}});
}

absl::StatusOr<std::string> ReportOf(const JobRecord& job, BlobStore& blobs) {
  const auto digest = ArtifactOf(job, v1::ARTIFACT_REPORT);
  if (!digest.ok()) return digest.status();
  return blobs.Get(*digest);
}

absl::StatusOr<std::string> LayersOf(const JobRecord& job, const std::shared_ptr<BlobStore>& blobs,
                                     const std::string& report) {
  const auto digest = ArtifactOf(job, v1::ARTIFACT_GCODE);
  if (!digest.ok()) return digest.status();
  const auto program = OpenToStream(blobs, *digest);
  if (!program.ok()) return program.status();
  LayerScan scan;
  for (int64_t at = 0; at < (*program)->size();) {
    if (absl::Status wanted = CancelScope::Current().Check(); !wanted.ok()) return wanted;
    const auto piece = (*program)->Read(at, kBlobPieceBytes);
    if (!piece.ok()) return piece.status();
    scan.Add(*piece);
    at += std::ssize(*piece);
  }
  const std::vector<ProgramLayer> layers = std::move(scan).Layers();
  if (layers.empty()) return HasNone(job, "comments that mark layers");
  return LayersJson(layers, LayerTimesOf(report));
}

absl::StatusOr<std::string> ThumbnailOf(const JobRecord& job, BlobStore& blobs) {
  const auto digest = ArtifactOf(job, v1::ARTIFACT_GCODE);
  if (!digest.ok()) return digest.status();
  const auto program = blobs.Open(*digest);
  if (!program.ok()) return program.status();
  const auto beginning = (*program)->Read(0, kBeginningBytes);
  if (!beginning.ok()) return beginning.status();
  auto largest = LargestThumbnail(*beginning);
  return largest ? absl::StatusOr<std::string>(*std::move(largest)) : HasNone(job, "thumbnail");
}

void Add(v1::Artifact artifact, const std::string& name, int64_t size, const std::string& sha256,
         v1::ListArtifactsResponse& list) {
  v1::ListArtifactsResponse::Info& info = *list.add_artifacts();
  info.set_artifact(artifact);
  info.set_media_type(std::string(MediaTypeOf(name)));
  info.set_file_name(name);
  info.set_size(size);
  info.set_sha256(sha256);
}

/// Adds a derived artifact to the list. Adds nothing if the program does not have it.
absl::Status AddDerived(v1::Artifact artifact, const std::string& name,
                        const absl::StatusOr<DerivedFacts::Fact>& fact,
                        v1::ListArtifactsResponse& list) {
  if (absl::IsNotFound(fact.status())) return absl::OkStatus();
  if (fact.ok()) Add(artifact, name, fact->size, fact->sha256, list);
  return fact.status();
}

}  // namespace

bool IsDerived(v1::Artifact artifact) {
  return artifact == v1::ARTIFACT_LAYERS || artifact == v1::ARTIFACT_THUMBNAIL;
}

absl::StatusOr<std::string> Derive(const JobRecord& job, v1::Artifact artifact, BlobStores& blobs) {
  const auto program = ArtifactOf(job, v1::ARTIFACT_GCODE);
  if (!program.ok()) return program.status();
  const auto store = blobs.Of(job.result->tenant);
  if (!store.ok()) return store.status();
  if (artifact == v1::ARTIFACT_THUMBNAIL) return ThumbnailOf(job, **store);
  const auto report = ReportOf(job, **store);
  if (!report.ok()) return report.status();
  return LayersOf(job, *store, *report);
}

absl::StatusOr<v1::ListArtifactsResponse> ListArtifacts(const JobRecord& job, BlobStores& blobs,
                                                        DerivedFacts& facts) {
  const auto digest = ArtifactOf(job, v1::ARTIFACT_REPORT);
  if (!digest.ok()) return digest.status();
  const auto store = blobs.Of(job.result->tenant);
  if (!store.ok()) return store.status();
  const auto report = ReportOf(job, **store);
  if (!report.ok()) return report.status();
  const std::string name = ProgramName(*report, job.id);
  const std::string stem = name.substr(0, name.rfind('.'));
  v1::ListArtifactsResponse list;
  if (!job.result->gcode_sha256.empty()) {
    Add(v1::ARTIFACT_GCODE, name, job.result->gcode_size, job.result->gcode_sha256, list);
    const auto fact = [&](const std::string& kind, const DerivedFacts::Make& make) {
      return facts.Of(kind + job.result->gcode_sha256 + *digest, CancelScope::Current(), make);
    };
    absl::Status added =
        AddDerived(v1::ARTIFACT_LAYERS, stem + ".layers.json",
                   fact("layers", [&] { return LayersOf(job, *store, *report); }), list);
    if (!added.ok()) return added;
    added = AddDerived(v1::ARTIFACT_THUMBNAIL, stem + ".png",
                       fact("thumbnail", [&] { return ThumbnailOf(job, **store); }), list);
    if (!added.ok()) return added;
  }
  Add(v1::ARTIFACT_REPORT, stem + ".report.json", std::ssize(*report), *digest, list);
  return list;
}

}  // namespace slicefarm::coordinator
