#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Database that records each statement that runs, including BEGIN and COMMIT. The preparation of a
/// statement is not recorded.
class CountingDatabase : public SqlDatabase {
 public:
  explicit CountingDatabase(std::shared_ptr<SqlDatabase> database)
      : database_(std::move(database)) {}

  absl::StatusOr<SqlSession> Read() override { return Counting(database_->Read()); }
  absl::StatusOr<SqlSession> Write() override { return Counting(database_->Write()); }

  /// Returns the statements since the last call.
  std::vector<std::string> Statements() {
    const std::lock_guard lock(mutex_);
    return std::exchange(statements_, {});
  }

 private:
  class Connection : public SqlConnection {
   public:
    Connection(SqlSession session, CountingDatabase& counting)
        : session_(std::move(session)), counting_(counting) {}
    const SqlDialect& dialect() const override { return session_->dialect(); }
    absl::Status Execute(const std::string& sql) override {
      counting_.Note(sql);
      return session_->Execute(sql);
    }
    std::unique_ptr<SqlStatement> Prepare(std::string_view sql) override {
      counting_.Note(sql);  // each statement runs separately
      return session_->Prepare(sql);
    }

   private:
    const SqlSession session_;
    CountingDatabase& counting_;
  };

  absl::StatusOr<SqlSession> Counting(absl::StatusOr<SqlSession> session) {
    if (!session.ok()) return session;
    return SqlSession(new Connection(*std::move(session), *this),
                      [](SqlConnection* connection) { delete connection; });
  }
  void Note(std::string_view sql) {
    const std::lock_guard lock(mutex_);
    statements_.emplace_back(sql);
  }

  const std::shared_ptr<SqlDatabase> database_;
  std::mutex mutex_;
  std::vector<std::string> statements_;
};

}  // namespace slicefarm::coordinator
