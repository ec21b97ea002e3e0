#pragma once

#include <set>
#include <string>

#include "absl/status/statusor.h"
#include "common/macro/job_code.h"
#include "common/macro/template_value.h"
#include "common/model/job_facts.h"
#include "services/motion/algo/macro/height_text.h"
#include "services/motion/algo/macro/role_code.h"
#include "services/motion/algo/toolpath/layer_context.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Filled-in before_layer_gcode and layer_gcode of one layer.
struct CustomCode {
  std::string before;
  std::string after;  ///< filled-in layer_gcode, then the codes at the layer's height
  /// True if FrameProgram fills in both texts later, because they depend on earlier layers. The
  /// layer's program records where to insert them.
  bool waits = false;
  /// true if before_layer_gcode writes ;BEFORE_LAYER_CHANGE itself
  bool names_layer_change = false;
  bool has_after = false;  ///< true if `after` will have text, now or when FrameProgram fills it in
  bool primes = false;     ///< true if `after` leaves the filament ready to print
  bool moves = false;      ///< true if `after` moves the nozzle
};

/// Templates of the layers, parsed once for all of them.
class LayerCode {
 public:
  /// Parses the templates. `options` must outlive the result. Errors: as ParseTemplate.
  static absl::StatusOr<LayerCode> Of(const MotionOptions& options);

  /// Fills in the code of a layer. Errors: as RunTemplate.
  absl::StatusOr<CustomCode> At(const LayerFrame& layer, const LayerContext& context,
                                const JobFacts& facts) const;

  const HeightTexts& heights() const { return heights_; }

  /// Returns true if there is G-code between features.
  bool HasRoles() const { return has_roles_; }
  /// Fills in the code between features for these changes. Errors: as RunTemplate.
  absl::StatusOr<RoleTexts> RolesAt(const LayerContext& context, const JobFacts& facts,
                                    const std::set<RoleChange>& changes) const;

 private:
  macro::JobCode code_;
  HeightTexts heights_;
  macro::TemplateVariables job_;
  bool any_ = false;
  bool names_layer_change_ = false;
  bool has_after_ = false;
  bool moves_ = false;
  bool has_roles_ = false;
};

}  // namespace slicefarm::motion
