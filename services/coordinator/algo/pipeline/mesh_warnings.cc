#include "services/coordinator/algo/pipeline/mesh_warnings.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace slicefarm::coordinator {
namespace {

/// Returns the count with its noun: "1 edge", "3 edges".
std::string Count(int64_t count, const char* noun) {
  return absl::StrCat(count, " ", noun, count == 1 ? "" : "s");
}

}  // namespace

std::vector<std::string> MeshWarnings(const MeshReport& mesh) {
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& what) {
    warnings.push_back(mesh.name.empty() ? what : mesh.name + ": " + what);
  };
  if (mesh.open_edges > 0) {
    warn("the surface is not closed: " + Count(mesh.open_edges, "edge") + " with one face only");
  }
  if (mesh.non_manifold_edges > 0) {
    warn(Count(mesh.non_manifold_edges, "edge") + " with more than two faces");
  }
  if (mesh.flipped_faces > 0) {
    warn(Count(mesh.flipped_faces, "face") + " with the wrong orientation, flipped");
  }
  if (mesh.degenerate_faces > 0) {
    warn(Count(mesh.degenerate_faces, "face") + " without area, omitted");
  }
  if (mesh.repeated_faces > 0) {
    warn(Count(mesh.repeated_faces, "face") + " that the file repeats, omitted");
  }
  if (mesh.volume_mm3 < 0) warn("the whole mesh is inside out");
  if (mesh.open_loops_closed > 0) {
    warn(absl::StrFormat("%s closed over gaps of up to %.3f mm",
                         Count(mesh.open_loops_closed, "open outline"),
                         mesh.largest_gap_closed_mm));
  }
  if (mesh.open_loops_dropped > 0) {
    warn(absl::StrFormat("%s of %.1f mm together could not be closed and are not printed",
                         Count(mesh.open_loops_dropped, "open outline"), mesh.dropped_length_mm));
  }
  if (mesh.cracks_closed_mm > 0) {
    warn(absl::StrFormat("cracks of up to %.3f mm were closed (slice_closing_radius)",
                         mesh.cracks_closed_mm));
  }
  if (mesh.copies_off_bed > 0) {
    warn(
        absl::StrCat(mesh.copies_off_bed, mesh.copies_off_bed == 1
                                              ? " copy is outside the bed and is not printed"
                                              : " copies are outside the bed and are not printed"));
  }
  if (mesh.overlapping_copies > 0) {
    warn(absl::StrCat(
        mesh.overlapping_copies, mesh.overlapping_copies == 1 ? " copy shares" : " copies share",
        " space with other copies: overlapping copies are printed through each other"));
  }
  return warnings;
}

}  // namespace slicefarm::coordinator
