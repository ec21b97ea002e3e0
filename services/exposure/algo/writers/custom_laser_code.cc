#include "services/exposure/algo/writers/custom_laser_code.h"

#include <utility>

#include "common/macro/exposure_code.h"
#include "common/macro/setting_variables.h"
#include "common/macro/template_run.h"

namespace slicefarm::exposure {
namespace {

/// Template filler that processes the templates in the order of the file.
class CodeFiller {
 public:
  explicit CodeFiller(const ExposureSummary& summary)
      : job_(macro::ExposurePrintVariables(summary)) {
    macro::AddSettingVariables(summary.settings_text, job_);
  }

  void MoveTo(int32_t layer, Coord z_nm) { now_ = macro::ExposureLayerVariables(layer, z_nm); }

  absl::Status Fill(const macro::Template& code, std::string& text) {
    auto filled = macro::RunTemplate(code, {job_, now_}, memory_);
    if (!filled.ok()) return filled.status();
    text = *std::move(filled);
    if (!text.empty() && text.back() != '\n') text += '\n';
    return absl::OkStatus();
  }

 private:
  macro::TemplateVariables job_, now_;
  macro::TemplateMemory memory_;
};

}  // namespace

absl::StatusOr<CustomLaserCode> FillIn(const ExposureOutput& output,
                                       const ExposureSummary& summary) {
  const auto code = macro::ParseExposureCode(output);
  if (!code.ok()) return code.status();
  CustomLaserCode own;
  CodeFiller filler(summary);
  filler.MoveTo(-1, 0);
  if (absl::Status ok = filler.Fill(code->start, own.start); !ok.ok()) return ok;
  for (const LayerFrame& layer : summary.layers) {
    filler.MoveTo(layer.index, layer.print_z_nm);
    LayerCode& texts = own.layers.emplace_back();
    if (absl::Status ok = filler.Fill(code->before_layer, texts.before); !ok.ok()) return ok;
    if (absl::Status ok = filler.Fill(code->layer, texts.after); !ok.ok()) return ok;
  }
  if (absl::Status ok = filler.Fill(code->end, own.end); !ok.ok()) return ok;
  return own;
}

}  // namespace slicefarm::exposure
