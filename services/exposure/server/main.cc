#include "common/rpc/server/serve.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "services/exposure/server/exposure_service.h"

int main(int argc, char** argv) {
  return slicefarm::rpc::ServeStage<slicefarm::exposure::ExposureService>(
      argc, argv, "exposure", "Scan vectors of lasers",
      *slicefarm::exposure::MakeLocalExposure());
}
