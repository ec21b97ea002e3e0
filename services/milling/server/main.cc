#include "common/rpc/server/serve.h"
#include "services/milling/algo/local_milling_stage.h"
#include "services/milling/server/milling_service.h"

int main(int argc, char** argv) {
  const auto stage = slicefarm::milling::MakeLocalMilling();
  return slicefarm::rpc::ServeSharingStage(
      argc, argv, "milling", "generates programs for milling machines",
      [&](auto& gate, auto& shared) {
        return slicefarm::milling::MakeMillingService(*stage, gate, shared);
      });
}
