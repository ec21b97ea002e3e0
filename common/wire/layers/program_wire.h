#pragma once

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layer_warning.h"
#include "common/model/layers/layer.h"
#include "common/model/layers/program_summary.h"
#include "common/stage/stage_list.h"
#include "slicefarm/v1/layer.pb.h"
#include "slicefarm/v1/motion.pb.h"

namespace slicefarm {

// Conversion of programs and of the texts before and after them. G-code is moved, not copied, if
// the argument is an rvalue or passed by value. Errors, with the name of the field: OUT_OF_RANGE,
// REQUEST_MALFORMED.

/// Converts the totals of a feature to their message and back.
void ToProto(const FeatureUse& use, v1::FeatureUse* proto);
absl::StatusOr<FeatureUse> FromProto(const v1::FeatureUse& proto);

/// Converts the totals of a program to their message and back.
absl::Status ToProto(const ProgramStats& stats, v1::ProgramStats* proto);
absl::StatusOr<ProgramStats> FromProto(const v1::ProgramStats& proto);

/// Converts a layer program to its message and back.
absl::Status ToProto(LayerProgram program, v1::LayerProgram* proto);
absl::StatusOr<LayerProgram> FromProto(v1::LayerProgram proto);

/// Converts a layer warning to its message and back.
v1::LayerWarning ToProto(const LayerWarning& warning);
absl::StatusOr<LayerWarning> FromProto(const v1::LayerWarning& proto);

/// Converts the times of the stages to their message and back.
v1::StageTimes ToProto(const StageTimes& times);
absl::StatusOr<StageTimes> FromProto(const v1::StageTimes& proto);

/// Converts a layer summary to its message and back.
absl::Status ToProto(const LayerSummary& layer, v1::LayerSummary* proto);
absl::StatusOr<LayerSummary> FromProto(const v1::LayerSummary& proto);

/// Converts a summary to all fields of ProgramEnvelopeRequest except `call` and the options, and
/// back.
absl::Status ToProto(const ProgramSummary& summary, v1::ProgramEnvelopeRequest* proto);
absl::StatusOr<ProgramSummary> FromProto(const v1::ProgramEnvelopeRequest& proto);

/// Converts the texts before and after a program to their message and back.
v1::ProgramEnvelope ToProto(ProgramEnvelope envelope);
absl::StatusOr<ProgramEnvelope> FromProto(v1::ProgramEnvelope proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
