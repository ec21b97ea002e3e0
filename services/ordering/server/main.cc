#include "common/rpc/server/serve.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/ordering/server/ordering_service.h"

int main(int argc, char** argv) {
  const auto stage = slicefarm::ordering::MakeLocalOrdering();
  return slicefarm::rpc::ServeSharingStage(
      argc, argv, "ordering", "orders and directs paths", [&](auto& gate, auto& shared) {
        return slicefarm::ordering::MakeOrderingService(*stage, gate, shared);
      });
}
