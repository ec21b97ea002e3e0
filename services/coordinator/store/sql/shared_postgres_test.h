#pragma once

#include "tests/integration/postgres_server.h"

namespace slicefarm::coordinator {

/// Returns the only server for all tests of a process. Each test uses a database of its own.
inline PostgresServer& SharedPostgres() {
  static PostgresServer server;
  return server;
}

}  // namespace slicefarm::coordinator
