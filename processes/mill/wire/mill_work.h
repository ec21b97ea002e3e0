#pragma once

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/milling/milled_step.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// MillTask as it travels.
struct MillWork {
  StepRange steps;
  MillPhase phase = MillPhase::kRoughing;
  int32_t phase_first = 0;
  int32_t weight = 0;
  std::string shared;  ///< the digest of its MillInput

  friend bool operator==(const MillWork&, const MillWork&) = default;
};

/// Errors: REQUEST_MALFORMED with the way to the field.
absl::Status ToProto(const MillWork& work, v1::MillWork* proto);
absl::StatusOr<MillWork> FromProto(const v1::MillWork& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
