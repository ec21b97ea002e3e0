#include "common/rpc/server/serve.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/infill/server/infill_service.h"

int main(int argc, char** argv) {
  return slicefarm::rpc::ServeStage<slicefarm::infill::InfillService>(
      argc, argv, "infill", "Skins and infill", *slicefarm::infill::MakeLocalInfill());
}
