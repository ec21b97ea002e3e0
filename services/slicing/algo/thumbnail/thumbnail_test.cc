#include "services/slicing/algo/thumbnail/thumbnail.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <map>
#include <vector>

#include "common/base/error.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/algo/thumbnail/png_image.h"
#include "services/slicing/algo/thumbnail/qoi_image.h"

namespace slicefarm::slicing::thumbnail_test {
namespace {

const std::vector<Point> kHere = {{}};

std::vector<Rgba> Pixels(const Thumbnail& thumbnail) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(
      png_image_begin_read_from_memory(&image, thumbnail.data.data(), thumbnail.data.size()));
  image.format = PNG_FORMAT_RGBA;
  std::vector<Rgba> pixels(size_t{image.width} * image.height);
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr));
  return pixels;
}

Thumbnail Render(const std::vector<SceneMesh>& scene, ThumbnailSize size, const Polygon& bed = {}) {
  const auto thumbnail = RenderThumbnail(scene, bed, size, {});
  EXPECT_TRUE(thumbnail.ok()) << thumbnail.status();
  return *thumbnail;
}

double CoveredShare(const std::vector<Rgba>& pixels) {
  double opacity = 0;
  for (const Rgba& pixel : pixels) opacity += pixel[3] / 255.0;
  return opacity / static_cast<double>(pixels.size());
}

TEST(RenderThumbnail, ShowsACubeAsAHexagonOfThreeShades) {
  const IndexedMesh cube = *PlaceMesh(BoxMesh({0, 0, 0}, {10, 10, 10}));
  const std::vector<Rgba> pixels = Pixels(Render({{&cube, kHere, true}}, {100, 100}));
  // The view is a regular hexagon as high as the picture without its margin: 3 sqrt(3) / 8 of the
  // square.
  EXPECT_NEAR(CoveredShare(pixels), 0.6495 / (1.08 * 1.08), 0.01);
  EXPECT_EQ(pixels[0], (Rgba{0, 0, 0, 0}));
  const Rgba top = pixels[25 * 100 + 50], left = pixels[65 * 100 + 30],
             right = pixels[65 * 100 + 70];
  EXPECT_GT(top[0], left[0]);
  EXPECT_GT(left[0], right[0]);
  EXPECT_EQ(top[3], 255);
}

TEST(RenderThumbnail, SolidObjectsLookTheSameWithoutTheirBacks) {
  const IndexedMesh torus = *PlaceMesh(TorusMesh({.around = 90, .sides = 60}));
  const std::vector<Rgba> solid = Pixels(Render({{&torus, kHere, true}}, {64, 64}));
  const std::vector<Rgba> open = Pixels(Render({{&torus, kHere, false}}, {64, 64}));
  EXPECT_NEAR(CoveredShare(solid), CoveredShare(open), 0.002);
}

TEST(RenderThumbnail, DoesNotDependOnTheOrderOfTriangles) {
  const RawMesh raw = Joined(TorusMesh({}), BoxMesh({0, 0, 0}, {25, 25, 25}));
  const IndexedMesh mesh = *PlaceMesh(raw), shuffled = *PlaceMesh(Shuffled(raw, 5));
  const SceneMesh object{&mesh, kHere, false};
  IndexedMesh reordered = mesh;
  std::reverse(reordered.triangles.begin(), reordered.triangles.end());
  EXPECT_EQ(Render({object}, {300, 300}).data,
            Render({{&reordered, kHere, false}}, {300, 300}).data);
  EXPECT_NEAR(CoveredShare(Pixels(Render({{&shuffled, kHere, false}}, {300, 300}))),
              CoveredShare(Pixels(Render({object}, {300, 300}))), 1e-4);
}

TEST(RenderThumbnail, FitsAllObjectsIn) {
  const IndexedMesh cube = *PlaceMesh(BoxMesh({0, 0, 0}, {10, 10, 10}));
  const std::vector<Point> there = {{100 * kNmPerMm, 0}};
  const std::vector<SceneMesh> scene = {{&cube, kHere, true}, {&cube, there, true}};
  const std::vector<Rgba> pixels = Pixels(Render(scene, {60, 40}));
  bool left = false, right = false;
  for (size_t at = 0; at < pixels.size(); ++at) {
    if (pixels[at][3] == 0) continue;
    (at % 60 < 30 ? left : right) = true;
  }
  EXPECT_TRUE(left && right);
  EXPECT_LT(CoveredShare(pixels), 0.2);
}

TEST(RenderThumbnail, ShowsTheSameAsQoi) {
  const IndexedMesh cube = *PlaceMesh(BoxMesh({0, 0, 0}, {10, 10, 10}));
  const Thumbnail png = Render({{&cube, kHere, true}}, {40, 30});
  const Thumbnail qoi = Render({{&cube, kHere, true}}, {40, 30, PictureFormat::kQoi});
  EXPECT_EQ(qoi.format, PictureFormat::kQoi);
  EXPECT_EQ(qoi.data, EncodeQoi(Pixels(png), 40, 30));
}

// A stamp is up to half a sample beside its exact position; this is visible at the edges only.
TEST(RenderThumbnail, CopiesLookLikeObjectsOfTheirOwn) {
  const IndexedMesh torus = *PlaceMesh(TorusMesh({.around = 90, .sides = 60}));
  const auto mm = [](double x, double y) { return Point{FromMm(x), FromMm(y)}; };
  // Two copies are separate, and one hides a part of another.
  const std::vector<Point> places = {mm(0, 0), mm(70.3, 11.1), mm(14.7, -9.2)};
  std::vector<SceneMesh> alone;
  for (const Point& place : places) alone.push_back({&torus, {&place, 1}, true});
  const std::vector<Rgba> want = Pixels(Render(alone, {200, 150}));
  const std::vector<Rgba> got = Pixels(Render({{&torus, places, true}}, {200, 150}));
  EXPECT_NEAR(CoveredShare(got), CoveredShare(want), 0.005);
  double off = 0;
  for (size_t i = 0; i < want.size(); ++i)
    for (size_t c = 0; c < 4; ++c) off += std::abs(got[i][c] - want[i][c]);
  EXPECT_LT(off / static_cast<double>(want.size()), 10) << "a copy that is not there: 50";
  EXPECT_NE(got, Pixels(Render({alone[0]}, {200, 150})));
}

// A bed of 100 mm with two cubes of 10 mm and one of 20 mm: a pixel is a millimetre.
TEST(RenderThumbnail, PicksTheCopyBelowAPixel) {
  const IndexedMesh cube = *PlaceMesh(BoxMesh({0, 0, 0}, {10, 10, 10}));
  const IndexedMesh large = *PlaceMesh(BoxMesh({0, 0, 0}, {20, 20, 20}));
  const auto mm = [](Coord x, Coord y) { return Point{x * 1'000'000, y * 1'000'000}; };
  const std::vector<Point> two = {mm(20, 20), mm(80, 20)}, one = {mm(50, 70)};
  const Polygon bed = {mm(0, 0), mm(100, 0), mm(100, 100), mm(0, 100)};
  const std::vector<SceneMesh> scene = {{&cube, two, true, 0}, {&large, one, true, 299}};
  const ThumbnailSize size = {100, 100, PictureFormat::kPng, PictureRole::kPick};
  const Thumbnail picture = Render(scene, size, bed);
  EXPECT_EQ(picture.role, PictureRole::kPick);
  const std::vector<Rgba> pixels = Pixels(picture);
  const auto at = [&](int x, int y) { return pixels[(99 - y) * 100 + x]; };
  EXPECT_EQ(at(20, 20), (Rgba{1, 0, 0, 255}));
  EXPECT_EQ(at(80, 20), (Rgba{2, 0, 0, 255}));
  EXPECT_EQ(at(50, 70), (Rgba{300 - 256, 1, 0, 255}));
  EXPECT_EQ(at(50, 20), (Rgba{0, 0, 0, 0}));
  std::map<Rgba, int> area;
  for (const Rgba& pixel : pixels) ++area[pixel];
  EXPECT_EQ(area.size(), 4u) << "a mean of two ids would be the id of a third copy";
  EXPECT_EQ((area[{1, 0, 0, 255}]), 100);
  EXPECT_EQ((area[{300 - 256, 1, 0, 255}]), 400);

  const std::vector<Rgba> top =
      Pixels(Render(scene, {100, 100, PictureFormat::kPng, PictureRole::kTop}, bed));
  EXPECT_NEAR(CoveredShare(top), CoveredShare(pixels), 0.001);
}

TEST(RenderThumbnail, WhatIsBesideTheBedIsCutOff) {
  const IndexedMesh cube = *PlaceMesh(BoxMesh({0, 0, 0}, {10, 10, 10}));
  const Polygon bed = {{-2'000'000, -2'000'000}, {2'000'000, -2'000'000}, {2'000'000, 2'000'000}};
  const std::vector<Point> away = {{}, {100'000'000, 0}, {0, -100'000'000}};
  for (const std::vector<Point>& centers : {kHere, away}) {
    const std::vector<Rgba> pixels = Pixels(
        Render({{&cube, centers, true}}, {16, 16, PictureFormat::kPng, PictureRole::kTop}, bed));
    EXPECT_EQ(CoveredShare(pixels), 1);
  }
}

TEST(RenderThumbnail, WithoutLightAllFacesAreAlike) {
  const IndexedMesh cube = *PlaceMesh(BoxMesh({0, 0, 0}, {10, 10, 10}));
  const std::vector<Rgba> pixels =
      Pixels(Render({{&cube, kHere, true}}, {32, 32, PictureFormat::kPng, PictureRole::kUnlit}));
  EXPECT_EQ(pixels[8 * 32 + 16], pixels[22 * 32 + 22]);
  EXPECT_EQ(pixels[8 * 32 + 16][3], 255);
}

TEST(RenderThumbnail, RefusesSenselessSizes) {
  const IndexedMesh cube = *PlaceMesh(BoxMesh({0, 0, 0}, {10, 10, 10}));
  const SceneMesh object{&cube, kHere, true};
  for (const ThumbnailSize& size : {ThumbnailSize{0, 10}, {10, -1}, {2049, 10}}) {
    const auto thumbnail = RenderThumbnail({&object, 1}, {}, size, {});
    EXPECT_EQ(DetailOf(thumbnail.status()).reason, Reason::kSettingOutOfRange);
  }
  Render({object}, {1, 1});
  Render({object}, {7, 2048});
}

}  // namespace
}  // namespace slicefarm::slicing::thumbnail_test
