#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "processes/engrave/model/engrave_report.h"
#include "services/texture/algo/paths/layer_paths.h"

namespace slicefarm::texture {

using slicefarm::LayerNumbers;
using slicefarm::MapReport;
using slicefarm::Spread;

/// Returns the spread of weighted values. REQUIRES: equally many values and weights, at least one.
/// Cost: O(n log n) for n values.
Spread SpreadOf(const std::vector<double>& values, const std::vector<double>& weights);

/// Returns the report of a map: its distortion and the distances of lines.
absl::StatusOr<MapReport> MapReportOf(const EngravePlan& plan, const CancelToken& cancel = {});

/// Returns the numbers of a layer for the report.
LayerNumbers NumbersOf(const LayerPath& path);

}  // namespace slicefarm::texture
