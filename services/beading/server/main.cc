#include "common/rpc/server/serve.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/beading/server/beading_service.h"

int main(int argc, char** argv) {
  return slicefarm::rpc::ServeStage<slicefarm::beading::BeadingService>(
      argc, argv, "beading", "Outlines to walls", *slicefarm::beading::MakeLocalBeading());
}
