#include "common/rpc/server/serve.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/ordering/server/ordering_service.h"

int main(int argc, char** argv) {
  return slicefarm::rpc::ServeStage<slicefarm::ordering::OrderingService>(
      argc, argv, "ordering", "The order and direction of paths",
      *slicefarm::ordering::MakeLocalOrdering());
}
