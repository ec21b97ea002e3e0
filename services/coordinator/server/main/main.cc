#include "services/coordinator/server/main/coordinator_program.h"

int main(int argc, char** argv) { return slicefarm::coordinator::Main(argc, argv); }
