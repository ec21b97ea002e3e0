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
  /// Errors: SETTING_MALFORMED.
  static absl::StatusOr<HeightTexts> Of(const MotionOptions& options);

  bool empty() const { return codes_.empty(); }

  /// Whether there is any in the layer.
  bool IsAt(const LayerFrame& layer) const { return !CodesIn(layer).empty(); }

  /// Whether such a code leaves the filament ready to print: M600 and its like prime it.
  bool PrimesAt(const LayerFrame& layer) const;

  /// That of the codes whose height is in the layer: above the top of the layer below, and not
  /// above its own. `variables`: as the layer's other templates have them. Errors: those of
  /// RunTemplate. Cost: O(log codes) of layers without any.
  absl::StatusOr<std::string> At(const LayerFrame& layer, const macro::JobCode& code,
                                 const macro::TemplateScope& variables,
                                 macro::TemplateMemory& memory) const;

 private:
  std::span<const HeightCode> CodesIn(const LayerFrame& layer) const;

  std::vector<HeightCode> codes_;  ///< by height
  int32_t tool_ = 0;
};

/// What stands after the move up to a layer: layer_gcode, then what belongs to its height, each
/// with its last line ended. Errors: those of RunTemplate.
absl::StatusOr<std::string> CodeAfterChange(const LayerFrame& layer, const macro::JobCode& code,
                                            const HeightTexts& heights,
                                            const macro::TemplateScope& variables,
                                            macro::TemplateMemory& memory);

}  // namespace slicefarm::motion
