#include "common/rpc/server/serve.h"
#include "services/planning/server/planning_service.h"

int main(int argc, char** argv) {
  return slicefarm::rpc::ServeStage(argc, argv, "planning", "What is decided over a whole job",
                                    slicefarm::planning::MakePlanningService);
}
