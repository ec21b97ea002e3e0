#include "common/rpc/server/serve.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/infill/server/infill_service.h"

int main(int argc, char** argv) {
  const auto stage = slicefarm::infill::MakeLocalInfill();
  return slicefarm::rpc::ServeSharingStage(
      argc, argv, "infill", "generates solid and sparse infill", [&](auto& gate, auto& shared) {
        return slicefarm::infill::MakeInfillService(*stage, gate, shared);
      });
}
