#include "services/exposure/algo/decompose/join_pieces.h"

#include <algorithm>
#include <numbers>
#include <tuple>
#include <utility>

#include "common/geometry/measure.h"
#include "services/exposure/algo/decompose/cut_region.h"
#include "services/exposure/algo/decompose/exact_vector.h"

namespace slicefarm::exposure {
namespace {

/// An edge of a piece, and the piece.
struct Border {
  Point from, to;
  size_t piece = 0;

  auto Ends() const { return std::tuple(from, to); }
};

/// Two pieces with an edge in common, and what they would be together.
struct Joint {
  double shape = 0;
  size_t a = 0, b = 0;
  Point from, to;  ///< the edge, as a has it

  auto Key() const { return std::tuple(shape, a, b); }
};

int TurnAt(Point before, Point p, Point after) {
  return CrossSign(VectorBetween(before, p), VectorBetween(p, after));
}

size_t PlaceOf(const Polygon& ring, Point p) {
  return static_cast<size_t>(std::find(ring.begin(), ring.end(), p) - ring.begin());
}

/// Both pieces without their common edge from-to; empty if that is not convex.
Polygon Joined(const Polygon& a, const Polygon& b, Point from, Point to) {
  const size_t a_from = PlaceOf(a, from), b_to = PlaceOf(b, to);
  if (a_from == a.size() || b_to == b.size() || After(a, a_from) != to || After(b, b_to) != from)
    return {};
  const size_t a_to = (a_from + 1) % a.size(), b_from = (b_to + 1) % b.size();
  const int at_from = TurnAt(Before(a, a_from), from, After(b, b_from));
  const int at_to = TurnAt(Before(b, b_to), to, After(a, a_to));
  if (at_from < 0 || at_to < 0) return {};
  Polygon ring;
  ring.reserve(a.size() + b.size());
  for (size_t k = 0; k < a.size(); ++k) {  // a from `to` to `from`
    const size_t i = (a_to + k) % a.size();
    if ((k == 0 && at_to == 0) || (k + 1 == a.size() && at_from == 0)) continue;
    ring.push_back(a[i]);
  }
  for (size_t k = 1; k + 1 < b.size(); ++k) ring.push_back(b[(b_from + k) % b.size()]);
  return ring;
}

class Joiner {
 public:
  explicit Joiner(std::vector<Polygon> pieces) : pieces_(std::move(pieces)) {
    for (const Polygon& piece : pieces_) shapes_.push_back(ShapeFactor(piece));
  }

  /// One pass: pieces that were joined wait for the next one. False: nothing was joined.
  bool Pass() {
    std::vector<bool> joined(pieces_.size());
    bool any = false;
    for (const Joint& joint : Joints()) {
      if (joined[joint.a] || joined[joint.b]) continue;
      pieces_[joint.a] = Joined(pieces_[joint.a], pieces_[joint.b], joint.from, joint.to);
      shapes_[joint.a] = joint.shape;
      pieces_[joint.b].clear();
      joined[joint.a] = joined[joint.b] = any = true;
    }
    return any;
  }

  std::vector<Polygon> Take() {
    std::erase_if(pieces_, [](const Polygon& piece) { return piece.empty(); });
    return std::move(pieces_);
  }

 private:
  std::vector<Joint> Joints() const {
    std::vector<Border> borders;
    for (size_t p = 0; p < pieces_.size(); ++p)
      for (size_t i = 0; i < pieces_[p].size(); ++i)
        borders.push_back({pieces_[p][i], After(pieces_[p], i), p});
    const auto less = [](const Border& a, const Border& b) { return a.Ends() < b.Ends(); };
    std::sort(borders.begin(), borders.end(), less);
    std::vector<Joint> joints;
    for (const Border& border : borders) {
      if (!(border.from < border.to)) continue;
      const auto other =
          std::lower_bound(borders.begin(), borders.end(), Border{border.to, border.from}, less);
      if (other == borders.end() || other->from != border.to || other->to != border.from) continue;
      const Polygon both =
          Joined(pieces_[border.piece], pieces_[other->piece], border.from, border.to);
      if (both.empty()) continue;
      const double shape = ShapeFactor(both);
      if (shape <= std::max(shapes_[border.piece], shapes_[other->piece]))
        joints.push_back({shape, border.piece, other->piece, border.from, border.to});
    }
    std::sort(joints.begin(), joints.end(),
              [](const Joint& a, const Joint& b) { return a.Key() < b.Key(); });
    return joints;
  }

  std::vector<Polygon> pieces_;
  std::vector<double> shapes_;
};

}  // namespace

double ShapeFactor(const Polygon& piece) {
  const double perimeter = Perimeter(piece);
  return perimeter * perimeter / (4 * std::numbers::pi * SignedArea(piece));
}

std::vector<Polygon> JoinPieces(std::vector<Polygon> pieces) {
  Joiner joiner(std::move(pieces));
  while (joiner.Pass()) {
  }
  return joiner.Take();
}

}  // namespace slicefarm::exposure
