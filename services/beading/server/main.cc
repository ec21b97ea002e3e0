#include "common/rpc/server/serve.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/beading/server/beading_service.h"

int main(int argc, char** argv) {
  const auto stage = slicefarm::beading::MakeLocalBeading();
  return slicefarm::rpc::ServeSharingStage(
      argc, argv, "beading", "generates walls from outlines", [&](auto& gate, auto& shared) {
        return slicefarm::beading::MakeBeadingService(*stage, gate, shared);
      });
}
