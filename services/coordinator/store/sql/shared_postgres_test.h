#pragma once

#include "tests/integration/postgres_server.h"

namespace slicefarm::coordinator {

/// One server for all tests of a process; each takes a database of its own.
inline PostgresServer& SharedPostgres() {
  static PostgresServer server;
  return server;
}

}  // namespace slicefarm::coordinator
