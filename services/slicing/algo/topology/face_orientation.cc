#include "services/slicing/algo/topology/face_orientation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "services/slicing/algo/topology/mesh_measure.h"

namespace slicefarm::slicing {
namespace {

enum class Orientation : uint8_t { kUnknown, kAsFirst, kAgainstFirst };

Orientation Opposite(Orientation turn) {
  return turn == Orientation::kAsFirst ? Orientation::kAgainstFirst : Orientation::kAsFirst;
}

bool RunAlike(std::span<const Triangle> triangles, uint32_t a, uint32_t b) {
  return OriginOf(triangles, a) == OriginOf(triangles, b);
}

/// Finds the faces to flip.
class Orienter {
 public:
  Orienter(const IndexedMesh& mesh, const EdgeTable& table)
      : mesh_(mesh), twins_(table.twins), turns_(mesh.triangles.size(), Orientation::kUnknown) {}

  /// Returns true for each face to be flipped, indexed by face.
  std::vector<bool> FacesToTurn() {
    std::vector<bool> turn(mesh_.triangles.size(), false);
    for (uint32_t face = 0; face < turns_.size(); ++face) {
      if (turns_[face] != Orientation::kUnknown) continue;
      Collect(face);
      const Orientation wrong = Minority();
      for (const uint32_t member : body_) turn[member] = turns_[member] == wrong;
    }
    return turn;
  }

 private:
  /// Fills body_ with the faces connected to `first`. Decides for each of them if it is oriented
  /// against `first`.
  void Collect(uint32_t first) {
    body_ = {first};
    turns_[first] = Orientation::kAsFirst;
    for (size_t next = 0; next < body_.size(); ++next) {
      const uint32_t face = body_[next];
      for (uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
        const uint32_t twin = twins_[h];
        if (twin == kNoTwin || turns_[FaceOf(twin)] != Orientation::kUnknown) continue;
        const bool alike = RunAlike(mesh_.triangles, h, twin);
        turns_[FaceOf(twin)] = alike ? Opposite(turns_[face]) : turns_[face];
        body_.push_back(FaceOf(twin));
      }
    }
  }

  Orientation Minority() const {
    const int64_t against = std::count_if(body_.begin(), body_.end(), [&](uint32_t face) {
      return turns_[face] == Orientation::kAgainstFirst;
    });
    const int64_t with = static_cast<int64_t>(body_.size()) - against;
    if (against != with) return against < with ? Orientation::kAgainstFirst : Orientation::kAsFirst;
    __int128 volume = 0;
    for (const uint32_t face : body_) {
      const __int128 part = SixVolumes(mesh_, mesh_.triangles[face]);
      volume += turns_[face] == Orientation::kAsFirst ? part : -part;
    }
    return volume >= 0 ? Orientation::kAgainstFirst : Orientation::kAsFirst;
  }

  const IndexedMesh& mesh_;
  const std::vector<uint32_t>& twins_;
  std::vector<Orientation> turns_;
  std::vector<uint32_t> body_;
};

/// Returns the new index of a half-edge. A flipped face (a, b, c) becomes (a, c, b), so its
/// half-edges 0 and 2 are exchanged.
uint32_t Renumbered(uint32_t half_edge, const std::vector<bool>& turn) {
  if (!turn[FaceOf(half_edge)]) return half_edge;
  return 3 * FaceOf(half_edge) + (2 - half_edge % 3);
}

void Renumber(EdgeTable& table, const std::vector<bool>& turn) {
  std::vector<uint32_t> twins(table.twins.size(), kNoTwin);
  for (uint32_t h = 0; h < twins.size(); ++h)
    if (table.twins[h] != kNoTwin) twins[Renumbered(h, turn)] = Renumbered(table.twins[h], turn);
  table.twins = std::move(twins);
  for (uint32_t& half_edge : table.fans) half_edge = Renumbered(half_edge, turn);
}

void CutConflicts(std::span<const Triangle> triangles, EdgeTable& table) {
  table.conflicts = 0;
  for (uint32_t h = 0; h < table.twins.size(); ++h) {
    const uint32_t twin = table.twins[h];
    if (twin == kNoTwin || !RunAlike(triangles, h, twin)) continue;
    table.twins[h] = table.twins[twin] = kNoTwin;
    ++table.conflicts;
  }
}

}  // namespace

int64_t OrientFaces(IndexedMesh& mesh, EdgeTable& table) {
  if (table.conflicts == 0) return 0;
  const std::vector<bool> turn = Orienter(mesh, table).FacesToTurn();
  Renumber(table, turn);
  int64_t turned = 0;
  for (size_t face = 0; face < turn.size(); ++face) {
    if (!turn[face]) continue;
    std::swap(mesh.triangles[face][1], mesh.triangles[face][2]);
    ++turned;
  }
  CutConflicts(mesh.triangles, table);
  return turned;
}

}  // namespace slicefarm::slicing
