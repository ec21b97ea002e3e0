#include "common/rpc/server/serve.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/motion/server/motion_service.h"

int main(int argc, char** argv) {
  const auto stage = slicefarm::motion::MakeLocalMotion();
  return slicefarm::rpc::ServeSharingStage(
      argc, argv, "motion", "converts paths to G-code", [&](auto& gate, auto& shared) {
        return slicefarm::motion::MakeMotionService(*stage, gate, shared);
      });
}
