#include "services/exposure/algo/local_exposure_stage.h"

#include <utility>
#include <vector>

#include "common/stage/object_layers.h"
#include "services/exposure/algo/expose_layer.h"
#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {
namespace {

class LocalExposure : public ExposureStage {
 public:
  absl::StatusOr<std::vector<ExposedProgram>> Expose(
      const StageCall& call, const Neighbourhood& neighbourhood, std::span<const Copy> copies,
      const ExposureSettings& settings) const override {
    // What a layer's text says must not depend on what is known of the whole job.
    FileFacts facts;
    facts.regions = settings.regions;
    facts.output = settings.output;
    const ObjectLayers objects(neighbourhood.layers);
    const int32_t before = neighbourhood.range.first - neighbourhood.layers.front().frame.index;
    std::vector<ExposedProgram> programs;
    for (const SlicedLayer& layer :
         neighbourhood.layers.subspan(static_cast<size_t>(before),
                                      static_cast<size_t>(neighbourhood.range.size()))) {
      auto exposed = ExposeLayer(layer, objects, settings.regions, copies, call.cancel);
      if (!exposed.ok()) return exposed.status();
      programs.push_back({layer.frame, LayerText(*exposed, facts),
                          ReportOf(*exposed, settings.regions)});
    }
    return programs;
  }

  absl::StatusOr<ExposureEnvelope> Envelope(const StageCall& /*call*/,
                                            const ExposureSummary& summary,
                                            const ExposureSettings& settings) const override {
    FileFacts facts;
    facts.layers = summary.layers;
    facts.bounds = summary.bounds;
    facts.bottom_nm = summary.bottom_nm;
    facts.top_nm = summary.top_nm;
    facts.object_names = summary.object_names;
    facts.regions = settings.regions;
    facts.output = settings.output;
    return ExposureEnvelope{FileHeader(facts), FileFooter(facts)};
  }
};

}  // namespace

std::unique_ptr<ExposureStage> MakeLocalExposure() { return std::make_unique<LocalExposure>(); }

}  // namespace slicefarm::exposure
