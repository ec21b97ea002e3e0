// Tests of DirectoryBlobStore in which each of its disk calls fails, and in which the power fails
// after each call. Environment variables:
//
//   SLICEFARM_FAULT_ERRORS   number of errors that are tried at each call site (40);
//   SLICEFARM_FAULT_SEEDS    number of random choices of the state after a power cut (4).

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/from_environment_test.h"
#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/directory_blob_store.h"
#include "services/coordinator/store/faults/fault_trials_test.h"

namespace slicefarm::coordinator::directory_blob_store_faults_test {
namespace {

constexpr size_t kPieceBytes = 1500;

/// Returns some bytes that fill a few sectors.
std::string Content(const std::string& name) {
  std::string bytes;
  for (int i = 0; bytes.size() < 4000; ++i) absl::StrAppend(&bytes, name, " ", i, "\n");
  return bytes;
}

/// Returns bytes with a digest that begins as the digest of `other`, so that both are in the same
/// folder.
std::string Neighbour(const std::string& other) {
  const std::string folder = Sha256Hex(other).substr(0, 2);
  for (int i = 0;; ++i) {
    std::string bytes = Content(absl::StrCat("neighbour ", i));
    if (Sha256Hex(bytes).starts_with(folder)) return bytes;
  }
}

/// Uploads bytes as a client does: continues at the end of the stored part, and begins again if the
/// upload was damaged.
absl::Status Upload(BlobStore& store, const std::string& bytes) {
  const std::string digest = Sha256Hex(bytes);
  const auto size = static_cast<int64_t>(bytes.size());
  absl::Status status;
  for (int i = 0; i < 2; ++i) {
    auto here = store.Status(digest);
    while (here.ok() && !here->complete && here->committed_size < size) {
      const int64_t at = here->committed_size;
      here = store.Append(digest, at, std::string_view(bytes).substr(at, kPieceBytes));
    }
    if (here.ok() && !here->complete) here = store.Finish(digest, size);
    status = here.status();
    if (DetailOf(status).reason != Reason::kBlobDigestMismatch) break;
  }
  return status;
}

class BlobLife : public StoreLife {
 public:
  BlobLife(DiskCalls& disk, std::string directory)
      : disk_(disk), directory_(std::move(directory)) {}

  absl::Status Open() override {
    auto store = DirectoryBlobStore::OpenAt(directory_ + "/deep");
    if (store.ok()) store_ = *std::move(store);
    return store.status();
  }
  void Close() override { store_.reset(); }

  std::vector<LifeStep> Steps() override {
    return {
        {"upload a", [&] { return Keep(a_, Upload(*store_, a_)); }},
        {"put b", [&] { return Put(b_); }},
        {"upload the first half of c", [&] { return Begin(c_); }},
        {"keep a", [&] { return KeepInUse(a_); }},
        {"open again", [&] { return Close(), Open(); }},
        {"keep b", [&] { return KeepInUse(b_); }},
        {"upload the rest of c", [&] { return Keep(c_, Upload(*store_, c_)); }},
        {"put b once more", [&] { return Put(b_); }},
        {"delete b", [&] { return Delete(b_); }},
        {"put b anew", [&] { return Put(b_); }},
        {"read a damaged blob", [&] { return ReadDamaged(a_); }},
        {"upload a again", [&] { return Keep(a_, Upload(*store_, a_)); }},
        {"mend b", [&] { return Damage(b_), Put(b_); }},
        {"upload other bytes as d", [&] { return UploadOtherBytes(d_); }},
        {"upload d", [&] { return Keep(d_, Upload(*store_, d_)); }},
        {"begin e", [&] { return Begin(e_); }},
        {"put e", [&] { return Put(e_); }},
        {"begin f", [&] { return Begin(f_); }},
        {"drop f", [&] { return Delete(f_); }},
        {"put nothing", [&] { return Put(""); }},
        {"begin f again", [&] { return Begin(f_); }},
    };
  }

  /// Returns true if the error fits the fault. A short write causes an error only if the disk is
  /// then full.
  bool Reports(const absl::Status& status, Fault fault) const override {
    const bool io = fault == Fault::kEio || fault == Fault::kEintr;
    return DetailOf(status).reason == (io ? Reason::kStoreFailed : Reason::kDiskFull);
  }

  std::vector<std::string> Check(const std::string& directory, size_t changes) const override {
    std::vector<std::string> wrong;
    auto opened = DirectoryBlobStore::OpenAt(directory + "/deep");
    if (!opened.ok()) return {opened.status().ToString()};
    std::unique_ptr<DirectoryBlobStore> store = *std::move(opened);
    for (const std::string& bytes : All()) {
      const std::string what = CheckBlob(*store, bytes, changes);
      if (!what.empty()) wrong.push_back(NameOf(bytes) + " " + what);
    }
    for (const std::string& bytes : All()) {
      if (const auto done = Upload(*store, bytes); !done.ok()) {
        wrong.push_back(NameOf(bytes) + " cannot be uploaded: " + done.ToString());
      } else if (const auto got = store->Get(Sha256Hex(bytes)); !got.ok() || *got != bytes) {
        wrong.push_back(NameOf(bytes) + " is not what was uploaded");
      }
    }
    store.reset();
    if (!DirectoryBlobStore::OpenAt(directory + "/deep").ok()) wrong.push_back("does not open");
    for (const char* part : {"/deep/tmp", "/deep/uploads"}) {
      for (const auto& left : std::filesystem::directory_iterator(directory + part))
        wrong.push_back("for ever there: " + left.path().string());
    }
    return wrong;
  }

 private:
  /// Promise that a blob exists, or that it may be missing, from this change of the disk on.
  struct Promise {
    size_t changes = 0;
    bool kept = false;
  };

  std::vector<std::string> All() const { return {a_, b_, c_, d_, e_, f_, ""}; }
  static std::string NameOf(const std::string& bytes) { return bytes.substr(0, bytes.find('\n')); }

  void Note(const std::string& bytes, bool kept) {
    promises_[Sha256Hex(bytes)].push_back({disk_.changes().size(), kept});
  }
  absl::Status Keep(const std::string& bytes, const absl::Status& status) {
    if (status.ok()) Note(bytes, true);
    return status;
  }
  absl::Status Put(const std::string& bytes) { return Keep(bytes, store_->Put(bytes).status()); }
  absl::Status Begin(const std::string& bytes) {
    return store_->Append(Sha256Hex(bytes), 0, bytes.substr(0, kPieceBytes)).status();
  }
  absl::Status KeepInUse(const std::string& bytes) {
    const auto status = store_->Keep(Sha256Hex(bytes));
    if (!status.ok()) return status.status();
    return Keep(bytes, status->complete ? absl::OkStatus() : absl::DataLossError("not there"));
  }
  absl::Status Delete(const std::string& bytes) {
    Note(bytes, false);
    return store_->Delete(Sha256Hex(bytes), 0).status();
  }
  void Damage(const std::string& bytes) {
    const std::string digest = Sha256Hex(bytes);
    const std::string path = directory_ + "/deep/blobs/" + digest.substr(0, 2) + "/" + digest;
    if (damaged_.contains(digest)) return;
    Note(bytes, false);
    disk_.Damage(path, 600, "!");
    damaged_[digest] = disk_.changes().size();
  }
  absl::Status ReadDamaged(const std::string& bytes) {
    Damage(bytes);
    const absl::Status read = store_->Get(Sha256Hex(bytes)).status();
    // If the blob is missing, it was put aside before.
    return absl::IsDataLoss(read) || absl::IsNotFound(read) ? absl::OkStatus() : read;
  }
  absl::Status UploadOtherBytes(const std::string& bytes) {
    std::string other = bytes;
    other[700] = '!';
    const std::string digest = Sha256Hex(bytes);
    if (const auto sent = store_->Append(digest, 0, other); !sent.ok()) return sent.status();
    const absl::Status done = store_->Finish(digest, std::ssize(bytes)).status();
    return DetailOf(done).reason == Reason::kBlobDigestMismatch ? absl::OkStatus() : done;
  }

  bool Promised(const std::string& digest, size_t changes) const {
    bool kept = false;
    const auto found = promises_.find(digest);
    if (found == promises_.end()) return false;
    for (const Promise& promise : found->second) {
      if (promise.changes <= changes) kept = promise.kept;
    }
    return kept;
  }

  /// Returns an empty text if nothing is wrong with the blob.
  std::string CheckBlob(BlobStore& store, const std::string& bytes, size_t changes) const {
    const std::string digest = Sha256Hex(bytes);
    const bool promised = Promised(digest, changes);
    const auto damaged = damaged_.find(digest);
    const bool may_be_damaged =
        !promised && damaged != damaged_.end() && damaged->second <= changes;
    const auto status = store.Status(digest);
    if (!status.ok()) return status.status().ToString();
    const auto got = store.Get(digest);
    if (got.ok() && *got != bytes) return "has other bytes";
    if (got.ok() && !status->complete) return "is read and not complete";
    if (got.ok()) return "";
    if (promised) return "was promised: " + got.status().ToString();
    if (status->complete && !may_be_damaged) return "is complete: " + got.status().ToString();
    return "";
  }

  DiskCalls& disk_;
  const std::string directory_;
  std::unique_ptr<DirectoryBlobStore> store_;
  const std::string a_ = Content("a"), b_ = Content("b"), c_ = Neighbour(a_), d_ = Content("d"),
                    e_ = Content("e"), f_ = Content("f");
  std::map<std::string, std::vector<Promise>> promises_;
  std::map<std::string, size_t> damaged_;  ///< change of the disk since which a blob is damaged
};

TrialOptions Options() {
  return {.life = [](DiskCalls& disk, const std::string& directory) {
    return std::make_unique<BlobLife>(disk, directory);
  }};
}

TEST(DirectoryBlobStoreFaults, ErrorsAreToldAndSeenTo) {
  TrialOptions options = Options();
  options.errors_a_site = FromEnvironment("SLICEFARM_FAULT_ERRORS", 40);
  ExpectErrorsAreSeenTo(options);
}

TEST(DirectoryBlobStoreFaults, APowerCutLosesNothingThatWasPromised) {
  ExpectPowerCutsAreSurvived(Options(), FromEnvironment("SLICEFARM_FAULT_SEEDS", 4));
}

TEST(DirectoryBlobStoreFaults, AnUnsyncedFileIsNoticed) { ExpectNoticed(Lie::kFiles, Options()); }

TEST(DirectoryBlobStoreFaults, AnUnsyncedDirectoryIsNoticed) {
  ExpectNoticed(Lie::kDirectories, Options());
}

}  // namespace
}  // namespace slicefarm::coordinator::directory_blob_store_faults_test
