#include "services/slicing/sandbox/reader_protocol.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "absl/strings/str_split.h"
#include "common/base/build_info.h"
#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::slicing {
namespace {

constexpr size_t kMaxErrorBytes = 16 << 10;

/// Of ReadMesh.
constexpr Reason kReadingReasons[] = {
    Reason::kMeshFormatUnknown, Reason::kMeshTruncated, Reason::kMeshMalformed,
    Reason::kMeshNotFinite,     Reason::kMeshEmpty,     Reason::kMeshTooLarge,
    Reason::kOutOfRange,
};

absl::Status Nonsense(std::string_view what) {
  return ReaderCrashed(fmt::format("answered nonsense: {}", what));
}

/// No format says a triangle or a vertex in less than two bytes.
constexpr uint64_t kLeastBytesEach = 2;

bool IsSoundMeshHead(const AnswerHead& head, int64_t file_bytes) {
  const uint64_t most = static_cast<uint64_t>(file_bytes) / kLeastBytesEach;
  return head.error_bytes == 0 && head.triangles > 0 && head.positions > 0 &&
         head.triangles <= std::min<uint64_t>(most, limits::kMaxTriangles) &&
         head.positions <= std::min(most, 3 * head.triangles);
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

/// NUL-separated: reason, message, key, value, key, value, ... None of our texts has a NUL.
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

absl::Status CheckHead(const AnswerHead& head, int64_t file_bytes) {
  if (head.build_id != ThisBuild())
    return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch,
                     "slicefarm-mesh-reader is of another build than this service: start the "
                     "service anew");
  switch (head.kind) {
    case AnswerKind::kMesh:
      return IsSoundMeshHead(head, file_bytes) ? absl::OkStatus() : Nonsense("impossible counts");
    case AnswerKind::kError:
    case AnswerKind::kNotConfined:
      return IsSoundErrorHead(head) ? absl::OkStatus() : Nonsense("an impossible error");
  }
  return Nonsense("neither a mesh nor an error");
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
      [&within](const Position& p) { return within(p.x) && within(p.y) && within(p.z); });
  return positions_good ? absl::OkStatus() : Nonsense("a coordinate that is out of range");
}

}  // namespace slicefarm::slicing
