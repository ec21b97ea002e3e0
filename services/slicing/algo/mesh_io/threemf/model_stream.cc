#include "services/slicing/algo/mesh_io/threemf/model_stream.h"

#include <algorithm>
#include <string>

#include "services/slicing/algo/mesh_io/threemf/model_handler.h"
#include "services/slicing/algo/mesh_io/threemf/package/element_scan.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {
namespace {

constexpr size_t kPieceBytes = 256 << 10;

/// Length of the longest end of a tag ("vertices>" or "triangles>") after which a run of elements
/// with one name may follow.
constexpr size_t kLongestBegin = 10;

/// Returns the end of the first tag after which a run of elements may follow; npos if there is
/// none. If a tag is missed or found wrongly, this only costs time.
size_t EndOfRunBegin(std::string_view text) {
  for (size_t at = text.find('>'); at != std::string_view::npos; at = text.find('>', at + 1)) {
    const std::string_view before = text.substr(0, at);
    if (before.ends_with("vertices") || before.ends_with("triangles")) return at + 1;
  }
  return std::string_view::npos;
}

/// Reader of one model file. Its text arrives in pieces.
class ModelStream {
 public:
  ModelStream(const std::string& part, MeshReading& reading, std::vector<RawMesh>& meshes)
      : handler_(reading, meshes), parser_(part, handler_) {}

  /// Reads the beginning of `text`, and returns the number of characters read. The caller passes
  /// the unread characters again, with more text behind them unless `last` is true.
  absl::StatusOr<size_t> Feed(std::string_view text, bool last) {
    const size_t size = text.size();
    while (!text.empty()) {
      const bool was_in_run = in_run_;
      const absl::StatusOr<size_t> used = was_in_run ? Run(text, last) : Markup(text, last);
      if (!used.ok()) return used.status();
      text.remove_prefix(*used);
      const bool waits = was_in_run ? in_run_ : *used == 0;
      if (waits) break;
    }
    if (last)
      if (absl::Status status = parser_.Feed(text, true); !status.ok()) return status;
    return size - text.size();
  }

  absl::StatusOr<ModelFile> Take() && {
    absl::StatusOr<ModelFile> file = std::move(handler_).Take();
    if (!file.ok()) return parser_.Placed(file.status());
    return file;
  }

 private:
  absl::StatusOr<size_t> Markup(std::string_view text, bool last) {
    size_t size = EndOfRunBegin(text);
    const bool may_begin = size != std::string_view::npos;
    if (!may_begin) size = last ? text.size() : text.size() - std::min(text.size(), kLongestBegin);
    if (absl::Status status = parser_.Feed(text.substr(0, size), false); !status.ok())
      return status;
    in_run_ = may_begin && handler_.RunBegins() && parser_.AtBoundary();
    return size;
  }

  absl::StatusOr<size_t> Run(std::string_view text, bool last) {
    ElementScan scan(text, handler_.Repeated());
    ScanEnd next = scan.Next();
    for (; next == ScanEnd::kElement; next = scan.Next()) {
      const absl::Status status = handler_.Element(scan.attributes());
      if (status.ok()) continue;
      parser_.SkipLines(scan.lines());
      return parser_.Placed(status);
    }
    parser_.SkipLines(scan.lines());
    // The parser handles everything that the scanner does not recognize.
    in_run_ = next == ScanEnd::kMore && !last && scan.rest().size() < kPieceBytes;
    return text.size() - scan.rest().size();
  }

  ModelHandler handler_;
  XmlParser parser_;
  bool in_run_ = false;  ///< true inside a run of elements that the scanner reads
};

}  // namespace

absl::StatusOr<ModelFile> ReadModelFile(const Archive& archive, const ArchiveEntry& entry,
                                        MeshReading& reading, std::vector<RawMesh>& meshes,
                                        const CancelToken& cancel) {
  absl::StatusOr<EntryStream> bytes = archive.Stream(entry);
  if (!bytes.ok()) return bytes.status();
  ModelStream stream(entry.name, reading, meshes);
  std::string text(2 * kPieceBytes, '\0');
  size_t filled = 0;
  for (bool last = false; !last;) {
    if (cancel.Cancelled()) return cancel.Check();
    const absl::StatusOr<size_t> got =
        bytes->Read(std::span(text).subspan(filled, std::min(kPieceBytes, text.size() - filled)));
    if (!got.ok()) return got.status();
    last = *got == 0;
    filled += *got;
    const absl::StatusOr<size_t> used = stream.Feed({text.data(), filled}, last);
    if (!used.ok()) return used.status();
    std::copy(text.begin() + static_cast<ptrdiff_t>(*used),
              text.begin() + static_cast<ptrdiff_t>(filled), text.begin());
    filled -= *used;
  }
  return std::move(stream).Take();
}

}  // namespace slicefarm::slicing::threemf
