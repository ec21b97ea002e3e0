#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/macro/job_code.h"
#include "common/macro/template_value.h"
#include "common/model/job_facts.h"
#include "services/motion/algo/macro/height_text.h"
#include "services/motion/algo/toolpath/layer_place.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// before_layer_gcode and layer_gcode, filled in.
struct CustomCode {
  std::string before;
  std::string after;  ///< what stands at the layer's height is the end of it
  /// They are filled in later, by FrameProgram; the layer keeps their places.
  bool waits = false;
  bool names_layer_change = false;  ///< before_layer_gcode writes ;BEFORE_LAYER_CHANGE itself
  bool has_after = false;           ///< `after` is there, filled in or not
  bool primes = false;              ///< `after` leaves the filament ready to print
  bool climbs = false;              ///< `after` moves in z
};

/// The templates that stand in layers, parsed once for all of them.
class LayerCode {
 public:
  /// Errors: those of ParseTemplate. `options` must outlive it.
  static absl::StatusOr<LayerCode> Of(const MotionOptions& options);

  /// Errors: those of RunTemplate.
  absl::StatusOr<CustomCode> At(const LayerFrame& layer, const LayerPlace& place,
                                const JobFacts& facts) const;

 private:
  macro::JobCode code_;
  HeightTexts heights_;
  macro::TemplateVariables job_;
  bool any_ = false;
  bool names_layer_change_ = false;
  bool has_after_ = false;
  bool climbs_ = false;
};

}  // namespace slicefarm::motion
