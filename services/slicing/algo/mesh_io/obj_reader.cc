#include "services/slicing/algo/mesh_io/obj_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/indexed_weld.h"
#include "services/slicing/algo/mesh_io/text_lines.h"

namespace slicefarm::slicing {
namespace {

/// Number of lines between two checks for cancellation.
constexpr int64_t kLinesPerPoll = 1 << 16;
/// Length limit of a line: three indices of ten digits for each corner of the largest face.
constexpr int64_t kMaxLineBytes = limits::kMaxFaceVertices * 33 + 16;

/// Keywords that the first statement of an OBJ file may begin with.
constexpr std::array<std::string_view, 13> kFirstStatements = {
    "v", "vn", "vt", "vp", "f", "o", "g", "s", "l", "p", "mtllib", "usemtl", "maplib"};

bool IsWordOfLetters(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// Returns the vertex index of a face corner: `7/1/3` gives 7. Returns nothing if the index is
/// invalid.
std::optional<int64_t> LeadingIndex(std::string_view corner) {
  const std::string_view digits = corner.substr(0, corner.find('/'));
  int64_t index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (error != std::errc() || end != digits.data() + digits.size() || index == 0)
    return std::nullopt;
  return index;
}

class ObjParser {
 public:
  ObjParser(std::string_view bytes, double coordinate_limit)
      : lines_(bytes, kMaxLineBytes, true), limit_(coordinate_limit) {}

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
    if (highest_ > mesh_.positions.size())
      return IndexError(static_cast<int64_t>(highest_), highest_line_);
    return std::move(mesh_);
  }

 private:
  absl::Status Statement(std::string_view line) {
    Words words(line);
    const std::string_view keyword = words.Next();
    if (keyword == "v") return Vertex(words);
    if (keyword == "f" || keyword == "fo") return Face(words);
    if (keyword.empty() || keyword[0] == '#' || IsWordOfLetters(keyword)) return absl::OkStatus();
    return lines_.Error(Reason::kMeshMalformed, "not a statement of an OBJ file");
  }

  absl::Status Vertex(Words& words) {
    if (std::ssize(mesh_.positions) >= kMaxVertices)
      return LimitError(Reason::kMeshTooLarge, "vertices", kMaxVertices, kMaxVertices + 1);
    std::array<double, 3> at;
    for (double& value : at) {
      const std::optional<double> number = ParseNumber(words.Next());
      if (!number) return lines_.Error(Reason::kMeshMalformed, "a vertex must have three numbers");
      if (!std::isfinite(*number))
        return lines_.Error(Reason::kMeshNotFinite, "a coordinate is not a finite number");
      if (std::abs(*number) > limit_)
        return lines_.Error(Reason::kOutOfRange, "a coordinate is more than 10 m from the origin");
      value = *number;
    }
    mesh_.positions.push_back({at[0], at[1], at[2]});
    return absl::OkStatus();
  }

  absl::Status Face(Words& words) {
    corners_.clear();
    for (std::string_view word = words.Next(); !word.empty(); word = words.Next()) {
      if (word[0] == '#') break;
      const std::optional<int64_t> index = LeadingIndex(word);
      if (!index)
        return lines_.Error(Reason::kMeshMalformed,
                            "an index of a face is not a number other than 0");
      const int64_t count = static_cast<int64_t>(mesh_.positions.size());
      const int64_t from_one = *index > 0 ? *index : count + 1 + *index;
      if (from_one < 1 || from_one > kMaxVertices) return IndexError(*index, lines_.number());
      if (corners_.size() >= static_cast<size_t>(limits::kMaxFaceVertices)) return FaceTooLarge();
      Remember(static_cast<size_t>(from_one));
      corners_.push_back(static_cast<uint32_t>(from_one - 1));
    }
    if (corners_.size() < 3)
      return lines_.Error(Reason::kMeshMalformed, "a face must have at least three corners");
    return Fan();
  }

  absl::Status Fan() {
    if (mesh_.triangles.size() + corners_.size() > static_cast<size_t>(limits::kMaxTriangles) + 2)
      return LimitError(Reason::kMeshTooLarge, "triangles", limits::kMaxTriangles,
                        static_cast<int64_t>(mesh_.triangles.size() + corners_.size() - 2));
    for (size_t i = 2; i < corners_.size(); ++i)
      mesh_.triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
    return absl::OkStatus();
  }

  /// Stores the largest vertex index used so far, and its line. A face may precede its vertices, so
  /// indices can be checked only at the end of the file.
  void Remember(size_t from_one) {
    if (from_one <= highest_) return;
    highest_ = from_one;
    highest_line_ = lines_.number();
  }

  absl::Status IndexError(int64_t index, int64_t line) const {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed,
                     fmt::format("a face refers to vertex {} of {} (line {})", index,
                                 mesh_.positions.size(), line),
                     {{"limit", std::to_string(mesh_.positions.size())},
                      {"got", std::to_string(index)},
                      {"line", std::to_string(line)}});
  }

  absl::Status FaceTooLarge() const {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed,
                     fmt::format("a face has more than {} corners (line {})",
                                 limits::kMaxFaceVertices, lines_.number()),
                     {{"limit", std::to_string(limits::kMaxFaceVertices)},
                      {"got", std::to_string(limits::kMaxFaceVertices + 1)},
                      {"line", std::to_string(lines_.number())}});
  }

  LineReader lines_;
  double limit_;
  RawMesh mesh_;
  std::vector<uint32_t> corners_;
  size_t highest_ = 0;
  int64_t highest_line_ = 0;
};

}  // namespace

bool LooksLikeObj(std::string_view bytes) {
  constexpr size_t kProbeBytes = 65'536;
  LineReader lines(bytes.substr(0, kProbeBytes), kMaxLineBytes, true);
  for (auto line = lines.Next(); line.ok() && line->has_value(); line = lines.Next()) {
    const std::string_view keyword = Words(**line).Next();
    if (keyword.empty() || keyword[0] == '#') continue;
    return std::find(kFirstStatements.begin(), kFirstStatements.end(), keyword) !=
           kFirstStatements.end();
  }
  return false;
}

absl::StatusOr<RawMesh> ReadObjAsNumbered(std::string_view bytes, double coordinate_limit,
                                          const CancelToken& cancel) {
  ObjParser parser(bytes, coordinate_limit);
  for (int64_t line = 0;; ++line) {
    if (line % kLinesPerPoll == 0 && cancel.Cancelled()) return cancel.Check();
    const absl::StatusOr<bool> more = parser.Step();
    if (!more.ok()) return more.status();
    if (!*more) return std::move(parser).Finish();
  }
}

absl::StatusOr<RawMesh> ReadObj(std::string_view bytes, double coordinate_limit,
                                const CancelToken& cancel) {
  const absl::StatusOr<RawMesh> mesh = ReadObjAsNumbered(bytes, coordinate_limit, cancel);
  if (!mesh.ok()) return mesh.status();
  return Welded(*mesh);
}

}  // namespace slicefarm::slicing
