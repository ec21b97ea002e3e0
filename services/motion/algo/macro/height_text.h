#pragma once

#include <span>
#include <string>
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

/// Pauses, changes of colour and other G-code at heights of the print, in PrusaSlicer's words.
class HeightTexts {
 public:
  /// Reads the codes from the options. Errors: SETTING_MALFORMED.
  static absl::StatusOr<HeightTexts> Of(const MotionOptions& options);

  bool empty() const { return codes_.empty(); }

  /// Returns true if the layer has a code.
  bool IsAt(const LayerFrame& layer) const { return !CodesIn(layer).empty(); }

  /// Returns true if a code of the layer leaves the filament ready to print. M600 and similar
  /// commands prime the filament.
  bool PrimesAt(const LayerFrame& layer) const;

  /// Returns the text of the codes with a height in the layer: above the top of the layer below,
  /// and not above the layer's own top. `variables`: as for the layer's other templates. Errors: as
  /// RunTemplate. Cost: O(log codes) for layers without any.
  absl::StatusOr<std::string> At(const LayerFrame& layer, const macro::JobCode& code,
                                 const macro::TemplateScope& variables,
                                 macro::TemplateMemory& memory) const;

 private:
  std::span<const HeightCode> CodesIn(const LayerFrame& layer) const;

  std::vector<HeightCode> codes_;  ///< codes, sorted by height
  int32_t tool_ = 0;
};

/// Returns the code after the move up to a layer: layer_gcode, then the codes of its height, each
/// ended by a newline. Errors: as RunTemplate.
absl::StatusOr<std::string> CodeAfterChange(const LayerFrame& layer, const macro::JobCode& code,
                                            const HeightTexts& heights,
                                            const macro::TemplateScope& variables,
                                            macro::TemplateMemory& memory);

}  // namespace slicefarm::motion
