#include "tests/bench/lattice.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace slicefarm::bench {
namespace {

constexpr Coord kCellNm = 2 * kNmPerMm;
constexpr Coord kLayerNm = 50'000;
constexpr int kCorners = 32;

Polygon Disc(double radius_nm) {
  Polygon disc;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    disc.push_back(
        {std::llround(radius_nm * std::cos(angle)), std::llround(radius_nm * std::sin(angle))});
  }
  return disc;
}

}  // namespace

SlicedLayer LatticeLayer(int32_t index, int32_t layers, int cells) {
  const Polygon disc = Disc((0.45 + 0.25 * std::sin(0.3 * index)) * kNmPerMm);
  MultiPolygon discs;
  discs.reserve(static_cast<size_t>(cells) * static_cast<size_t>(cells));
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      Polygon bar = disc;
      for (Point& p : bar) p = p + Point{kCellNm * column, kCellNm * row};
      discs.push_back({std::move(bar), {}});
    }
  }
  ObjectSection section;
  section.layer = index;
  section.layer_count = layers;
  section.height_nm = kLayerNm;
  section.regions.push_back({.outlines = std::move(discs)});
  return {{index, (index + 1) * kLayerNm, kLayerNm}, {std::move(section)}};
}

}  // namespace slicefarm::bench
