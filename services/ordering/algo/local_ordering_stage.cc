#include "services/ordering/algo/local_ordering_stage.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/stage/ordering_job.h"
#include "services/ordering/algo/layer_order.h"

namespace slicefarm::ordering {
namespace {

class LocalOrdering : public OrderingStage {
 public:
  absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall& call,
                                                  std::vector<FilledLayer> layers,
                                                  std::span<const LayerPlan> plans,
                                                  const Shared<OrderingJob>& job) const override {
    if (plans.size() != layers.size()) {
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                       absl::StrCat(layers.size(), " layers, but ", plans.size(), " plans"));
    }
    std::vector<OrderedLayer> ordered;
    ordered.reserve(layers.size());
    for (size_t i = 0; i < layers.size(); ++i) {
      if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
      auto layer = OrderLayer(std::move(layers[i]), plans[i], job->copies, job->options);
      if (!layer.ok()) return layer.status();
      ordered.push_back(*std::move(layer));
    }
    return ordered;
  }
};

}  // namespace

std::unique_ptr<OrderingStage> MakeLocalOrdering() { return std::make_unique<LocalOrdering>(); }

}  // namespace slicefarm::ordering
