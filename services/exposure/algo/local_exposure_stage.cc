#include "services/exposure/algo/local_exposure_stage.h"

#include <utility>
#include <vector>

#include "common/stage/exposure_job.h"
#include "common/stage/object_layers.h"
#include "services/exposure/algo/expose_layer.h"
#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {
namespace {

FileFacts FactsOf(const ExposureSummary& summary, const ExposureSettings& settings) {
  FileFacts facts;
  facts.layers = static_cast<int32_t>(summary.layers.size());
  facts.bounds = summary.bounds;
  if (!summary.layers.empty()) {
    facts.bottom_nm = summary.layers.front().print_z_nm - summary.layers.front().height_nm;
    facts.top_nm = summary.layers.back().print_z_nm;
  }
  facts.object_names = summary.object_names;
  facts.regions = settings.regions;
  facts.output = settings.output;
  return facts;
}

class LocalExposure : public ExposureStage {
 public:
  absl::StatusOr<std::vector<ExposedProgram>> Expose(
      const StageCall& call, const Neighbourhood& neighbourhood,
      const Shared<ExposureJob>& job) const override {
    const ExposureSettings& settings = job->settings;
    // A layer's text must not depend on facts about the whole job.
    FileFacts facts;
    facts.regions = settings.regions;
    facts.output = settings.output;
    const ObjectLayers objects(neighbourhood.layers);
    const int32_t before = neighbourhood.range.first - neighbourhood.layers.front().frame.index;
    std::vector<ExposedProgram> programs;
    for (const SlicedLayer& layer : neighbourhood.layers.subspan(
             static_cast<size_t>(before), static_cast<size_t>(neighbourhood.range.size()))) {
      auto exposed = ExposeLayer(layer, objects, settings.regions, job->copies, call.cancel);
      if (!exposed.ok()) return exposed.status();
      programs.push_back(
          {layer.frame, LayerText(*exposed, facts), ReportOf(*exposed, settings.regions)});
    }
    return programs;
  }

  absl::StatusOr<ExposureEnvelope> Envelope(const StageCall& /*call*/,
                                            const ExposureSummary& summary,
                                            const ExposureSettings& settings) const override {
    FileFacts facts = FactsOf(summary, settings);
    if (!HasLayerHeads(facts.output.format))
      return ExposureEnvelope{FileHeader(facts), {}, FileFooter(facts)};
    const auto own = FillIn(settings.output, summary);
    if (!own.ok()) return own.status();
    facts.start_code = own->start;
    facts.end_code = own->end;
    ExposureEnvelope envelope{FileHeader(facts), {}, FileFooter(facts)};
    for (size_t i = 0; i < summary.layers.size(); ++i)
      envelope.layer_heads.push_back(LayerHead(summary.layers[i], own->layers[i]));
    return envelope;
  }
};

}  // namespace

std::unique_ptr<ExposureStage> MakeLocalExposure() { return std::make_unique<LocalExposure>(); }

}  // namespace slicefarm::exposure
