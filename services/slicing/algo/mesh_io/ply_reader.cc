#include "services/slicing/algo/mesh_io/ply_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/indexed_weld.h"
#include "services/slicing/algo/mesh_io/ply_header.h"
#include "services/slicing/algo/mesh_io/ply_values.h"

namespace slicefarm::slicing {
namespace {

/// Number of elements between two checks for cancellation.
constexpr int64_t kElementsPerPoll = 1 << 16;

/// Purpose of a property for this reader.
enum class Use : uint8_t { kX, kY, kZ, kCorners, kNone };

Use UseOf(const PlyElement& element, const PlyProperty& property) {
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  if (element.name == "vertex" && !property.is_list) {
    const auto* const axis = std::find(kAxes.begin(), kAxes.end(), property.name);
    if (axis != kAxes.end()) return static_cast<Use>(axis - kAxes.begin());
  }
  const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
  return element.name == "face" && property.is_list && corners ? Use::kCorners : Use::kNone;
}

std::vector<Use> UsesOf(const PlyElement& element) {
  std::vector<Use> uses;
  for (const PlyProperty& property : element.properties) uses.push_back(UseOf(element, property));
  return uses;
}

/// Parser of the data behind a header, number by number. It never trusts a count in the file when
/// it allocates memory.
template <typename Values>
class PlyParser {
 public:
  PlyParser(std::string_view data, double coordinate_limit, const CancelToken& cancel)
      : values_(data), limit_(coordinate_limit), cancel_(cancel) {}

  absl::StatusOr<RawMesh> Run(const PlyHeader& header) && {
    for (const PlyElement& element : header.elements)
      if (absl::Status status = All(element); !status.ok()) return status;
    if (highest_ >= static_cast<int64_t>(mesh_.positions.size())) return IndexError();
    return Welded(mesh_);
  }

 private:
  absl::Status All(const PlyElement& element) {
    if (element.properties.empty()) return absl::OkStatus();
    const std::vector<Use> uses = UsesOf(element);
    const bool vertices = element.name == "vertex";
    for (Use axis : {Use::kX, Use::kY, Use::kZ}) {
      if (vertices && std::count(uses.begin(), uses.end(), axis) != 1)
        return Malformed("a vertex must have one x, y and z each");
    }
    if (vertices && element.count > kMaxVertices)
      return LimitError(Reason::kMeshTooLarge, "vertices", kMaxVertices, element.count);
    element_ = &element;
    for (index_ = 0; index_ < element.count; ++index_) {
      if (index_ % kElementsPerPoll == 0 && cancel_.Cancelled()) return cancel_.Check();
      absl::Status status = One(uses);
      if (status.ok() && vertices) status = Vertex();
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  }

  absl::Status One(const std::vector<Use>& uses) {
    for (size_t i = 0; i < uses.size(); ++i) {
      const PlyProperty& property = element_->properties[i];
      const std::optional<double> number =
          values_.Next(property.is_list ? property.count_type : property.type);
      if (!number) return NoNumber();
      absl::Status status;
      if (property.is_list)
        status = List(property.type, *number, uses[i]);
      else if (uses[i] != Use::kNone)
        at_[static_cast<size_t>(uses[i])] = *number;
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  }

  absl::Status Vertex() {
    for (const double value : at_) {
      if (!std::isfinite(value))
        return Error(Reason::kMeshNotFinite, "a coordinate is not a finite number");
      if (std::abs(value) > limit_)
        return Error(Reason::kOutOfRange, "a coordinate is more than 10 m from the origin");
    }
    mesh_.positions.push_back({at_[0], at_[1], at_[2]});
    return absl::OkStatus();
  }

  absl::Status List(PlyType type, double length, Use use) {
    // In an ASCII file, a list's length may be written as any number, also negative or with
    // decimals.
    if (!(length >= 0 && length <= UINT32_MAX && length == std::floor(length)))
      return Malformed("the length of a list is invalid");
    const auto count = static_cast<int64_t>(length);
    if (use == Use::kCorners && count > limits::kMaxFaceVertices)
      return Malformed(fmt::format("a face has more than {} corners", limits::kMaxFaceVertices));
    corners_.clear();
    for (int64_t i = 0; i < count; ++i) {
      const std::optional<double> item = values_.Next(type);
      if (!item) return NoNumber();
      if (use != Use::kCorners) continue;
      if (!(*item >= 0 && *item < kMaxVertices && *item == std::floor(*item)))
        return Malformed("an index of a face is invalid");
      corners_.push_back(static_cast<uint32_t>(*item));
    }
    return use == Use::kCorners ? Fan() : absl::OkStatus();
  }

  absl::Status Fan() {
    if (corners_.size() < 3) return Malformed("a face must have at least three corners");
    const size_t after = mesh_.triangles.size() + corners_.size() - 2;
    if (after > static_cast<size_t>(limits::kMaxTriangles))
      return LimitError(Reason::kMeshTooLarge, "triangles", limits::kMaxTriangles,
                        static_cast<int64_t>(after));
    for (const uint32_t corner : corners_) {
      if (corner <= highest_) continue;
      highest_ = corner;
      highest_face_ = index_;
    }
    for (size_t i = 2; i < corners_.size(); ++i)
      mesh_.triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
    return absl::OkStatus();
  }

  absl::Status NoNumber() const {
    if (values_.malformed()) return Malformed("not a number");
    return Error(Reason::kMeshTruncated, fmt::format("the file ends before its {} elements `{}`",
                                                     element_->count, element_->name));
  }

  /// Returns the error for a vertex index that does not exist. Faces may precede the vertices, so
  /// indices can be checked only at the end.
  absl::Status IndexError() const {
    const size_t count = mesh_.positions.size();
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed,
        fmt::format("a face refers to vertex {} of {} (face {})", highest_, count, highest_face_),
        {{"limit", std::to_string(count)},
         {"got", std::to_string(highest_)},
         {"face", std::to_string(highest_face_)}});
  }

  absl::Status Malformed(std::string_view what) const {
    return Error(Reason::kMeshMalformed, what);
  }

  absl::Status Error(Reason reason, std::string_view what) const {
    if (element_ == nullptr)
      return MakeError(absl::StatusCode::kInvalidArgument, reason, std::string(what));
    return MakeError(absl::StatusCode::kInvalidArgument, reason,
                     fmt::format("{} ({} {})", what, element_->name, index_),
                     {{"element", element_->name}, {"index", std::to_string(index_)}});
  }

  Values values_;
  double limit_;
  const CancelToken& cancel_;
  const PlyElement* element_ = nullptr;
  int64_t index_ = 0;
  std::array<double, 3> at_ = {};
  std::vector<uint32_t> corners_;
  RawMesh mesh_;
  int64_t highest_ = -1;
  int64_t highest_face_ = 0;
};

}  // namespace

bool LooksLikePly(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n");
}

absl::StatusOr<RawMesh> ReadPly(std::string_view bytes, double coordinate_limit,
                                const CancelToken& cancel) {
  if (!LooksLikePly(bytes))
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed,
                     "a PLY file must begin with a line `ply` (line 1)", {{"line", "1"}});
  absl::StatusOr<PlyHeader> header = ReadPlyHeader(bytes);
  if (!header.ok()) return header.status();
  const std::string_view data = bytes.substr(header->bytes);
  switch (header->encoding) {
    case PlyEncoding::kAscii:
      return PlyParser<PlyText>(data, coordinate_limit, cancel).Run(*header);
    case PlyEncoding::kLittleEndian:
      return PlyParser<PlyBinary<std::endian::little>>(data, coordinate_limit, cancel).Run(*header);
    case PlyEncoding::kBigEndian:
      return PlyParser<PlyBinary<std::endian::big>>(data, coordinate_limit, cancel).Run(*header);
  }
  return absl::InternalError("the encoding is invalid");
}

}  // namespace slicefarm::slicing
