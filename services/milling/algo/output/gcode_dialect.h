#pragma once

#include <memory>
#include <string>

#include "processes/mill/model/milling_options.h"

namespace slicefarm::milling {

/// Text before and after the moves of a program, which depends on the controller. All controllers
/// read equal text of the moves.
class GcodeDialect {
 public:
  virtual ~GcodeDialect() = default;

  /// Returns the lines before the moves, with line ends: units, plane, modes, tool and its length,
  /// move to the safe height, spindle and coolant.
  virtual std::string Start(const MachiningOptions& machining, double tolerance_mm,
                            double safe_z_mm) const = 0;
  /// Returns the lines after the moves. The tool is at the safe height.
  virtual std::string End() const = 0;
};

/// Returns the dialect of a controller.
std::unique_ptr<GcodeDialect> DialectOf(MillDialect dialect);

}  // namespace slicefarm::milling
