#include "services/beading/algo/arachne/neighbour_outlines.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicefarm::beading::neighbour_outlines_test {
namespace {

constexpr Coord kUm = 1'000;
constexpr double kBandNm = 100'000;

/// Returns a strip along the x axis for each layer; its middle is this many um from its outline. A
/// layer with 0 has no outline.
std::vector<MultiPolygon> Strips(const std::vector<Coord>& radii_um) {
  std::vector<MultiPolygon> layers;
  for (const Coord radius_um : radii_um) {
    const Coord x = 10'000 * kUm, y = radius_um * kUm;
    MultiPolygon& layer = layers.emplace_back();
    if (radius_um > 0) layer = {{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, {}}};
  }
  return layers;
}

NeighbourOutlines Neighbours(const std::vector<MultiPolygon>& layers) {
  std::vector<const MultiPolygon*> outlines;
  for (const MultiPolygon& layer : layers) outlines.push_back(&layer);
  return NeighbourOutlines(std::move(outlines));
}

/// Returns the mean radius at the middle of the strips.
double MeanUm(const std::vector<Coord>& radii_um, size_t i, size_t reach, double band_nm) {
  const auto layers = Strips(radii_um);
  const auto radius_nm = static_cast<double>(radii_um[i] * kUm);
  return Neighbours(layers).MeanRadius(i, reach, 0, 0, radius_nm, band_nm) / kUm;
}

TEST(NeighbourOutlines, TheMeanIsThatOfTheLayersInReach) {
  const std::vector<Coord> radii_um = {300, 330, 342, 350, 398, 380};
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 2, 2, kBandNm), (300 + 330 + 342 + 350 + 398) / 5.);
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 3, 1, kBandNm), (342 + 350 + 398) / 3.);
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 3, 0, kBandNm), 350);
}

TEST(NeighbourOutlines, TheFirstAndTheLastLayerHaveNeighboursOnOneSide) {
  const std::vector<Coord> radii_um = {300, 330, 342, 350, 398};
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 0, 2, kBandNm), (300 + 330 + 342) / 3.);
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 1, 2, kBandNm), (300 + 330 + 342 + 350) / 4.);
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 4, 2, kBandNm), (342 + 350 + 398) / 3.);
  EXPECT_DOUBLE_EQ(MeanUm({300}, 0, 2, kBandNm), 300);
}

TEST(NeighbourOutlines, LayersOfAnotherShapeDoNotCount) {
  const std::vector<Coord> radii_um = {300, 330, 340, 350, 450};
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 3, 2, 20'000), (330 + 340 + 350) / 3.);
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 3, 2, 19'000), (340 + 350) / 2.);
  EXPECT_DOUBLE_EQ(MeanUm(radii_um, 3, 2, 100'000), (330 + 340 + 350 + 450) / 4.);
}

TEST(NeighbourOutlines, LayersWithoutOutlinesDoNotCount) {
  EXPECT_DOUBLE_EQ(MeanUm({0, 300, 310, 0}, 1, 2, kBandNm), 305);
}

// The own layer counts with the given radius, not with the one from the index: an island's graph
// may be on a coarser grid.
TEST(NeighbourOutlines, TheOwnLayerCountsByTheRadiusGiven) {
  const auto layers = Strips({300, 310});
  EXPECT_DOUBLE_EQ(Neighbours(layers).MeanRadius(0, 2, 0, 0, 302'000, kBandNm), 306'000);
}

TEST(NeighbourOutlines, PlacesAreThoseOfThePlane) {
  const auto layers = Strips({300, 310});
  // The end of the strips is 0.1 mm away.
  EXPECT_DOUBLE_EQ(Neighbours(layers).MeanRadius(0, 2, 9.9e6, 0, 90'000, kBandNm), 95'000);
  // In the second layer the position is 0.26 mm from the outline.
  EXPECT_DOUBLE_EQ(Neighbours(layers).MeanRadius(0, 2, 0, 50'000, 250'000, kBandNm), 255'000);
}

// This is the purpose of the class: a close decision has the same result in all layers, in any
// order.
TEST(NeighbourOutlines, LayersInReachOfEachOtherAgree) {
  const std::vector<Coord> radii_um = {319, 322, 317};
  const auto layers = Strips(radii_um);
  const NeighbourOutlines neighbours = Neighbours(layers);
  for (const size_t i : {2, 0, 1, 2}) {
    const auto radius_nm = static_cast<double>(radii_um[i] * kUm);
    EXPECT_NEAR(neighbours.MeanRadius(i, 2, 0, 0, radius_nm, kBandNm), 958'000 / 3., 1e-6);
  }
}

}  // namespace
}  // namespace slicefarm::beading::neighbour_outlines_test
