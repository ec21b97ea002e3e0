#include "services/slicing/algo/mesh_io/threemf/mesh_collector.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/indexed_weld.h"
#include "services/slicing/algo/mesh_io/text_lines.h"
#include "services/slicing/algo/mesh_io/threemf/paint/paint_code.h"

namespace slicefarm::slicing::threemf {
namespace {

absl::Status Bad(Reason reason, std::string_view what) {
  return MakeError(absl::StatusCode::kInvalidArgument, reason, what);
}

std::optional<uint32_t> ParseIndex(std::string_view text) {
  uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

std::string_view WithoutPrefix(std::string_view name) {
  return name.substr(name.find(':') + 1);  // the whole name if there is no colon
}

// PrusaSlicer uses the first name (with a prefix), Bambu Studio and OrcaSlicer use the second name.

bool IsSeamPaint(std::string_view name) {
  name = WithoutPrefix(name);
  return name == "custom_seam" || name == "paint_seam";
}

bool IsSupportPaint(std::string_view name) {
  name = WithoutPrefix(name);
  return name == "custom_supports" || name == "paint_supports";
}

uint8_t PaintOf(std::string_view name) {
  name = WithoutPrefix(name);
  if (name == "mmu_segmentation" || name == "paint_color") return kPaintedColours;
  if (name == "fuzzy_skin" || name == "paint_fuzzy_skin") return kPaintedFuzzySkin;
  return 0;
}

}  // namespace

absl::Status MeshCollector::Vertex(XmlAttributes attributes) {
  std::array<double, 3> at;
  unsigned seen = 0;
  for (const XmlAttribute& attribute : attributes) {
    if (attribute.name.size() != 1 || attribute.name[0] < 'x' || attribute.name[0] > 'z') continue;
    const auto axis = static_cast<size_t>(attribute.name[0] - 'x');
    std::optional<double> number = ParseNumber(attribute.value);
    if (!number) number = ParseNumber(Words(attribute.value).Next());
    if (!number) return Malformed("a coordinate is not a number");
    at[axis] = *number * unit_mm_;
    if (!(std::abs(at[axis]) <= reading_.coordinate_limit_mm))
      return std::isfinite(*number)
                 ? Bad(Reason::kOutOfRange, "a coordinate is more than 10 m from the origin")
                 : Bad(Reason::kMeshNotFinite, "a coordinate is not a finite number");
    seen |= 1u << axis;
  }
  if (seen != 7) return Malformed("a vertex must have x, y and z");
  if (++reading_.vertices > kMaxVertices)
    return LimitError(Reason::kMeshTooLarge, "vertices", kMaxVertices, reading_.vertices);
  ++vertices_;
  if (reading_.keep) mesh_.positions.push_back({at[0], at[1], at[2]});
  return absl::OkStatus();
}

absl::Status MeshCollector::Triangle(XmlAttributes attributes) {
  std::array<uint32_t, 3> corners;
  unsigned seen = 0;
  std::string_view seam, support;
  for (const XmlAttribute& attribute : attributes) {
    const std::string_view name = attribute.name;
    if (name.size() != 2 || name[0] != 'v' || name[1] < '1' || name[1] > '3') {
      if (IsSeamPaint(name)) seam = attribute.value;
      if (IsSupportPaint(name)) support = attribute.value;
      Note(attribute);
      continue;
    }
    const auto corner = static_cast<size_t>(name[1] - '1');
    const std::optional<uint32_t> index = ParseIndex(attribute.value);
    if (!index) return Malformed("a corner is not the index of a vertex");
    if (*index >= vertices_)
      return LimitError(Reason::kMeshMalformed, "a corner's vertex, from 0", vertices_ - 1, *index);
    corners[corner] = *index;
    seen |= 1u << corner;
  }
  if (seen != 7) return Malformed("a triangle must have v1, v2 and v3");
  if (absl::Status status = CountTriangle(); !status.ok()) return status;
  ++triangles_;
  if (reading_.keep) mesh_.triangles.push_back(corners);
  absl::Status status;
  if (!seam.empty()) status = AddMarks(seam, corners, seams_);
  if (status.ok() && !support.empty()) status = AddMarks(support, corners, supports_);
  return status;
}

absl::Status MeshCollector::CountTriangle() {
  if (++reading_.triangles > limits::kMaxTriangles)
    return LimitError(Reason::kMeshTooLarge, "triangles", limits::kMaxTriangles,
                      reading_.triangles);
  return absl::OkStatus();
}

absl::Status MeshCollector::AddMarks(std::string_view code, const std::array<uint32_t, 3>& corners,
                                     Marks& marks) {
  Facet facet;
  if (reading_.keep)
    for (size_t i = 0; i < 3; ++i) facet[i] = mesh_.positions[corners[i]];
  const absl::StatusOr<std::vector<PaintedPiece>> pieces = PaintedPieces(code, facet);
  if (!pieces.ok()) return pieces.status();
  for (const PaintedPiece& piece : *pieces) {
    if (piece.state == PaintState::kNone) continue;
    if (absl::Status status = CountTriangle(); !status.ok()) return status;
    const bool enforcer = piece.state == PaintState::kEnforcer;
    ++(enforcer ? marks.paint.enforcers : marks.paint.blockers).triangles;
    if (reading_.keep) (enforcer ? marks.enforcers : marks.blockers).Add(piece.corners);
  }
  return absl::OkStatus();
}

void MeshCollector::Note(const XmlAttribute& attribute) {
  if (attribute.value.empty()) return;
  if (attribute.name == "pid" || attribute.name == "p1") coloured_ = true;
  paint_ |= PaintOf(attribute.name);
}

MarkPaint MeshCollector::Marks::Take() {
  paint.enforcers.mesh = std::move(enforcers).Take();
  paint.blockers.mesh = std::move(blockers).Take();
  return std::move(paint);
}

MeshPaint MeshCollector::TakeMarks() { return {seams_.Take(), supports_.Take()}; }

RawMesh MeshCollector::Take() && { return Welded(mesh_); }

}  // namespace slicefarm::slicing::threemf
