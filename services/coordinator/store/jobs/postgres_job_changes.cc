#include "services/coordinator/store/jobs/postgres_job_changes.h"

#include <libpq-fe.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <utility>

namespace slicefarm::coordinator {
namespace {

constexpr int kRetryMs = 1000;
constexpr int kForever = -1;

}  // namespace

PostgresJobChanges::PostgresJobChanges(std::string conninfo, Listener listener)
    : conninfo_(std::move(conninfo)),
      listener_(std::move(listener)),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      thread_([this] { Run(); }) {}

PostgresJobChanges::~PostgresJobChanges() {
  stopping_ = true;
  eventfd_write(wake_, 1);
  thread_.join();
  close(wake_);
}

void PostgresJobChanges::Publish(const ProgressReport& report) {
  {
    const std::lock_guard lock(mutex_);
    notice_ = ToText(report);
  }
  eventfd_write(wake_, 1);
}

absl::Status PostgresJobChanges::Notify(PostgresConnection& connection) {
  std::string notice;
  {
    const std::lock_guard lock(mutex_);
    notice = std::exchange(notice_, "");
  }
  if (notice.empty()) return absl::OkStatus();
  return SqlQuery(connection, connection.dialect().notify).Bind(notice).Run();
}

void PostgresJobChanges::Run() {
  while (!stopping_) {
    const auto connection = PostgresConnection::Open(conninfo_);
    if (connection.ok() && (*connection)->Execute("LISTEN slicefarm_jobs").ok()) {
      listener_.changed(std::nullopt);
      Listen(**connection);
    }
    if (!stopping_) Wait(-1, kRetryMs);
  }
}

/// Receives and sends notices until the connection breaks.
void PostgresJobChanges::Listen(PostgresConnection& connection) {
  PGconn* const raw = connection.raw();
  while (!stopping_ && PQconsumeInput(raw) == 1) {
    while (PGnotify* const note = PQnotifies(raw)) {
      if (const auto change = JobChangeFromText(note->extra)) listener_.changed(change);
      if (auto report = ProgressReportFromText(note->extra))
        listener_.progressed(*std::move(report));
      PQfreemem(note);
    }
    Wait(PQsocket(raw), kForever);
    if (!Notify(connection).ok()) return;
  }
}

void PostgresJobChanges::Wait(int socket, int timeout_ms) const {
  std::array<pollfd, 2> fds = {pollfd{wake_, POLLIN, 0}, pollfd{socket, POLLIN, 0}};
  poll(fds.data(), fds.size(), timeout_ms);
  eventfd_t woken = 0;
  eventfd_read(wake_, &woken);
}

}  // namespace slicefarm::coordinator
