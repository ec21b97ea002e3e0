#include "services/coordinator/algo/pipeline/mesh_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::coordinator::mesh_warnings_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(MeshWarnings, NoneForACleanMesh) {
  EXPECT_THAT(MeshWarnings({.name = "cube.stl", .triangles = 12, .volume_mm3 = 1}), IsEmpty());
}

TEST(MeshWarnings, SaysWhatIsWrong) {
  MeshReport mesh;
  mesh.name = "a.stl";
  mesh.open_edges = 1;
  mesh.non_manifold_edges = 2;
  mesh.flipped_faces = 3;
  mesh.degenerate_faces = 4;
  mesh.repeated_faces = 1;
  mesh.volume_mm3 = -1;
  mesh.open_loops_closed = 5;
  mesh.largest_gap_closed_mm = 0.25;
  mesh.open_loops_dropped = 1;
  mesh.dropped_length_mm = 12.34;
  mesh.cracks_closed_mm = 0.098;
  mesh.copies_off_bed = 1;
  mesh.overlapping_copies = 2;
  EXPECT_THAT(
      MeshWarnings(mesh),
      ElementsAre(
          "a.stl: the surface is not closed: 1 edge with one face only",
          "a.stl: 2 edges with more than two faces",
          "a.stl: 3 faces with the wrong orientation, flipped",
          "a.stl: 4 faces without area, omitted", "a.stl: 1 face that the file repeats, omitted",
          "a.stl: the whole mesh is inside out",
          "a.stl: 5 open outlines closed over gaps of up to 0.250 mm",
          "a.stl: 1 open outline of 12.3 mm together could not be closed and are not printed",
          "a.stl: cracks of up to 0.098 mm were closed (slice_closing_radius)",
          "a.stl: 1 copy is outside the bed and is not printed",
          "a.stl: 2 copies share space with other copies: overlapping copies are printed through "
          "each other"));
}

TEST(MeshWarnings, NeedsNoName) {
  MeshReport mesh;
  mesh.open_edges = 2;
  EXPECT_THAT(MeshWarnings(mesh),
              ElementsAre("the surface is not closed: 2 edges with one face only"));
}

}  // namespace
}  // namespace slicefarm::coordinator::mesh_warnings_test
