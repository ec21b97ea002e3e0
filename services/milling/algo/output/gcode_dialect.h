#pragma once

#include <memory>
#include <string>

#include "processes/mill/model/milling_options.h"

namespace slicefarm::milling {

/// What controllers want differently before and after the moves; moves are the same for all.
class GcodeDialect {
 public:
  virtual ~GcodeDialect() = default;

  /// Units, plane, modes, tool and its length, up to the safe height, spindle and coolant: lines
  /// with ends.
  virtual std::string Start(const MachiningOptions& machining, double tolerance_mm,
                            double safe_z_mm) const = 0;
  /// The tool is at the safe height.
  virtual std::string End() const = 0;
};

std::unique_ptr<GcodeDialect> DialectOf(MillDialect dialect);

}  // namespace slicefarm::milling
