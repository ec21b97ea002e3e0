#include "services/slicing/algo/mesh_io/threemf/paint/paint_code.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::paint_code_test {
namespace {

/// Triangle in the plane z = 1, of area 32, with its right angle at the first corner.
const Facet kTriangle = {{{0, 0, 1}, {8, 0, 1}, {0, 8, 1}}};

/// Returns the signed area: positive if the facet has the orientation of kTriangle.
double AreaOf(const Facet& f) {
  return ((f[1].x() - f[0].x()) * (f[2].y() - f[0].y()) -
          (f[1].y() - f[0].y()) * (f[2].x() - f[0].x())) /
         2;
}

double AreaOf(const std::vector<PaintedPiece>& pieces, PaintState state) {
  double area = 0;
  for (const PaintedPiece& piece : pieces)
    if (piece.state == state) area += AreaOf(piece.corners);
  return area;
}

Vector3 MiddleOf(const std::vector<PaintedPiece>& pieces, PaintState state) {
  Vector3 middle = Vector3::Zero();
  for (const PaintedPiece& piece : pieces) {
    if (piece.state != state) continue;
    const double share = AreaOf(piece.corners) / AreaOf(pieces, state) / 3;
    for (const Vector3& corner : piece.corners) {
      middle.x() += share * corner.x();
      middle.y() += share * corner.y();
    }
  }
  return middle;
}

struct Code {
  std::string code;
  size_t pieces;
  double enforced, blocked;  ///< areas
  double x, y;               ///< centre of the enforced area
};

/// The digits count from the last one: `41` divides one edge and enforces the last part.
TEST(PaintedPieces, AreThoseThatTheCodeTells) {
  constexpr double kThird = 1.0 / 3;
  const std::vector<Code> cases = {
      {"0", 1, 0, 0, 0, 0},
      {"4", 1, 32, 0, 8 * kThird, 8 * kThird},
      {"8", 1, 0, 32, 0, 0},
      {"0C", 1, 0, 0, 0, 0},
      {"0FC", 1, 0, 0, 0, 0},
      // One edge is halved, opposite to each corner: the first part, then the second part.
      {"401", 2, 16, 0, 4, 4 * kThird},
      {"841", 2, 16, 16, 4 * kThird, 4},
      {"405", 2, 16, 0, 8 * kThird, 4},
      {"045", 2, 16, 0, 8 * kThird, 4 * kThird},
      {"409", 2, 16, 0, 4 * kThird, 8 * kThird},
      {"049", 2, 16, 0, 4, 8 * kThird},
      // Two edges are halved, the ones that meet at a corner.
      {"4002", 3, 8, 0, 4 * kThird, 4 * kThird},
      {"0402", 3, 8, 0, 4, 4 * kThird},
      {"0042", 3, 16, 0, 8 * kThird, 4},
      {"4006", 3, 8, 0, 16 * kThird, 4 * kThird},
      {"400A", 3, 8, 0, 4 * kThird, 16 * kThird},
      // All three edges are halved.
      {"40003", 4, 8, 0, 4 * kThird, 4 * kThird},
      {"04003", 4, 8, 0, 16 * kThird, 4 * kThird},
      {"00403", 4, 8, 0, 4 * kThird, 16 * kThird},
      {"80043", 4, 8, 8, 8 * kThird, 8 * kThird},
      // The part in the middle is divided too.
      {"800000433", 7, 2, 8, 8 * kThird, 8 * kThird},
  };
  for (const Code& c : cases) {
    const auto pieces = PaintedPieces(c.code, kTriangle);
    ASSERT_TRUE(pieces.ok()) << c.code << pieces.status();
    EXPECT_EQ(pieces->size(), c.pieces) << c.code;
    EXPECT_DOUBLE_EQ(AreaOf(*pieces, PaintState::kEnforcer), c.enforced) << c.code;
    EXPECT_DOUBLE_EQ(AreaOf(*pieces, PaintState::kBlocker), c.blocked) << c.code;
    const Vector3 middle = MiddleOf(*pieces, PaintState::kEnforcer);
    EXPECT_NEAR(middle.x(), c.x, 1e-12) << c.code;
    EXPECT_NEAR(middle.y(), c.y, 1e-12) << c.code;
  }
}

/// Returns the digits of a random division, the last digit first.
std::string RandomDigits(int levels, std::mt19937& random) {
  const int halved = levels == 0 ? 0 : static_cast<int>(random() % 4);
  const int high = static_cast<int>(random() % 3);
  std::string digits(1, "0123456789ABCDEF"[halved + 4 * high]);
  for (int part = 0; halved > 0 && part <= halved; ++part)
    digits += RandomDigits(levels - 1, random);
  return digits;
}

std::string RandomCode(std::mt19937& random) {
  const std::string digits = RandomDigits(6, random);
  return {digits.rbegin(), digits.rend()};
}

TEST(PaintedPieces, TileTheTriangle) {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    const std::string code = RandomCode(random);
    const auto pieces = PaintedPieces(code, kTriangle);
    ASSERT_TRUE(pieces.ok()) << code << pieces.status();
    double area = 0;
    for (const PaintedPiece& piece : *pieces) {
      EXPECT_GT(AreaOf(piece.corners), 0) << code << ": none is turned over";
      area += AreaOf(piece.corners);
    }
    EXPECT_DOUBLE_EQ(area, 32) << code;
    EXPECT_EQ(PaintedPieces(code, {})->size(), pieces->size()) << code;
  }
}

/// Halving rounds the middle point, but equally for both triangles at an edge.
TEST(PaintedPieces, OfNeighboursHaveTheSamePointsOnTheirEdge) {
  const Vector3 a = {0.1, 1.0 / 3, 7.7}, b = {2.0 / 3, -1.1, 0.3}, c = {1, 1, 1}, d = {-1, 0, 2};
  const auto points = [&](const Facet& facet) {
    // Each quarter point of the first edge is a corner of some piece.
    const std::string quarters = "000030000300003000033";
    std::set<std::tuple<double, double, double>> found;
    const auto pieces = PaintedPieces(quarters, facet);
    EXPECT_EQ(pieces->size(), 16u);
    for (const PaintedPiece& piece : *pieces)
      for (const Vector3& p : piece.corners) found.emplace(p.x(), p.y(), p.z());
    return found;
  };
  const auto left = points({a, b, c}), right = points({b, a, d});
  std::vector<std::tuple<double, double, double>> shared;
  for (const auto& point : left)
    if (right.contains(point)) shared.push_back(point);
  EXPECT_EQ(shared.size(), 5u);
}

TEST(PaintedPieces, RefuseWhatIsNoCode) {
  const std::string deep = std::string(200, '0') + std::string(65, '1');
  for (const std::string& code :
       std::vector<std::string>{"",     "G",    "a",   " 4",     "4 ",
                                "-1",   "\xff", "1",   "41",     "3",
                                "0003", "C",    "FC",  "FFFFC",  "00",
                                "4401", "00D",  "00F", "00000F", std::string(1 << 20, '3'),
                                deep}) {
    const auto pieces = PaintedPieces(code, kTriangle);
    ASSERT_FALSE(pieces.ok()) << code.substr(0, 20);
    EXPECT_EQ(DetailOf(pieces.status()).reason, Reason::kMeshMalformed) << code.substr(0, 20);
  }
  EXPECT_EQ(DetailOf(PaintedPieces(deep, kTriangle).status()).metadata["limit"], "64");
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::paint_code_test
