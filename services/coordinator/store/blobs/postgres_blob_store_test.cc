#include "services/coordinator/store/blobs/postgres_blob_store.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/checking_reader.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::postgres_blob_store_test {
namespace {

/// Work of a database: statements, and bytes of its answers.
struct Work {
  int statements = 0;
  int64_t bytes = 0;  ///< bytes of texts and blobs in the answers
};

class CountedStatement : public SqlStatement {
 public:
  CountedStatement(std::unique_ptr<SqlStatement> statement, Work& work)
      : statement_(std::move(statement)), work_(work) {}

  void Bind(int64_t value) override { statement_->Bind(value); }
  void Bind(std::string_view value) override { statement_->Bind(value); }
  void Bind(Blob value) override { statement_->Bind(value); }
  bool Next() override { return statement_->Next(); }
  const absl::Status& status() const override { return statement_->status(); }
  int64_t Int(int column) const override { return statement_->Int(column); }
  std::string Text(int column) const override {
    std::string text = statement_->Text(column);
    work_.bytes += std::ssize(text);
    return text;
  }

 private:
  const std::unique_ptr<SqlStatement> statement_;
  Work& work_;
};

class CountedConnection : public SqlConnection {
 public:
  CountedConnection(SqlSession session, Work& work) : session_(std::move(session)), work_(work) {}

  const SqlDialect& dialect() const override { return session_->dialect(); }
  absl::Status Execute(const std::string& sql) override {
    ++work_.statements;
    return session_->Execute(sql);
  }
  std::unique_ptr<SqlStatement> Prepare(std::string_view sql) override {
    ++work_.statements;
    return std::make_unique<CountedStatement>(session_->Prepare(sql), work_);
  }

 private:
  const SqlSession session_;
  Work& work_;
};

class CountedDatabase : public SqlDatabase {
 public:
  explicit CountedDatabase(std::unique_ptr<SqlDatabase> database)
      : database_(std::move(database)) {}

  absl::StatusOr<SqlSession> Read() override { return Counted(database_->Read()); }
  absl::StatusOr<SqlSession> Write() override { return Counted(database_->Write()); }

  Work Take() { return std::exchange(work_, {}); }

 private:
  absl::StatusOr<SqlSession> Counted(absl::StatusOr<SqlSession> session) {
    if (!session.ok()) return session;
    auto counted = std::make_unique<CountedConnection>(*std::move(session), work_);
    return SqlSession(counted.release(), [](SqlConnection* used) { delete used; });
  }

  const std::unique_ptr<SqlDatabase> database_;
  Work work_;
};

class PostgresBlobStoreTest : public testing::Test {
 protected:
  static std::string Content(int64_t bytes) {
    std::string content;
    for (int i = 0; std::ssize(content) < bytes; ++i) content += std::to_string(i);
    content.resize(bytes);
    return content;
  }

  const std::shared_ptr<CountedDatabase> database_ =
      std::make_shared<CountedDatabase>(*PostgresDatabase::Open(SharedPostgres().NewDatabase()));
  const std::shared_ptr<BlobStore> store_ = std::make_shared<PostgresBlobStore>(database_);
};

TEST_F(PostgresBlobStoreTest, APieceOfAnUploadTakesOneStatement) {
  constexpr int kPieces = 10;
  const std::string content = Content(kPieces * kBlobPieceBytes);
  const std::string digest = Sha256Hex(content);
  const auto append = [&](int piece) {
    const int64_t at = piece * kBlobPieceBytes;
    return store_->Append(digest, at, content.substr(at, kBlobPieceBytes));
  };
  ASSERT_TRUE(append(0).ok());
  database_->Take();
  for (int piece = 1; piece < kPieces; ++piece) {
    const auto status = append(piece);
    ASSERT_TRUE(status.ok()) << status.status();
    EXPECT_EQ(status->committed_size, (piece + 1) * kBlobPieceBytes);
  }
  EXPECT_EQ(database_->Take().statements, kPieces - 1);
  ASSERT_TRUE(store_->Finish(digest, std::ssize(content)).ok());
  EXPECT_EQ(*store_->Get(digest), content);
}

TEST_F(PostgresBlobStoreTest, ADownloadReadsEachByteOnce) {
  const std::string content = Content(10 * kBlobPieceBytes + 7);
  const std::string digest = *store_->Put(content);
  database_->Take();
  const auto reader = OpenToStream(store_, digest);
  ASSERT_TRUE(reader.ok()) << reader.status();
  std::string read;
  while (std::ssize(read) < (*reader)->size()) {
    const auto piece = (*reader)->Read(std::ssize(read), kBlobPieceBytes);
    ASSERT_TRUE(piece.ok()) << piece.status();
    read += *piece;
  }
  EXPECT_EQ(read, content);
  const Work work = database_->Take();
  EXPECT_LE(work.bytes, std::ssize(content) * 11 / 10);
  EXPECT_LE(work.statements, 11 + 4);
}

TEST_F(PostgresBlobStoreTest, WhatWasCheckedOnceIsOpenedAnywhereForLittle) {
  const std::string content = Content(10 * kBlobPieceBytes);
  const std::string digest = *store_->Put(content);
  ASSERT_TRUE(store_->Open(digest).ok());
  database_->Take();
  const auto reader = store_->Open(digest);
  ASSERT_TRUE(reader.ok()) << reader.status();
  EXPECT_EQ(*(*reader)->Read(5 * kBlobPieceBytes + 3, 10),
            content.substr(5 * kBlobPieceBytes + 3, 10));
  EXPECT_LE(database_->Take().bytes, kBlobPieceBytes);
}

}  // namespace
}  // namespace slicefarm::coordinator::postgres_blob_store_test
