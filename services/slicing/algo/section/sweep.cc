#include "services/slicing/algo/section/sweep.h"

#include <algorithm>
#include <array>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::slicing {
namespace {

/// Number of faces by which memory is prefetched. The faces of a layer are scattered over the mesh,
/// so prefetching halves the time.
constexpr uint32_t kAhead = 8;

/// States of a segment.
enum : uint8_t { kFree, kHead, kTaken };

/// Tables of half-edges of a face, indexed by three bits: bit i is set if corner i is above the
/// plane. kRising: the half-edge that rises through the plane; kFalling: the one that falls. A line
/// from the falling to the rising half-edge has the material on its left.
constexpr std::array<uint8_t, 8> kRising = {0, 2, 0, 2, 1, 1, 0, 0};
constexpr std::array<uint8_t, 8> kFalling = {0, 0, 1, 1, 2, 0, 2, 0};

/// Returns a * b / c rounded to the nearest integer, halves away from zero. REQUIRES: |a| < 2^32, 0
/// < b <= c < 2^32; then |a| b + c / 2 fits 64 bits without a sign.
Coord ScaledRounded(Coord a, uint64_t b, uint64_t c) {
  const uint64_t size = static_cast<uint64_t>(a < 0 ? -a : a);
  const Coord result = static_cast<Coord>((size * b + c / 2) / c);
  return a < 0 ? -result : result;
}

void AppendDistinct(std::vector<Point>& line, Point p) {
  if (line.empty() || line.back() != p) line.push_back(p);
}

}  // namespace

absl::StatusOr<Sweep> Sweep::Prepare(const ConnectedMesh& mesh, std::span<const Coord> planes_nm,
                                     int64_t other_points) {
  Sweep sweep(mesh, planes_nm);
  if (absl::Status status = sweep.SortFacesIntoLayers(other_points); !status.ok()) return status;
  return sweep;
}

Sweep::Sweep(const ConnectedMesh& mesh, std::span<const Coord> planes_nm)
    : mesh_(&mesh), planes_nm_(planes_nm.begin(), planes_nm.end()) {
  vertices_.reserve(mesh.mesh.vertices.size());
  for (const Vertex& v : mesh.mesh.vertices) {
    const auto level = std::upper_bound(planes_nm_.begin(), planes_nm_.end(), v.z);
    vertices_.push_back({static_cast<int32_t>(v.x), static_cast<int32_t>(v.y),
                         static_cast<int32_t>(v.z),
                         static_cast<uint32_t>(level - planes_nm_.begin())});
  }
}

absl::Status Sweep::SortFacesIntoLayers(int64_t other_points) {
  const std::vector<Triangle>& triangles = mesh_->mesh.triangles;
  const auto span_of = [this](const Triangle& t) {
    return std::minmax({vertices_[t[0]].level, vertices_[t[1]].level, vertices_[t[2]].level});
  };
  std::vector<int64_t> counts(planes_nm_.size() + 1, 0);  // differences between layers first
  for (const Triangle& t : triangles) {
    const auto [low, high] = span_of(t);
    ++counts[low], --counts[high];
  }
  layer_starts_.assign(1, 0);
  int64_t in_layer = 0, total = 0;
  for (size_t k = 0; k < planes_nm_.size(); ++k) {
    in_layer += counts[k];
    total += in_layer;
    if (in_layer > limits::kMaxPointsPerLayer)
      return LimitError(Reason::kMeshTooLarge, "points in a layer", limits::kMaxPointsPerLayer,
                        in_layer);
    if (other_points + total > limits::kMaxPointsPerJob)
      return LimitError(Reason::kMeshTooLarge, "points in the layers of all parts",
                        limits::kMaxPointsPerJob, other_points + total);
    layer_starts_.push_back(static_cast<uint32_t>(total));
  }
  faces_.resize(static_cast<size_t>(total));
  std::vector<uint32_t> cursor(layer_starts_);
  for (uint32_t face = 0; face < triangles.size(); ++face) {
    const auto [low, high] = span_of(triangles[face]);
    for (uint32_t k = low; k < high; ++k) faces_[cursor[k]++] = face;
  }
  return absl::OkStatus();
}

Point Sweep::Crossing(uint32_t half_edge, Coord z_nm) const {
  const std::span<const Triangle> triangles = mesh_->mesh.triangles;
  LeveledVertex low = vertices_[OriginOf(triangles, half_edge)];
  LeveledVertex high = vertices_[TargetOf(triangles, half_edge)];
  if (low.z > high.z) std::swap(low, high);
  const uint64_t rise = static_cast<uint64_t>(z_nm - low.z);
  const uint64_t height = static_cast<uint64_t>(Coord{high.z} - low.z);
  return {low.x + ScaledRounded(Coord{high.x} - low.x, rise, height),
          low.y + ScaledRounded(Coord{high.y} - low.y, rise, height)};
}

void Sweep::PrefetchFace(uint32_t face, SweepScratch& scratch) const {
  __builtin_prefetch(&mesh_->mesh.triangles[face]);
  __builtin_prefetch(&mesh_->twins[size_t{3} * face]);
  __builtin_prefetch(&scratch.segment_of_face[face], 1);
}

void Sweep::PrefetchCorners(uint32_t face) const {
  for (const uint32_t corner : mesh_->mesh.triangles[face]) __builtin_prefetch(&vertices_[corner]);
}

void Sweep::CutFaces(std::span<const uint32_t> faces, size_t layer, SweepScratch& scratch) const {
  const std::span<const Triangle> triangles = mesh_->mesh.triangles;
  const Coord z_nm = planes_nm_[layer];
  for (uint32_t segment = 0; segment < faces.size(); ++segment) {
    if (segment + 2 * kAhead < faces.size()) PrefetchFace(faces[segment + 2 * kAhead], scratch);
    if (segment + kAhead < faces.size()) PrefetchCorners(faces[segment + kAhead]);
    const uint32_t face = faces[segment];
    const unsigned above = Above(triangles[face], layer);
    const uint32_t rising = 3 * face + kRising[above];
    scratch.segment_of_face[face] = segment;
    scratch.ends[segment] = Crossing(rising, z_nm);
    scratch.exits[segment] = mesh_->twins[rising];
    const bool head = mesh_->twins[3 * face + kFalling[above]] == kNoTwin;
    scratch.marks[segment] = head ? kHead : kFree;
  }
}

void Sweep::Walk(uint32_t first, SweepScratch& scratch) const {
  uint32_t segment = first;
  do {
    scratch.marks[segment] = kTaken;
    AppendDistinct(scratch.line, scratch.ends[segment]);
    if (scratch.exits[segment] == kNoTwin) return;
    segment = scratch.segment_of_face[FaceOf(scratch.exits[segment])];
  } while (segment != first);
}

Polyline Sweep::Chain(uint32_t first, uint32_t face, size_t layer, SweepScratch& scratch) const {
  const unsigned above = Above(mesh_->mesh.triangles[face], layer);
  scratch.line.assign(1, Crossing(3 * face + kFalling[above], planes_nm_[layer]));
  Walk(first, scratch);
  return scratch.line;
}

Polygon Sweep::Loop(uint32_t first, SweepScratch& scratch) const {
  scratch.line.clear();
  Walk(first, scratch);
  while (scratch.line.size() > 1 && scratch.line.back() == scratch.line.front())
    scratch.line.pop_back();
  return scratch.line;
}

Section Sweep::Cut(size_t layer, SweepScratch& scratch) const {
  const std::span<const uint32_t> faces(faces_.data() + layer_starts_[layer],
                                        layer_starts_[layer + 1] - layer_starts_[layer]);
  if (scratch.segment_of_face.size() < mesh_->mesh.triangles.size())
    scratch.segment_of_face.resize(mesh_->mesh.triangles.size());
  if (scratch.ends.size() < faces.size()) {
    scratch.ends.resize(faces.size());
    scratch.exits.resize(faces.size());
    scratch.marks.resize(faces.size());
  }
  CutFaces(faces, layer, scratch);
  Section section;
  for (uint32_t segment = 0; !mesh_->closed && segment < faces.size(); ++segment) {
    if (scratch.marks[segment] != kHead) continue;
    Polyline chain = Chain(segment, faces[segment], layer, scratch);
    if (chain.size() >= 2) section.chains.push_back(std::move(chain));
  }
  for (uint32_t segment = 0; segment < faces.size(); ++segment) {
    if (scratch.marks[segment] == kTaken) continue;
    Polygon loop = Loop(segment, scratch);
    if (loop.size() >= 3) section.loops.push_back(std::move(loop));
  }
  return section;
}

}  // namespace slicefarm::slicing
