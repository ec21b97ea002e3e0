#pragma once

#include <type_traits>
#include <variant>

#include "common/model/engraving/engrave_settings.h"
#include "common/model/milling/milling_options.h"
#include "common/model/options/exposure_settings.h"
#include "common/model/options/fdm_settings.h"
#include "common/model/options/slicing_options.h"
#include "common/model/process.h"

namespace slicefarm {

/// Settings of a plate that one process alone has. One alternative per process, in the order of
/// Process.
using OwnSettings = std::variant<FdmSettings, ExposureSettings, MillSettings, EngraveSettings>;
/// Rows of one resolved set that one process alone has, in the same order.
using OwnRows = std::variant<FdmRows, ExposureRows, MillSettings, EngraveSettings>;

static_assert(std::variant_size_v<OwnSettings> == kProcessCount);
static_assert(std::variant_size_v<OwnRows> == kProcessCount);

/// Settings of a plate, complete and validated: tables with a row for each object, region and tool.
struct JobSettings {
  SlicingOptions slicing;
  OwnSettings own;

  Process process() const { return static_cast<Process>(own.index()); }

  friend bool operator==(const JobSettings&, const JobSettings&) = default;
};

/// One resolved set of settings: a row of each scope.
struct JobRows {
  JobSlicingOptions slicing;
  ObjectSlicingOptions object;
  OwnRows own;

  Process process() const { return static_cast<Process>(own.index()); }

  friend bool operator==(const JobRows&, const JobRows&) = default;
};

// Settings of one process. REQUIRES: the job is of that process.
inline const FdmSettings& FdmOf(const JobSettings& settings) {
  return std::get<FdmSettings>(settings.own);
}
inline FdmSettings& FdmOf(JobSettings& settings) { return std::get<FdmSettings>(settings.own); }
inline const FdmRows& FdmOf(const JobRows& rows) { return std::get<FdmRows>(rows.own); }
inline FdmRows& FdmOf(JobRows& rows) { return std::get<FdmRows>(rows.own); }

inline const ExposureSettings& ExposureOf(const JobSettings& settings) {
  return std::get<ExposureSettings>(settings.own);
}
inline ExposureSettings& ExposureOf(JobSettings& settings) {
  return std::get<ExposureSettings>(settings.own);
}
inline const ExposureRows& ExposureOf(const JobRows& rows) {
  return std::get<ExposureRows>(rows.own);
}
inline ExposureRows& ExposureOf(JobRows& rows) { return std::get<ExposureRows>(rows.own); }

// These processes have no settings by object or region: a plate and a set have the same ones.
template <typename Settings>
auto& MillOf(Settings& settings) {
  return std::get<MillSettings>(settings.own);
}
template <typename Settings>
auto& EngraveOf(Settings& settings) {
  return std::get<EngraveSettings>(settings.own);
}

}  // namespace slicefarm
