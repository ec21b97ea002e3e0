#include "services/slicing/algo/topology/edge_fans.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace slicefarm::slicing {
namespace {

using EdgeVector = std::array<Coord, 3>;

EdgeVector Difference(const Vertex& a, const Vertex& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

__int128 Minor(const EdgeVector& a, const EdgeVector& b, int i, int j) {
  return static_cast<__int128>(a[i]) * b[j] - static_cast<__int128>(a[j]) * b[i];
}

int Sign(__int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Returns the sign of the determinant. For differences of coordinates within 2^32, its absolute
/// value is below 2^100.
int DeterminantSign(const EdgeVector& a, const EdgeVector& b, const EdgeVector& c) {
  return Sign(Minor(a, b, 1, 2) * c[0] + Minor(a, b, 2, 0) * c[1] + Minor(a, b, 0, 1) * c[2]);
}

constexpr std::array<std::array<int, 2>, 3> kPlanes = {{{1, 2}, {2, 0}, {0, 1}}};

bool IsAlong(const EdgeVector& a, const EdgeVector& b) {
  return std::all_of(kPlanes.begin(), kPlanes.end(),
                     [&](const auto& plane) { return Minor(a, b, plane[0], plane[1]) == 0; });
}

/// Value of half_turn for a face without area. It has no angle and is sorted before all others.
constexpr int kFlat = -1;

/// One of the faces at the edge.
struct Leaf {
  uint32_t half_edge = 0;
  bool closes = false;  ///< true if it ends the wedge of material before it, counter-clockwise
  Vertex apex;          ///< corner that is not on the edge
  /// half turn in which the face's angle is, from the first leaf: 0 for [0, pi), 1 for [pi, 2 pi);
  /// or kFlat
  int half_turn = 0;
};

class Fan {
 public:
  Fan(const IndexedMesh& mesh, std::span<const uint32_t> half_edges) {
    const std::span<const Triangle> triangles = mesh.triangles;
    const Vertex& one = mesh.vertices[OriginOf(triangles, half_edges[0])];
    const Vertex& other = mesh.vertices[TargetOf(triangles, half_edges[0])];
    low_ = std::min(one, other);
    axis_ = Difference(std::max(one, other), low_);
    for (const uint32_t h : half_edges) {
      const Vertex& apex = mesh.vertices[triangles[FaceOf(h)][(h % 3 + 2) % 3]];
      // Seen against the axis, material is clockwise of a face with its half-edge up along the
      // axis.
      leaves_.push_back({h, mesh.vertices[OriginOf(triangles, h)] == low_, apex});
    }
    SortByAngle();
  }

  void Pair(std::vector<uint32_t>& twins) const {
    std::vector<uint32_t> open, early;
    const auto link = [&twins](uint32_t a, uint32_t b) { twins[a] = b, twins[b] = a; };
    for (const Leaf& leaf : leaves_) {
      if (!leaf.closes) {
        open.push_back(leaf.half_edge);
      } else if (open.empty()) {
        early.push_back(leaf.half_edge);
      } else {
        link(open.back(), leaf.half_edge);
        open.pop_back();
      }
    }
    // The list is circular: wedges that are open at its end are closed by faces at its beginning.
    for (size_t i = 0; i < early.size() && !open.empty(); ++i, open.pop_back())
      link(open.back(), early[i]);
  }

 private:
  void SortByAngle() {
    for (Leaf& leaf : leaves_)
      leaf.half_turn = IsAlong(axis_, Difference(leaf.apex, low_)) ? kFlat : 0;
    const auto first =
        std::min_element(leaves_.begin(), leaves_.end(), [](const Leaf& a, const Leaf& b) {
          return a.half_turn != b.half_turn ? a.half_turn > b.half_turn : a.apex < b.apex;
        });
    const EdgeVector reference = Difference(first->apex, low_);
    for (Leaf& leaf : leaves_)
      if (leaf.half_turn != kFlat)
        leaf.half_turn = HalfTurn(reference, Difference(leaf.apex, low_));
    std::sort(leaves_.begin(), leaves_.end(),
              [&](const Leaf& a, const Leaf& b) { return Before(a, b); });
  }

  int HalfTurn(const EdgeVector& reference, const EdgeVector& arm) const {
    const int side = DeterminantSign(axis_, reference, arm);
    if (side != 0) return side > 0 ? 0 : 1;
    // The arm is in one plane with the axis; decide if it is on the same side of the axis.
    for (const auto& [i, j] : kPlanes) {
      const int sense = Sign(Minor(axis_, reference, i, j)) * Sign(Minor(axis_, arm, i, j));
      if (sense != 0) return sense > 0 ? 0 : 1;
    }
    return 0;
  }

  bool Before(const Leaf& a, const Leaf& b) const {
    if (a.half_turn != b.half_turn) return a.half_turn < b.half_turn;
    const int turn = a.half_turn == kFlat ? 0
                                          : DeterminantSign(axis_, Difference(a.apex, low_),
                                                            Difference(b.apex, low_));
    if (turn != 0) return turn > 0;
    if (a.closes != b.closes) return a.closes;
    if (a.apex != b.apex) return a.apex < b.apex;
    return a.half_edge < b.half_edge;
  }

  Vertex low_;
  EdgeVector axis_;
  std::vector<Leaf> leaves_;
};

}  // namespace

void PairFans(const IndexedMesh& mesh, EdgeTable& table) {
  for (int64_t i = 0; i < table.fan_count(); ++i) {
    const std::span<const uint32_t> half_edges(table.fans.data() + table.fan_starts[i],
                                               table.fan_starts[i + 1] - table.fan_starts[i]);
    Fan(mesh, half_edges).Pair(table.twins);
  }
}

}  // namespace slicefarm::slicing
