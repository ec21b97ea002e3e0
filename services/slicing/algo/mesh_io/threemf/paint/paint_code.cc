#include "services/slicing/algo/mesh_io/threemf/paint/paint_code.h"

#include <optional>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {
namespace {

Vector3 Middle(const Vector3& a, const Vector3& b) { return (a + b) / 2; }

/// Returns the parts into which a triangle with 1 to 3 halved edges is divided. One halved edge: it
/// is opposite to corner `first`. Two halved edges: they meet at this corner.
std::vector<Facet> Divided(const Facet& triangle, int halved, size_t first) {
  const Vector3& a = triangle[first];
  const Vector3& b = triangle[(first + 1) % 3];
  const Vector3& c = triangle[(first + 2) % 3];
  const Vector3 ab = Middle(a, b), bc = Middle(b, c), ca = Middle(c, a);
  if (halved == 1) return {{a, b, bc}, {bc, c, a}};
  if (halved == 2) return {{a, ab, ca}, {ab, b, ca}, {b, c, ca}};
  return {{a, ab, ca}, {ab, b, bc}, {bc, c, ca}, {ab, bc, ca}};
}

class Digits {
 public:
  explicit Digits(std::string_view code) : left_(code) {}

  bool empty() const { return left_.empty(); }

  /// Returns the next digit from the end; nullopt if there is none.
  std::optional<int> Next() {
    if (left_.empty()) return std::nullopt;
    const char digit = left_.back();
    left_.remove_suffix(1);
    if (digit >= '0' && digit <= '9') return digit - '0';
    if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
    return std::nullopt;
  }

 private:
  std::string_view left_;
};

constexpr int kLastState = 2;

absl::Status NoCode() {
  return Malformed("the paint of a triangle is cut off or has a letter other than 0-9 and A-F");
}

absl::StatusOr<PaintState> StateOf(int bits, Digits& digits) {
  if (bits <= kLastState) return static_cast<PaintState>(bits);
  for (;;) {
    const std::optional<int> digit = digits.Next();
    if (!digit) return NoCode();
    if (*digit != 15) return PaintState::kNone;
  }
}

/// Part of the triangle that is not decoded yet.
struct Pending {
  Facet corners;
  int64_t level = 0;
};

}  // namespace

absl::StatusOr<std::vector<PaintedPiece>> PaintedPieces(std::string_view code,
                                                        const Facet& triangle) {
  Digits digits(code);
  std::vector<PaintedPiece> pieces;
  std::vector<Pending> pending = {{triangle, 0}};
  while (!pending.empty()) {
    const Pending part = pending.back();
    pending.pop_back();
    const std::optional<int> digit = digits.Next();
    if (!digit) return NoCode();
    const int halved = *digit & 3, high = *digit >> 2;
    if (halved == 0) {
      const absl::StatusOr<PaintState> state = StateOf(high, digits);
      if (!state.ok()) return state.status();
      pieces.push_back({part.corners, *state});
      continue;
    }
    if (high > 2) return Malformed("the paint of a triangle names a corner that does not exist");
    if (part.level == kMaxPaintLevels)
      return LimitError(Reason::kMeshMalformed, "levels of the paint of a triangle",
                        kMaxPaintLevels, part.level + 1);
    for (const Facet& facet : Divided(part.corners, halved, static_cast<size_t>(high)))
      pending.push_back({facet, part.level + 1});
  }
  if (!digits.empty()) return Malformed("the paint of a triangle continues after its last piece");
  return pieces;
}

}  // namespace slicefarm::slicing::threemf
