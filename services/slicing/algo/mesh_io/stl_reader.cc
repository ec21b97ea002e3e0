#include "services/slicing/algo/mesh_io/stl_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/mesh_builder.h"
#include "services/slicing/algo/mesh_io/text_lines.h"

namespace slicefarm::slicing {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

constexpr size_t kHeaderBytes = 84;
constexpr size_t kTriangleBytes = 50;
constexpr size_t kNormalBytes = 12;
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr size_t kTrianglesPerPoll = 1 << 16;

uint32_t ClaimedTriangles(std::string_view bytes) {
  uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderBytes - sizeof count, sizeof count);
  return count;
}

int64_t ExpectedBytes(uint32_t triangles) {
  return static_cast<int64_t>(kHeaderBytes) + static_cast<int64_t>(kTriangleBytes) * triangles;
}

absl::Status CheckLength(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) {
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kMeshTruncated,
        fmt::format("a binary STL has at least {} bytes, this file has {}", kHeaderBytes,
                    bytes.size()),
        {{"limit", std::to_string(kHeaderBytes)}, {"got", std::to_string(bytes.size())}});
  }
  const uint32_t count = ClaimedTriangles(bytes);
  if (count > limits::kMaxTriangles)
    return LimitError(Reason::kMeshTooLarge, "triangles claimed by the binary STL",
                      limits::kMaxTriangles, count);
  const int64_t expected = ExpectedBytes(count), got = static_cast<int64_t>(bytes.size());
  if (expected == got) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kInvalidArgument,
      expected > got ? Reason::kMeshTruncated : Reason::kMeshMalformed,
      fmt::format(
          "the binary STL header announces {} triangles, which take {} bytes; the file has {}",
          count, expected, got),
      {{"triangles", std::to_string(count)},
       {"limit", std::to_string(expected)},
       {"got", std::to_string(got)}});
}

std::array<Vector3, 3> CornersAt(const char* triangle) {
  std::array<float, 9> f;
  std::memcpy(f.data(), triangle + kNormalBytes, sizeof f);
  return {Vector3{f[0], f[1], f[2]}, Vector3{f[3], f[4], f[5]}, Vector3{f[6], f[7], f[8]}};
}

std::string_view FaultText(CoordinateFault fault) {
  return fault == CoordinateFault::kNotFinite ? "a coordinate is not a finite number"
                                              : "a coordinate is more than 10 m from the origin";
}

Reason FaultReason(CoordinateFault fault) {
  return fault == CoordinateFault::kNotFinite ? Reason::kMeshNotFinite : Reason::kOutOfRange;
}

absl::Status TriangleError(CoordinateFault fault, size_t triangle) {
  return MakeError(absl::StatusCode::kInvalidArgument, FaultReason(fault),
                   fmt::format("{} (triangle {})", FaultText(fault), triangle),
                   {{"triangle", std::to_string(triangle)}});
}

/// Returns the text without the UTF-8 byte order mark that some text editors write.
std::string_view WithoutMark(std::string_view text) {
  if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
  return text;
}

bool EqualsIgnoringCase(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

/// Parser of an ASCII STL file that tracks the expected next statement.
class AsciiParser {
 public:
  AsciiParser(std::string_view bytes, double coordinate_limit)
      : lines_(bytes, limits::kMaxAsciiLineBytes, false),
        // A facet has 7 lines and nearly always 100 bytes or more.
        builder_(std::min<size_t>(bytes.size() / 100, limits::kMaxTriangles), coordinate_limit) {}

  /// Reads one line. Returns false at the end of the text.
  absl::StatusOr<bool> Step() {
    const auto line = lines_.Next();
    if (!line.ok()) return line.status();
    if (!line->has_value()) return false;
    absl::Status status = Statement(**line);
    if (!status.ok()) return status;
    return true;
  }

  absl::StatusOr<RawMesh> Finish() && {
    if (in_facet_ || in_solid_)
      return lines_.Error(Reason::kMeshTruncated, "ASCII STL ends before `endsolid`");
    return std::move(builder_).Take();
  }

 private:
  absl::Status Statement(std::string_view line) {
    Words words(line);
    const std::string_view keyword = words.Next();
    if (keyword.empty()) return absl::OkStatus();
    if (EqualsIgnoringCase(keyword, "vertex")) return Vertex(words);
    if (EqualsIgnoringCase(keyword, "facet")) return Facet();
    if (EqualsIgnoringCase(keyword, "endfacet")) return EndFacet();
    if (EqualsIgnoringCase(keyword, "outer") || EqualsIgnoringCase(keyword, "endloop"))
      return absl::OkStatus();
    if (EqualsIgnoringCase(keyword, "solid") || EqualsIgnoringCase(keyword, "endsolid"))
      return Solid(EqualsIgnoringCase(keyword, "solid"));
    return lines_.Error(Reason::kMeshMalformed, "not a statement of an ASCII STL");
  }

  absl::Status Solid(bool begin) {
    if (in_facet_)
      return lines_.Error(Reason::kMeshMalformed, "the previous facet has no `endfacet`");
    in_solid_ = begin;
    return absl::OkStatus();
  }

  absl::Status Facet() {
    if (in_facet_)
      return lines_.Error(Reason::kMeshMalformed, "the previous facet has no `endfacet`");
    if (builder_.triangles() >= static_cast<size_t>(limits::kMaxTriangles))
      return LimitError(Reason::kMeshTooLarge, "triangles", limits::kMaxTriangles,
                        limits::kMaxTriangles + 1);
    in_facet_ = true;
    corner_ = 0;
    return absl::OkStatus();
  }

  absl::Status EndFacet() {
    if (!in_facet_ || corner_ != 3)
      return lines_.Error(Reason::kMeshMalformed, "a facet must have three vertices");
    builder_.Add(corners_);
    in_facet_ = false;
    return absl::OkStatus();
  }

  absl::Status Vertex(Words& words) {
    if (!in_facet_ || corner_ == 3)
      return lines_.Error(Reason::kMeshMalformed, "a facet must have three vertices");
    const auto x = ParseNumber(words.Next()), y = ParseNumber(words.Next()),
               z = ParseNumber(words.Next());
    if (!x || !y || !z)
      return lines_.Error(Reason::kMeshMalformed, "a vertex must have three numbers");
    const Vector3 position{*x, *y, *z};
    const CoordinateFault fault = builder_.Check(position);
    if (fault != CoordinateFault::kNone) return lines_.Error(FaultReason(fault), FaultText(fault));
    corners_[corner_++] = position;
    return absl::OkStatus();
  }

  LineReader lines_;
  MeshBuilder builder_;
  std::array<Vector3, 3> corners_;
  int corner_ = 0;
  bool in_facet_ = false;
  bool in_solid_ = false;
};

}  // namespace

bool IsBinaryStl(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes &&
         ExpectedBytes(ClaimedTriangles(bytes)) == static_cast<int64_t>(bytes.size());
}

bool LooksLikeAsciiStl(std::string_view bytes) {
  constexpr size_t kProbeBytes = 4096;
  const std::string_view probe = WithoutMark(bytes).substr(0, kProbeBytes);
  if (!EqualsIgnoringCase(Words(probe).Next(), "solid")) return false;
  // Binary exporters may also write `solid` at the start, but a zero byte follows soon after it.
  return probe.find('\0') == std::string_view::npos;
}

absl::StatusOr<RawMesh> ReadBinaryStl(std::string_view bytes, double coordinate_limit,
                                      const CancelToken& cancel) {
  if (absl::Status status = CheckLength(bytes); !status.ok()) return status;
  const size_t count = ClaimedTriangles(bytes);
  MeshBuilder builder(count, coordinate_limit);
  const char* at = bytes.data() + kHeaderBytes;
  for (size_t i = 0; i < count; ++i, at += kTriangleBytes) {
    if (i % kTrianglesPerPoll == 0 && cancel.Cancelled()) return cancel.Check();
    const std::array<Vector3, 3> corners = CornersAt(at);
    for (const Vector3& corner : corners) {
      const CoordinateFault fault = builder.Check(corner);
      if (fault != CoordinateFault::kNone) return TriangleError(fault, i);
    }
    builder.Add(corners);
  }
  return std::move(builder).Take();
}

absl::StatusOr<RawMesh> ReadAsciiStl(std::string_view bytes, double coordinate_limit,
                                     const CancelToken& cancel) {
  AsciiParser parser(WithoutMark(bytes), coordinate_limit);
  for (size_t line = 0;; ++line) {
    if (line % kTrianglesPerPoll == 0 && cancel.Cancelled()) return cancel.Check();
    const absl::StatusOr<bool> more = parser.Step();
    if (!more.ok()) return more.status();
    if (!*more) return std::move(parser).Finish();
  }
}

}  // namespace slicefarm::slicing
