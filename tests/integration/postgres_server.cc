#include "tests/integration/postgres_server.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "services/coordinator/store/sql/postgres_connection.h"

namespace slicefarm {

PostgresServer::PostgresServer(Disk disk) {
  std::string pattern = std::filesystem::temp_directory_path() / "slicefarm-pg-XXXXXX";
  directory_ = mkdtemp(pattern.data());
  if (disk == Disk::kTrusted) settings_ = "fsync=off";
  Start();
}

PostgresServer::~PostgresServer() {
  Run("stop");
  std::filesystem::remove_all(directory_);
}

std::string PostgresServer::NewDatabase() {
  // A separate schema isolates as well as a database and is created faster.
  const std::string name = "test" + std::to_string(databases_++);
  const std::string server = "host=" + directory_ + " user=slicefarm dbname=slicefarm";
  const auto connection = coordinator::PostgresConnection::Open(server);
  if (!connection.ok() || !(*connection)->Execute("CREATE SCHEMA " + name).ok()) std::abort();
  return server + " options='-c search_path=" + name + "'";
}

void PostgresServer::Kill() { Run("kill"); }

void PostgresServer::Start() {
  if (Run("start", settings_).empty()) std::abort();
}

void PostgresServer::Pause() { Run("pause"); }

void PostgresServer::Resume() { Run("resume"); }

std::string PostgresServer::Run(const std::string& command, const std::string& settings) {
  const std::string line = std::string(SLICEFARM_SOURCE) + "/deploy/postgres/server.sh " + command +
                           " '" + directory_ + "' " + settings;
  FILE* const pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) std::abort();
  std::string output;
  std::array<char, 256> buffer = {};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) output += buffer.data();
  return pclose(pipe) == 0 ? output : "";
}

}  // namespace slicefarm
