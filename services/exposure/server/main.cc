#include "common/rpc/server/serve.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "services/exposure/server/exposure_service.h"

int main(int argc, char** argv) {
  const auto stage = slicefarm::exposure::MakeLocalExposure();
  return slicefarm::rpc::ServeSharingStage(
      argc, argv, "exposure", "generates scan vectors for lasers", [&](auto& gate, auto& shared) {
        return slicefarm::exposure::MakeExposureService(*stage, gate, shared);
      });
}
