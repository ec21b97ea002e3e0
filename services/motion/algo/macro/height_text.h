#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/macro/job_code.h"
#include "common/macro/template_run.h"
#include "common/model/layers/layer.h"
#include "common/model/options/height_code.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Codes at heights of the print (pauses, changes of colour, other G-code), with the comments that
/// PrusaSlicer writes.
class HeightTexts {
 public:
  /// Reads the codes from the options. Errors: SETTING_MALFORMED.
  static absl::StatusOr<HeightTexts> Of(const MotionOptions& options);

  bool empty() const { return codes_.empty(); }

  /// Returns true if at least one code is executed in the layer.
  bool IsAt(const LayerFrame& layer) const { return !CodesIn(layer).empty(); }

  /// Returns true if the layer has a change of colour. M600 and similar commands leave the filament
  /// primed.
  bool PrimesAt(const LayerFrame& layer) const;

  /// Returns true if a code changes the length of retractions.
  bool ChangesRetraction() const { return !lengths_.empty(); }
  /// Returns the length of retractions of the layer with its top at `z_nm`, in mm. `usual_mm`: the
  /// length below all codes that change it.
  double RetractLengthMm(Coord z_nm, double usual_mm) const;

  /// Returns the text of the layer's codes: the codes with a height above the top of the layer
  /// below, up to and including the layer's own top. `variables`: as for the layer's other
  /// templates. Errors: as RunTemplate. Cost: O(log codes) if the layer has no code.
  absl::StatusOr<std::string> At(const LayerFrame& layer, const macro::JobCode& code,
                                 const macro::TemplateScope& variables,
                                 macro::TemplateMemory& memory) const;

 private:
  std::span<const HeightCode> CodesIn(const LayerFrame& layer) const;

  std::vector<HeightCode> codes_;                  ///< codes, sorted by height
  std::vector<std::pair<Coord, double>> lengths_;  ///< retractions in mm, from heights on
  int32_t tool_ = 0;
};

/// Returns the G-code after the nozzle's move up to a layer: layer_gcode, then the codes at the
/// layer's height, each ended by a newline. Errors: as RunTemplate.
absl::StatusOr<std::string> CodeAfterChange(const LayerFrame& layer, const macro::JobCode& code,
                                            const HeightTexts& heights,
                                            const macro::TemplateScope& variables,
                                            macro::TemplateMemory& memory);

}  // namespace slicefarm::motion
