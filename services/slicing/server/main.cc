#include "common/rpc/serve.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/server/slicing_service.h"

int main(int argc, char** argv) {
  return slicefarm::rpc::ServeStage<slicefarm::slicing::SlicingService>(
      argc, argv, "slicing", "Meshes to outlines", *slicefarm::slicing::MakeLocalSlicing());
}
