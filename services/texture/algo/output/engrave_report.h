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

/// Returns the percentiles (1, 50, 99) of weighted values. REQUIRES: equally many values and
/// weights, at least one. Cost: O(n log n) for n values.
Spread SpreadOf(const std::vector<double>& values, const std::vector<double>& weights);

/// Returns the report of a map: its distortion, and the distances of the first layer's lines on the
/// surface.
absl::StatusOr<MapReport> MapReportOf(const EngravePlan& plan, const CancelToken& cancel = {});

/// Returns a layer's entry of the report.
LayerNumbers NumbersOf(const LayerPath& path);

}  // namespace slicefarm::texture
