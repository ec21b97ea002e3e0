#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/model/layers/layer.h"
#include "common/stage/neighbourhood.h"
#include "common/stage/stage_call.h"

namespace slicefarm {

struct BeadingOptions;

/// Wall options of all regions, indexed by Region::settings. All calls of a job share the table. A
/// server receives and parses it only once (common/wire/shared_wire.h).
using BeadingTable = std::vector<BeadingOptions>;

/// Stage that computes the walls. It returns one layer for each layer of neighbourhood.range, in
/// order.
class BeadingStage {
 public:
  virtual ~BeadingStage() = default;
  virtual absl::StatusOr<std::vector<WalledLayer>> Bead(
      const StageCall& call, const Neighbourhood& neighbourhood,
      const Shared<BeadingTable>& regions) const = 0;
};

}  // namespace slicefarm
