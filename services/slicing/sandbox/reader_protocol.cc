#include "services/slicing/sandbox/reader_protocol.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "absl/strings/str_split.h"
#include "common/base/build_info.h"
#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/threemf/threemf_reader.h"
#include "services/slicing/sandbox/project_check.h"
#include "services/slicing/sandbox/project_codec.h"

namespace slicefarm::slicing {
namespace {

constexpr size_t kMaxErrorBytes = 16 << 10;

/// Reasons of ReadMesh errors.
constexpr Reason kReadingReasons[] = {
    Reason::kMeshFormatUnknown, Reason::kMeshTruncated, Reason::kMeshMalformed,
    Reason::kMeshNotFinite,     Reason::kMeshEmpty,     Reason::kMeshTooLarge,
    Reason::kOutOfRange,
};

absl::Status Nonsense(std::string_view what) {
  return ReaderCrashed(fmt::format("answered nonsense: {}", what));
}

/// Largest size of an encoded project: more than limits::kMaxProjectBytes of text, because of
/// transforms and the lengths of texts.
constexpr uint64_t kMostProjectBytes = 2 * limits::kMaxProjectBytes;

bool IsSoundContentsHead(const AnswerHead& head, const Request& request) {
  const bool good_meshes = request.depth == ReadDepth::kStructure
                               ? head.meshes == 0
                               : head.meshes > 0 && head.meshes <= limits::kMaxFileResources;
  return head.error_bytes == 0 && good_meshes && head.project_bytes > 0 &&
         head.project_bytes <= kMostProjectBytes;
}

bool IsSoundErrorHead(const AnswerHead& head) {
  return head.error_bytes > 0 && head.error_bytes <= kMaxErrorBytes;
}

}  // namespace

absl::Status ReaderCrashed(std::string_view how, std::map<std::string, std::string> metadata) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshReaderCrashed,
                   fmt::format("the process that read this mesh {}", how), std::move(metadata));
}

BuildIdBytes ThisBuild() {
  BuildIdBytes bytes = {};
  const std::string_view id = BuildId();
  std::copy_n(id.begin(), std::min(id.size(), bytes.size()), bytes.begin());
  return bytes;
}

/// Encodes an error as NUL-separated texts: reason, message, key, value, key, value, ... No text of
/// this program has a NUL.
std::string EncodeError(const absl::Status& error) {
  const ErrorDetail detail = DetailOf(error);
  std::string text(ReasonName(detail.reason));
  const auto add = [&text](std::string_view part) { text.append(1, '\0').append(part); };
  add({error.message().data(), error.message().size()});
  for (const auto& [key, value] : detail.metadata) {
    add(key);
    add(value);
  }
  return text.substr(0, kMaxErrorBytes);
}

Request RequestOf(std::string_view file, ReadDepth depth) {
  const auto bytes = static_cast<int64_t>(file.size());
  if (!LooksLike3mf(file)) return {bytes, depth};
  const int64_t most = limits::kFreeExpandedBytes + limits::kMaxCompressionRatio * bytes;
  return {std::min(most, limits::kMaxExpandedArchiveBytes), depth};
}

absl::Status CheckHead(const AnswerHead& head, const Request& request) {
  if (head.build_id != ThisBuild())
    return MakeError(
        absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch,
        "slicefarm-mesh-reader is of another build than this service: restart the service");
  switch (head.kind) {
    case AnswerKind::kContents:
      return IsSoundContentsHead(head, request) ? absl::OkStatus() : Nonsense("impossible counts");
    case AnswerKind::kError:
    case AnswerKind::kNotConfined:
      return IsSoundErrorHead(head) ? absl::OkStatus() : Nonsense("an impossible error");
  }
  return Nonsense("neither a mesh nor an error");
}

// No format stores a triangle or a vertex in less than a byte; this holds for paint too.
MeshHeads::MeshHeads(const Request& request)
    : triangles_left_(
          std::min<uint64_t>(static_cast<uint64_t>(request.text_bytes), limits::kMaxTriangles)),
      positions_left_(static_cast<uint64_t>(request.text_bytes)) {}

absl::Status MeshHeads::Check(const MeshHead& head) {
  // Every position is used by at least one triangle; so there are at most three per triangle.
  const bool sound = head.triangles <= triangles_left_ &&
                     head.positions <= std::min(positions_left_, 3 * head.triangles) &&
                     (head.positions > 0) == (head.triangles > 0);
  if (!sound) return Nonsense("impossible counts");
  triangles_left_ -= head.triangles;
  positions_left_ -= head.positions;
  return absl::OkStatus();
}

absl::Status DecodeError(std::string_view encoded) {
  const std::vector<std::string> parts =
      absl::StrSplit(absl::string_view(encoded.data(), encoded.size()), '\0');
  const auto reason = ReasonFromName(parts[0]);
  const bool known = reason.has_value() &&
                     std::find(std::begin(kReadingReasons), std::end(kReadingReasons), *reason) !=
                         std::end(kReadingReasons);
  if (!known || parts.size() < 2) return Nonsense("an error that reading does not have");
  std::map<std::string, std::string> metadata;
  for (size_t i = 2; i + 1 < parts.size(); i += 2) metadata[parts[i]] = parts[i + 1];
  return MakeError(absl::StatusCode::kInvalidArgument, *reason, parts[1], std::move(metadata));
}

absl::Status CheckMesh(const RawMesh& mesh, double coordinate_limit) {
  const size_t count = mesh.positions.size();
  const bool indices_good =
      std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [count](const auto& triangle) {
        return triangle[0] < count && triangle[1] < count && triangle[2] < count;
      });
  if (!indices_good) return Nonsense("a triangle over a vertex that is not there");
  // Neither NaN nor infinity is within a limit.
  const auto within = [coordinate_limit](double value) {
    return std::abs(value) <= coordinate_limit;
  };
  const bool positions_good = std::all_of(
      mesh.positions.begin(), mesh.positions.end(),
      [&within](const Vector3& p) { return within(p.x()) && within(p.y()) && within(p.z()); });
  return positions_good ? absl::OkStatus() : Nonsense("a coordinate that is out of range");
}

absl::StatusOr<Project> CheckedProject(std::string_view encoded, std::span<const RawMesh> meshes,
                                       ReadDepth depth) {
  absl::StatusOr<Project> project = DecodeProject(encoded);
  if (!project.ok())
    return Nonsense(
        std::string_view(project.status().message().data(), project.status().message().size()));
  std::vector<int64_t> triangles;
  for (const RawMesh& mesh : meshes)
    triangles.push_back(static_cast<int64_t>(mesh.triangles.size()));
  const auto of_meshes = depth != ReadDepth::kStructure
                             ? std::optional(std::span<const int64_t>(triangles))
                             : std::nullopt;
  const std::string_view fault = FaultOf(*project, of_meshes);
  if (!fault.empty()) return Nonsense(fault);
  return project;
}

}  // namespace slicefarm::slicing
