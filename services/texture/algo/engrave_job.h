#pragma once

#include "absl/status/statusor.h"
#include "processes/engrave/model/engrave_input.h"
#include "services/texture/algo/output/engrave_program.h"
#include "services/texture/algo/paths/engrave_plan.h"

namespace slicefarm::texture {

/// Data that all layers of a job share. They are the result of steps 8 to 10 of
/// docs/algorithms/texture.md.
struct EngraveJob {
  EngravePlan plan;
  ProgramOptions program;
  EngraveFormat format = EngraveFormat::kCsv;
  double displaced_edge_mm = 0.2;
};

/// Prepares a job. Errors: any error of reading the texture, of NumbersOf, of BoundaryOfDisk and of
/// PlanEngraving; REQUEST_MALFORMED for a map with flipped triangles.
absl::StatusOr<EngraveJob> PrepareEngraving(const EngraveInput& input);

}  // namespace slicefarm::texture
