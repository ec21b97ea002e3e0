#include "common/rpc/server/serve.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/motion/server/motion_service.h"

int main(int argc, char** argv) {
  return slicefarm::rpc::ServeStage<slicefarm::motion::MotionService>(
      argc, argv, "motion", "Paths to G-code", *slicefarm::motion::MakeLocalMotion());
}
