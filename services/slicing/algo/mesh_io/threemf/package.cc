#include "services/slicing/algo/mesh_io/threemf/package.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/model_stream.h"
#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"
#include "services/slicing/algo/mesh_io/threemf/settings/names.h"

namespace slicefarm::slicing::threemf {
namespace {

/// Handler that finds the relationship of a package to its model.
class RelationshipHandler : public XmlHandler {
 public:
  absl::Status Start(std::string_view name, XmlAttributes attributes, int64_t) override {
    constexpr std::string_view kModel =
        "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
    if (name == "Relationship" && Find(attributes, "Type") == kModel && target_.empty())
      target_ = Find(attributes, "Target").value_or("");
    return absl::OkStatus();
  }
  absl::Status End(std::string_view) override { return absl::OkStatus(); }

  const std::string& target() const { return target_; }

 private:
  std::string target_;
};

/// Returns the archive entry of the package's model: the one that its relationships name, or
/// 3D/3dmodel.model if they name none.
absl::StatusOr<const ArchiveEntry*> FindModel(const Archive& archive) {
  const ArchiveEntry* model = archive.Find("3D/3dmodel.model");
  if (const ArchiveEntry* relations = archive.Find("_rels/.rels")) {
    const absl::StatusOr<std::string> text = archive.ReadAll(*relations);
    if (!text.ok()) return text.status();
    RelationshipHandler handler;
    absl::Status status = ParseXml(*text, relations->name, handler);
    if (!status.ok()) return status;
    const ArchiveEntry* said = archive.Find(handler.target());
    if (said != nullptr) model = said;
  }
  if (model != nullptr) return model;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshFormatUnknown,
                   "the archive contains no 3MF model");
}

class PackageReader {
 public:
  PackageReader(const Archive& archive, MeshReading reading, const CancelToken& cancel)
      : archive_(archive), reading_(reading), cancel_(cancel) {}

  absl::StatusOr<Package> Run() && {
    const absl::StatusOr<const ArchiveEntry*> model = FindModel(archive_);
    if (!model.ok()) return model.status();
    entries_ = {*model};
    for (size_t file = 0; file < entries_.size(); ++file) {
      absl::StatusOr<ModelFile> read =
          ReadModelFile(archive_, *entries_[file], reading_, package_.meshes, cancel_);
      if (!read.ok()) return read.status();
      read->part = entries_[file]->name;
      if (absl::Status status = Follow(*read); !status.ok()) return status;
      package_.files.push_back(*std::move(read));
    }
    TakePaint();
    return std::move(package_);
  }

 private:
  /// Replaces every path in the file by the name of an archive entry, and queues that entry to be
  /// read.
  absl::Status Follow(ModelFile& file) {
    for (BuildItem& item : file.items)
      if (absl::Status status = Follow(item, file.part); !status.ok()) return status;
    for (ObjectResource& object : file.objects) {
      for (ObjectUse& use : object.components)
        if (absl::Status status = Follow(use, file.part); !status.ok()) return status;
    }
    return absl::OkStatus();
  }

  absl::Status Follow(ObjectUse& use, const std::string& part) {
    if (use.path.empty()) use.path = part;
    const ArchiveEntry* entry = archive_.Find(use.path);
    if (entry == nullptr)
      return WithLocation({part, use.line}, Malformed(fmt::format("there is no `{}` in the archive",
                                                                  CleanName(use.path))));
    use.path = entry->name;
    if (std::find(entries_.begin(), entries_.end(), entry) == entries_.end())
      entries_.push_back(entry);
    return absl::OkStatus();
  }

  void TakePaint() {
    for (ModelFile& file : package_.files)
      for (ObjectResource& object : file.objects)
        for (PaintedArea* area : object.marks.Areas()) {
          if (area->triangles == 0) continue;
          area->number = static_cast<int32_t>(package_.meshes.size());
          package_.meshes.push_back(std::exchange(area->mesh, {}));
        }
  }

  const Archive& archive_;
  MeshReading reading_;
  const CancelToken& cancel_;
  std::vector<const ArchiveEntry*> entries_;  ///< entries of the model files, in their order
  Package package_;
};

}  // namespace

absl::StatusOr<ObjectKey> Package::Resolve(const ObjectUse& use, size_t file) const {
  size_t in = file;
  if (use.path != files[file].part)
    in = static_cast<size_t>(
        std::find_if(files.begin(), files.end(),
                     [&](const ModelFile& each) { return each.part == use.path; }) -
        files.begin());
  if (in < files.size()) {
    const auto found = files[in].by_id.find(use.object);
    if (found != files[in].by_id.end()) return ObjectKey{in, found->second};
  }
  return WithLocation({files[file].part, use.line},
                      Malformed(fmt::format("there is no object {}", use.object)));
}

absl::StatusOr<Package> ReadPackage(const Archive& archive, MeshReading reading,
                                    const CancelToken& cancel) {
  return PackageReader(archive, reading, cancel).Run();
}

}  // namespace slicefarm::slicing::threemf
