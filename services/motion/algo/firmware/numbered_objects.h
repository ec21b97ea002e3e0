#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Firmwares that identify copies by number (M486 of Marlin and RepRapFirmware).
class NumberedObjects : public Firmware {
 public:
  std::string LabelOf(std::string_view name, size_t index) const override;
  void DefineCopies(std::span<const CopySummary> copies, std::span<const std::string> labels,
                    GcodeText& out) const override;
  void BeginCopy(std::string_view label, size_t index, GcodeText& out) const override;
  void EndCopy(std::string_view label, size_t index, GcodeText& out) const override;
  bool LabelsLast() const override { return true; }
};

}  // namespace slicefarm::motion
