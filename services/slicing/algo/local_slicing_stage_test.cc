#include "services/slicing/algo/local_slicing_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/predicates.h"
#include "common/model/limits.h"
#include "common/stage/slice_input_test.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "tests/corpus_file.h"

namespace slicefarm::slicing::local_slicing_stage_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

constexpr Coord kMm = kNmPerMm;

MeshFile File(const RawMesh& mesh, std::string name = "part") {
  return {std::move(name), MeshFormat::kUnknown, ToBinaryStl(mesh)};
}

SliceInput Input(const RawMesh& mesh, const Placement& placement = {}) {
  return InputOf({File(mesh)}, {placement});
}

absl::StatusOr<SlicedJob> Slice(SliceInput input, const SlicingOptions& options = {},
                                int threads = 1) {
  StageCall call;
  call.threads = threads;
  const SlicingOptions all = ForObjects(options, input.objects.size());
  return MakeLocalSlicing()->Slice(call, std::move(input), all);
}

double VolumeMm3(const SlicedJob& job) {
  double volume = 0;
  for (const SlicedLayer& layer : job.layers)
    for (const ObjectSection& section : layer.sections)
      volume += Area(OutlineOf(section)) * 1e-12 * ToMm(static_cast<double>(section.height_nm));
  return volume;
}

TEST(LocalSlicing, AdvisesOrientationsOnRequestOnly) {
  Placement on_edge;
  on_edge.rotate_deg = {90, 0, 0};
  const RawMesh plank = BoxMesh({0, 0, 0}, {60, 40, 5});
  SliceInput input = InputOf({File(plank), File(plank)}, {Placement(), on_edge});
  EXPECT_TRUE(Slice(input)->orientations.empty());
  input.advise_orientations = true;
  const auto job = Slice(input);
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_THAT(job->orientations, SizeIs(1));
  EXPECT_EQ(job->orientations[0].object, job->object_names[1]);
  EXPECT_NEAR(job->orientations[0].advised.contact_mm2, 2400, 1e-3);
}

TEST(LocalSlicing, ACubeIsTheSameSquareInEveryLayer) {
  const auto job = Slice(Input(Cube(3, 4, 5)));
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_THAT(job->layers, SizeIs(50));
  const Polygon square = {
      {-5 * kMm, -5 * kMm}, {5 * kMm, -5 * kMm}, {5 * kMm, 5 * kMm}, {-5 * kMm, 5 * kMm}};
  for (int32_t k = 0; k < 50; ++k) {
    EXPECT_EQ(job->layers[k].frame, (LayerFrame{k, (k + 1) * 200'000, 200'000}));
    const ObjectSection want{
        0, k, 50, 200'000, {{Role::kPart, 0, 0, {{square, {}}}}}, {}, (k + 1) * 200'000, {}};
    EXPECT_THAT(job->layers[k].sections, ElementsAre(want));
  }
  EXPECT_THAT(job->object_names, ElementsAre("part"));
  ASSERT_THAT(job->copies, SizeIs(1));
  EXPECT_EQ(job->copies[0].shift, (Point{125 * kMm, 105 * kMm}));
  EXPECT_EQ(job->copies[0].footprint, Moved(square, job->copies[0].shift));
  ASSERT_THAT(job->meshes, SizeIs(1));
  EXPECT_TRUE(job->meshes[0].Closed());
  EXPECT_DOUBLE_EQ(job->meshes[0].volume_mm3, 1000);
  ASSERT_THAT(job->thumbnails, SizeIs(2));
  EXPECT_EQ(job->thumbnails[0].width_px, 32);
  EXPECT_EQ(job->thumbnails[1].height_px, 300);
}

struct RuleCase {
  std::string name;
  RawMesh mesh;
  double non_zero_mm2, even_odd_mm2, positive_mm2;  ///< areas in the layer at 5 mm, per fill rule
};

TEST(LocalSlicing, FillRulesDecideWhatIsInside) {
  const RawMesh outer = Cube(0, 0, 0, 20), inner = Cube(5, 5, 2, 10);
  const std::vector<RuleCase> cases = {
      {"Overlap", Joined(Cube(0, 0, 0), Cube(5, 5, 0)), 175, 150, 175},
      {"Shell", Joined(outer, TurnedInsideOut(inner)), 300, 300, 300},
      {"ShellTheWrongWay", Joined(outer, inner), 400, 300, 400},
      {"InsideOut", TurnedInsideOut(outer), 400, 400, 0},
      {"TouchingInAnEdge", Joined(Cube(0, 0, 0), Cube(10, 10, 0)), 200, 200, 200},
      {"TouchingInAFace", Joined(Cube(0, 0, 0), Cube(10, 0, 0)), 200, 200, 200},
  };
  for (const RuleCase& c : cases) {
    for (const auto& [rule, want] : {std::pair{FillRule::kNonZero, c.non_zero_mm2},
                                     {FillRule::kEvenOdd, c.even_odd_mm2},
                                     {FillRule::kPositive, c.positive_mm2}}) {
      SlicingOptions options;
      options.objects[0].fill_rule = rule;
      const auto job = Slice(Input(c.mesh), options);
      if (want == 0) {
        EXPECT_EQ(DetailOf(job.status()).reason, Reason::kNothingToPrint) << c.name;
        continue;
      }
      ASSERT_TRUE(job.ok()) << c.name << job.status();
      EXPECT_NEAR(Area(OutlineOf(job->layers[25].sections[0])) * 1e-12, want, 1e-6) << c.name;
    }
  }
}

/// Returns a cone with `count` sides.
RawMesh ConeMesh(uint32_t count, double radius, double height) {
  RawMesh mesh;
  for (uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    mesh.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    const uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({i, next, count});
    mesh.triangles.push_back({next, i, count + 1});
  }
  mesh.positions.push_back({0, 0, height});
  mesh.positions.push_back({0, 0, 0});
  return mesh;
}

// The limit counts before the facets are stored, which would need gigabytes here.
TEST(LocalSlicing, FacetsOfTheUpperSideHaveALimit) {
  SlicingOptions options;
  options.first_layer_height_nm = 10'000;
  options.objects[0].layer_height_nm = 10'000;
  const RawMesh cone = ConeMesh(3'000, 5, 190);
  EXPECT_TRUE(Slice(Input(ConeMesh(30, 5, 1)), options).ok());
  options.objects[0].contour.on = true;
  EXPECT_TRUE(Slice(Input(ConeMesh(30, 5, 1)), options).ok());
  const absl::Status status = Slice(Input(cone), options).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kMeshTooLarge) << status;
  EXPECT_EQ(DetailOf(status).metadata.at("limit"), std::to_string(limits::kMaxFacetsPerJob));
}

TEST(LocalSlicing, CopiesAreNoWork) {
  const std::vector<Point> centers = {
      {50 * kMm, 50 * kMm}, {120 * kMm, 61 * kMm}, {50 * kMm, 120 * kMm}};
  const RawMesh torus = TorusMesh({.ring_radius = 10, .tube_radius = 3});
  const auto job = Slice(InputOf({File(torus), File(Cube(0, 0, 0, 5), "cube")},
                                 {{.centers = centers}, {.centers = {{200 * kMm, 150 * kMm}}}}));
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_THAT(job->object_names, ElementsAre("part", "cube"));
  ASSERT_THAT(job->copies, SizeIs(4));
  for (size_t copy = 0; copy < 3; ++copy) {
    EXPECT_EQ(job->copies[copy].object, 0);
    EXPECT_EQ(job->copies[copy].shift, centers[copy]);
  }
  EXPECT_EQ(job->copies[3].object, 1);
  ASSERT_THAT(job->layers, SizeIs(30));
  const auto alone = Slice(Input(torus));
  for (size_t layer = 0; layer < 30; ++layer) {
    const bool has_cube = job->layers[layer].frame.print_z_nm <= 5 * kMm;
    ASSERT_THAT(job->layers[layer].sections, SizeIs(has_cube ? 2 : 1));
    EXPECT_EQ(job->layers[layer].sections[0], alone->layers[layer].sections[0]);
  }
}

TEST(LocalSlicing, ObjectsHaveTheirOwnHeights) {
  SlicingOptions options;
  options.objects.resize(2);
  options.objects[1].layer_height_nm = 300'000;
  const auto job = MakeLocalSlicing()->Slice(
      {},
      InputOf({File(Cube(0, 0, 0, 2)), File(Cube(0, 0, 0, 2), "b")},
              {{.centers = {{50 * kMm, 50 * kMm}}}, {.centers = {{90 * kMm, 50 * kMm}}}}),
      options);
  ASSERT_TRUE(job.ok()) << job.status();
  std::vector<std::vector<Coord>> tops(2);
  Coord below = 0;
  for (const SlicedLayer& layer : job->layers) {
    EXPECT_EQ(layer.frame.height_nm, layer.frame.print_z_nm - below);
    below = layer.frame.print_z_nm;
    for (const ObjectSection& section : layer.sections) {
      std::vector<Coord>& own = tops[static_cast<size_t>(section.stack.object)];
      EXPECT_EQ(section.layer, std::ssize(own));
      EXPECT_EQ(section.z_nm, layer.frame.print_z_nm);
      own.push_back(layer.frame.print_z_nm / 1'000);
    }
  }
  EXPECT_EQ(tops[0], (std::vector<Coord>{200, 400, 600, 800, 1000, 1200, 1400, 1600, 1800, 2000}));
  EXPECT_EQ(tops[1], (std::vector<Coord>{200, 500, 800, 1100, 1400, 1700, 2000}));
}

TEST(LocalSlicing, WhatDoesNotStandOnTheBedHasNeitherItsFirstLayerNorAFoot) {
  SliceInput input = InputOf({File(Cube(0, 0, 0, 2)), File(Cube(0, 0, 0, 2))});
  SlicingOptions options;
  options.objects.resize(2);
  options.first_layer_height_nm = 300'000;
  options.objects[0].on_bed = false;
  options.objects[0].lift_nm = 750'000;
  options.objects[0].elephant_foot_nm = options.objects[1].elephant_foot_nm = 200'000;
  const auto job = MakeLocalSlicing()->Slice({}, std::move(input), options);
  ASSERT_TRUE(job.ok()) << job.status();
  std::vector<Coord> tops, raised;
  for (const SlicedLayer& layer : job->layers) {
    tops.push_back(layer.frame.print_z_nm / 1000);
    for (const ObjectSection& section : layer.sections) {
      EXPECT_EQ(section.z_nm, layer.frame.print_z_nm) << "from its own bottom";
      if (section.stack.object == 0) raised.push_back(section.z_nm / 1000);
    }
  }
  EXPECT_THAT(raised, ElementsAre(200, 400, 600, 800, 1000, 1200, 1400, 1600, 1800, 2000));
  EXPECT_THAT(tops, ElementsAre(200, 300, 400, 500, 600, 700, 800, 900, 1000, 1100, 1200, 1300,
                                1400, 1500, 1600, 1700, 1800, 1900, 2000, 2100))
      << "the middle of the last one lies at the top of what stands on the bed";
  const auto side = [](const ObjectSection& section) {
    return ToMm(static_cast<double>(Bounds(OutlineOf(section)).max.x));
  };
  const ObjectSection& on_raft = job->layers[0].sections.at(0);
  const ObjectSection& standing = job->layers[1].sections.at(0);
  EXPECT_EQ(on_raft.layer, 0);
  EXPECT_EQ(on_raft.height_nm, 200'000);
  EXPECT_LT(side(standing), side(on_raft) - 0.1) << "no elephant's foot on a raft";
}

TEST(LocalSlicing, WhatItWillStandOnCountsForTheHeightOfThePrint) {
  SlicingOptions options;
  options.max_print_height_nm = 2'500'000;
  EXPECT_TRUE(Slice(Input(Cube(0, 0, 0, 2)), options).ok());
  options.objects[0].lift_nm = 600'000;
  EXPECT_EQ(DetailOf(Slice(Input(Cube(0, 0, 0, 2)), options).status()).reason,
            Reason::kOutOfBuildVolume);
}

/// The surface is a stripe painted on the side y = 0, from x = 2 to 4 and z = 1 to 9.
TEST(LocalSlicing, AnOpenSurfaceForSeamsCountsAroundItself) {
  const RawMesh stripe = {{{2, 0, 1}, {4, 0, 1}, {4, 0, 9}, {2, 0, 9}}, {{0, 1, 2}, {0, 2, 3}}};
  SliceInput input = InputOf({File(Cube(0, 0, 0)), File(stripe)});
  ObjectInput& object = input.objects[0];
  object.parts.resize(3, object.parts[0]);
  input.objects.resize(1);
  object.parts[1].mesh.file = 1;
  object.parts[1].role = PartRole::kSeamEnforcer;
  object.parts[2].role = PartRole::kSeamBlocker;
  SlicingOptions options;
  options.objects[0].elephant_foot_nm = 200'000;
  const auto job = Slice(input, options);
  ASSERT_TRUE(job.ok()) << job.status();
  for (const SlicedLayer& layer : job->layers) {
    const ObjectSection& section = layer.sections[0];
    const double z = ToMm(section.z_nm) - 0.1;
    ASSERT_THAT(MarkedIn(section, PartRole::kSeamEnforcer), SizeIs(z > 1 && z < 9 ? 1 : 0)) << z;
    // The first layer's outline shrinks by its elephant foot, and the reach of the mark grows by as
    // much.
    const double reach = z < 0.2 ? 0.5 : 0.3;
    EXPECT_NEAR(Area(MarkedIn(section, PartRole::kSeamBlocker)) * 1e-12,
                (10 + 2 * reach) * (10 + 2 * reach), 1e-3);
    if (MarkedIn(section, PartRole::kSeamEnforcer).empty()) continue;
    const Box box = Bounds(MarkedIn(section, PartRole::kSeamEnforcer));
    EXPECT_EQ(box.min, (Point{-3'300'000, -5'300'000}));
    EXPECT_EQ(box.max, (Point{-700'000, -4'700'000}));
  }
  EXPECT_THAT(job->meshes, SizeIs(2)) << "that it is open is no defect";
  const auto again = Slice(input, options, 4);
  EXPECT_EQ(again->layers, job->layers);
}

/// The surface is a square of 4 mm painted on the underside of the cube, and another one on its
/// top.
TEST(LocalSlicing, LevelPaintCountsOnTheLayersThatItIsTheEdgeOf) {
  const RawMesh low = {{{3, 3, 0}, {3, 7, 0}, {7, 7, 0}, {7, 3, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const RawMesh high = {{{3, 3, 10}, {7, 3, 10}, {7, 7, 10}, {3, 7, 10}}, {{0, 1, 2}, {0, 2, 3}}};
  SliceInput input = InputOf({File(Cube(0, 0, 0)), File(low), File(high)});
  ObjectInput& object = input.objects[0];
  object.parts.resize(5, object.parts[0]);
  input.objects.resize(1);
  object.parts[1].mesh.file = object.parts[3].mesh.file = 1;
  object.parts[2].mesh.file = object.parts[4].mesh.file = 2;
  object.parts[1].role = PartRole::kSeamEnforcer;
  object.parts[2].role = PartRole::kSeamBlocker;
  object.parts[3].role = PartRole::kSupportEnforcer;
  object.parts[4].role = PartRole::kSupportBlocker;
  const auto job = Slice(input);
  ASSERT_TRUE(job.ok()) << job.status();
  const auto areas_of = [&](PartRole role) {
    std::map<int32_t, double> areas;
    for (const SlicedLayer& layer : job->layers)
      if (const double area = Area(MarkedIn(layer.sections[0], role)) * 1e-12; area > 0)
        areas[layer.frame.index] = area;
    return areas;
  };
  const int32_t last = job->layers.back().frame.index;
  const auto seam = Pair(0, DoubleNear(4.6 * 4.6, 0.1));
  EXPECT_THAT(areas_of(PartRole::kSeamEnforcer), ElementsAre(seam));
  EXPECT_THAT(areas_of(PartRole::kSeamBlocker),
              ElementsAre(Pair(last, DoubleNear(4.6 * 4.6, 0.1))));
  EXPECT_THAT(areas_of(PartRole::kSupportEnforcer),
              ElementsAre(Pair(0, DoubleNear(4.2 * 4.2, 0.1))));
  EXPECT_THAT(areas_of(PartRole::kSupportBlocker), IsEmpty()) << "no layer hangs over by a top";
  EXPECT_THAT(job->meshes, SizeIs(1));
}

/// The surface is a slope painted from x = 0 to 10 that rises from z = 2 to 6. Each layer gets the
/// strip between its own cut and the cut of the layer below.
TEST(LocalSlicing, ASlopePaintedForSupportsIsTheStripThatHangsOver) {
  const RawMesh slope = {{{0, 0, 2}, {0, 10, 2}, {10, 10, 6}, {10, 0, 6}}, {{0, 1, 2}, {0, 2, 3}}};
  SliceInput input = InputOf({File(Cube(0, 0, 0)), File(slope)});
  ObjectInput& object = input.objects[0];
  object.parts.resize(2, object.parts[0]);
  input.objects.resize(1);
  object.parts[1].mesh.file = 1;
  object.parts[1].role = PartRole::kSupportEnforcer;
  const auto job = Slice(input);
  ASSERT_TRUE(job.ok()) << job.status();
  for (const SlicedLayer& layer : job->layers) {
    const double z = ToMm(layer.sections[0].z_nm) - 0.1;  // height of the cut
    const Box box = Bounds(MarkedIn(layer.sections[0], PartRole::kSupportEnforcer));
    if (z < 2 || z > 6.2) {
      EXPECT_TRUE(box.Empty()) << z;
    } else if (z > 2.3 && z < 5.9) {
      EXPECT_NEAR(ToMm(box.max.x), (z - 2) * 2.5 - 5 + 0.1, 1e-3) << z;
      EXPECT_NEAR(ToMm(box.min.x), (z - 2.2) * 2.5 - 5 - 0.1, 1e-3) << z;
    }
  }
}

TEST(LocalSlicing, PartsModifiersAndNegativesMakeRegions) {
  SliceInput input = InputOf({File(Cube(0, 0, 0, 20)), File(Cube(0, 0, 0, 10))});
  ObjectInput& object = input.objects[0];
  object.parts.resize(3, object.parts[0]);
  input.objects.resize(1);
  object.parts[1].mesh.file = 1;
  object.parts[1].role = PartRole::kModifier;
  object.parts[1].changes = {{0, 4}};
  object.parts[2].mesh.file = 1;
  object.parts[2].role = PartRole::kNegative;
  object.parts[2].to_object(0, 3) = 15;
  const auto job = Slice(std::move(input));
  ASSERT_TRUE(job.ok()) << job.status();
  const auto area = [](const MultiPolygon& outlines) { return Area(outlines) * 1e-12; };
  const ObjectSection& low = job->layers[10].sections[0];  // modifier and negative end at 10 mm
  ASSERT_THAT(low.regions, SizeIs(2));
  EXPECT_EQ(low.regions[0].settings, 0);
  EXPECT_EQ(low.regions[1].settings, 4);
  EXPECT_NEAR(area(low.regions[1].outlines), 100, 1e-6);
  EXPECT_NEAR(area(low.regions[0].outlines), 400 - 100 - 50, 1e-6);
  EXPECT_NEAR(area(OutlineOf(low)), 350, 1e-6);
  const ObjectSection& high = job->layers[60].sections[0];
  ASSERT_THAT(high.regions, SizeIs(1));
  EXPECT_NEAR(area(OutlineOf(high)), 400, 1e-6);
}

void ExpectSame(const SlicedJob& a, const SlicedJob& b) {
  EXPECT_EQ(a.layers, b.layers);
  EXPECT_EQ(a.meshes, b.meshes);
}

TEST(LocalSlicing, DoesNotDependOnThreadsOrTheOrderOfTriangles) {
  const RawMesh sound = Joined(TorusMesh({.snap_to_layer = 0.2}), Moved(TorusMesh({}), {13, 7, 3}));
  const RawMesh broken = WithoutTriangle(WithoutTriangle(sound, 77), 3);
  for (const RawMesh& mesh : {sound, broken}) {
    const auto want = Slice(Input(mesh));
    ASSERT_TRUE(want.ok()) << want.status();
    for (const int threads : {2, 8}) {
      const auto got = Slice(Input(mesh), {}, threads);
      ASSERT_TRUE(got.ok());
      ExpectSame(*got, *want);
      EXPECT_EQ(got->thumbnails, want->thumbnails);
    }
    for (const uint32_t seed : {1u, 2u}) ExpectSame(*Slice(Input(Shuffled(mesh, seed))), *want);
  }
}

/// Returns the mesh without one face and without the level face beside it. No section cuts the
/// level face, so the opening has four edges. An opening of three edges would be closed by adding
/// the missing face.
RawMesh WithOpening(const RawMesh& mesh, size_t face) {
  const auto& gone = mesh.triangles[face];
  for (size_t i = mesh.triangles.size(); i-- > 0;) {
    const auto& other = mesh.triangles[i];
    const auto z = [&](size_t corner) { return mesh.positions[other[corner]].z(); };
    const auto shared = std::ranges::count_if(
        other, [&](uint32_t v) { return std::ranges::find(gone, v) != gone.end(); });
    if (i == face || shared != 2 || z(0) != z(1) || z(1) != z(2)) continue;
    return WithoutTriangle(WithoutTriangle(mesh, std::max(i, face)), std::min(i, face));
  }
  ADD_FAILURE() << "no level face beside it";
  return mesh;
}

TEST(LocalSlicing, OpenMeshesAreClosedAsFarAsAllowedAndReported) {
  const RawMesh open = WithOpening(Cube(0, 0, 0), 11);
  SlicingOptions options;
  options.max_gap_nm = 2 * kMm;
  const auto job = Slice(Input(open), options);
  ASSERT_TRUE(job.ok()) << job.status();
  const MeshReport& report = job->meshes[0];
  EXPECT_EQ(report.open_edges, 4);
  // Half of the side x = 10 is missing, so the gap grows from 0 to 10 mm over 50 layers.
  EXPECT_EQ(report.open_loops_closed, 10);
  EXPECT_EQ(report.open_loops_dropped, 40);
  EXPECT_NEAR(report.largest_gap_closed_mm, 1.9, 1e-6);
  EXPECT_GT(report.dropped_length_mm, 40 * 30);
  options.max_gap_nm = 0;
  const auto strict = Slice(Input(open), options);
  EXPECT_EQ(DetailOf(strict.status()).reason, Reason::kNothingToPrint);
}

TEST(LocalSlicing, ClosesCracksOfMeshesThatAreNotManifoldOnly) {
  const RawMesh near = Joined(Cube(0, 0, 0), Cube(10.05, 0, 0));
  const auto closed = Slice(Input(near));
  ASSERT_TRUE(closed.ok());
  EXPECT_THAT(closed->layers[10].sections[0].regions[0].outlines, SizeIs(2));
  EXPECT_EQ(closed->meshes[0].cracks_closed_mm, 0);
  // The third cube shares an edge with the first one.
  const auto touching = Slice(Input(Joined(near, Cube(-10, 10, 0))));
  ASSERT_TRUE(touching.ok());
  EXPECT_EQ(touching->meshes[0].non_manifold_edges, 1);
  EXPECT_EQ(touching->meshes[0].cracks_closed_mm, 0.098);
  EXPECT_NEAR(Area(touching->layers[10].sections[0].regions[0].outlines) * 1e-12, 300 + 10 * 0.05,
              0.01);
  SlicingOptions options;
  options.max_gap_nm = 20 * kMm;
  const auto open = Slice(Input(WithOpening(near, 23)), options);
  ASSERT_TRUE(open.ok());
  EXPECT_THAT(open->layers[10].sections[0].regions[0].outlines, SizeIs(1));
}

TEST(LocalSlicing, ElephantFootIsTakenOffTheFirstLayer) {
  SlicingOptions options;
  options.objects[0].elephant_foot_nm = 200'000;
  const auto job = Slice(Input(Cube(0, 0, 0)), options);
  ASSERT_TRUE(job.ok());
  EXPECT_NEAR(Area(job->layers[0].sections[0].regions[0].outlines) * 1e-12, 9.6 * 9.6, 1e-6);
  EXPECT_NEAR(Area(job->layers[1].sections[0].regions[0].outlines) * 1e-12, 100, 1e-6);
}

TEST(LocalSlicing, RefusesWithAReason) {
  const auto reason = [](SliceInput input, const SlicingOptions& options = {}) {
    return DetailOf(Slice(std::move(input), options).status()).reason;
  };
  EXPECT_EQ(reason({}), Reason::kRequestMalformed);
  EXPECT_EQ(reason({{File(Cube(0, 0, 0))}, {}}), Reason::kRequestMalformed);
  EXPECT_EQ(reason(Input(Cube(0, 0, 0), {.centers = std::vector<Point>(1001)})),
            Reason::kRequestTooLarge);
  EXPECT_EQ(reason(Input(Cube(0, 0, 0), {.unit_mm = 50})), Reason::kOutOfBuildVolume);
  EXPECT_EQ(reason(Input(Cube(0, 0, 0), {.scale = {1, 1, 0.005}})), Reason::kNothingToPrint);
  EXPECT_EQ(reason(InputOf({{"x", MeshFormat::kUnknown, "hello"}})), Reason::kMeshFormatUnknown);
  SlicingOptions flat;
  flat.objects[0].layer_height_nm = 0;
  EXPECT_EQ(reason(Input(Cube(0, 0, 0)), flat), Reason::kSettingOutOfRange);
  SlicingOptions picture;
  picture.thumbnails = {{0, 0}};
  EXPECT_EQ(reason(Input(Cube(0, 0, 0)), picture), Reason::kSettingOutOfRange);
}

TEST(LocalSlicing, ErrorsNameTheObjectWhereThereAreSeveral) {
  const MeshFile bad = {"b\nd.stl", MeshFormat::kUnknown, "solid"};
  const absl::Status alone = Slice(InputOf({bad})).status();
  EXPECT_EQ(DetailOf(alone).metadata.count("object"), 0u);
  const absl::Status second = Slice(InputOf({File(Cube(0, 0, 0)), bad})).status();
  EXPECT_EQ(second.message(), absl::StrCat("object 1 (\"b\\nd.stl\"): ", alone.message()));
  EXPECT_EQ(second.code(), alone.code());
  EXPECT_EQ(DetailOf(second).reason, DetailOf(alone).reason);
  EXPECT_EQ(DetailOf(second).metadata.at("object"), "1");
}

TEST(LocalSlicing, CanBeCancelledAtAnyPoll) {
  for (int after = 0; after < 60; ++after) {
    std::atomic<int> polls = 0;
    StageCall call;
    call.cancel = CancelToken([&] { return polls++ >= after; });
    const auto job = MakeLocalSlicing()->Slice(call, Input(Cube(0, 0, 0)), {});
    if (job.ok()) {
      EXPECT_GT(after, 50);  // at least once a layer
      continue;
    }
    EXPECT_EQ(job.status().code(), absl::StatusCode::kCancelled);
    EXPECT_EQ(DetailOf(job.status()).reason, Reason::kCancelled);
  }
}

struct ModelCase {
  std::string file;
  size_t layers;
  int64_t triangles, vertices, bodies, open_edges;
  double volume_mm3;
  double printed_mm3;  ///< printed volume; less than the mesh's volume where bodies overlap
};

/// The summed layers must match the volume of the mesh, within the error that half a layer at the
/// top and at the bottom may cause.
TEST(LocalSlicing, ModelsOfTheCorpus) {
  const std::vector<ModelCase> cases = {
      {"benchy.stl", 240, 225'154, 112'565, 1, 0, 15'550.5, 15'550.5},
      {"busted.stl", 48, 3'878, 1'941, 1, 0, 526.449, 526.449},
      {"featuretype.stl", 175, 3'476, 2'010, 1, 576, 190'544.41, 190'544.41},
      {"spot.stl", 394, 5'856, 2'930, 1, 0, 72'535.473, 72'535.473},
      {"textbox.stl", 50, 1'444, 724, 1, 0, 42'108.78, 42'108.78},
      {"thin_walls.stl", 75, 200, 134, 17, 0, 11'760, 11'520},
  };
  for (const ModelCase& c : cases) {
    const std::string bytes = CorpusFile("models/" + std::string(c.file));
    const auto job = Slice(InputOf({{c.file, MeshFormat::kUnknown, bytes}}), {}, 2);
    ASSERT_TRUE(job.ok()) << c.file << job.status();
    const MeshReport& report = job->meshes[0];
    EXPECT_EQ(job->layers.size(), c.layers) << c.file;
    EXPECT_EQ(report.triangles, c.triangles) << c.file;
    EXPECT_EQ(report.vertices, c.vertices) << c.file;
    EXPECT_EQ(report.bodies, c.bodies) << c.file;
    EXPECT_EQ(report.open_edges, c.open_edges) << c.file;
    EXPECT_EQ(report.non_manifold_edges + report.flipped_faces, 0) << c.file;
    EXPECT_EQ(report.open_loops_closed + report.open_loops_dropped, 0) << c.file;
    EXPECT_NEAR(report.volume_mm3, c.volume_mm3, c.volume_mm3 * 1e-5) << c.file;
    EXPECT_NEAR(VolumeMm3(*job), c.printed_mm3, c.printed_mm3 * 0.0035) << c.file;
  }
}

}  // namespace
}  // namespace slicefarm::slicing::local_slicing_stage_test
