#pragma once

#include <variant>

#include "common/model/engraving/engrave_settings.h"
#include "common/model/milling/milling_options.h"
#include "common/model/options/exposure_settings.h"
#include "common/model/options/fdm_settings.h"
#include "common/model/options/slicing_options.h"
#include "common/model/process.h"

namespace slicefarm {

/// What each process has of its own. One alternative a process, in the order of Process.
using OwnSettings = std::variant<FdmSettings, ExposureSettings, MillSettings, EngraveSettings>;

static_assert(std::variant_size_v<OwnSettings> == kProcessCount);

/// What a job is to be made with: complete and validated (common/config does both at the edge).
struct JobSettings {
  SlicingOptions slicing;
  OwnSettings own;  ///< of its process

  Process process() const { return static_cast<Process>(own.index()); }

  friend bool operator==(const JobSettings&, const JobSettings&) = default;
};

/// REQUIRES: the job is of that process.
inline const FdmSettings& FdmOf(const JobSettings& settings) {
  return std::get<FdmSettings>(settings.own);
}
inline FdmSettings& FdmOf(JobSettings& settings) { return std::get<FdmSettings>(settings.own); }
inline const ExposureSettings& ExposureOf(const JobSettings& settings) {
  return std::get<ExposureSettings>(settings.own);
}
inline ExposureSettings& ExposureOf(JobSettings& settings) {
  return std::get<ExposureSettings>(settings.own);
}

inline const MillSettings& MillOf(const JobSettings& settings) {
  return std::get<MillSettings>(settings.own);
}
inline MillSettings& MillOf(JobSettings& settings) { return std::get<MillSettings>(settings.own); }

inline const EngraveSettings& EngraveOf(const JobSettings& settings) {
  return std::get<EngraveSettings>(settings.own);
}
inline EngraveSettings& EngraveOf(JobSettings& settings) {
  return std::get<EngraveSettings>(settings.own);
}

}  // namespace slicefarm
