#include "services/slicing/sandbox/project_codec.h"

#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace slicefarm::slicing {
namespace {

/// Writer of a project. Writer and reader handle the same members in the same order, because both
/// use the list of members in `Each` below.
class Writer {
 public:
  template <typename T>
  void Number(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  void Text(std::string& text) {
    uint64_t size = text.size();
    Number(size);
    bytes_ += text;
  }

  template <typename T, typename EachItem>
  void List(std::vector<T>& items, const EachItem& each) {
    uint64_t size = items.size();
    Number(size);
    for (T& item : items) each(item);
  }

  std::string Take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  void Number(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (bytes_.size() < sizeof value) return Fail();
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
  }

  /// Reads a bool; bytes other than 0 and 1 are errors.
  void Number(bool& value) {
    uint8_t byte = 0;
    Number(byte);
    value = byte == 1;
    if (byte > 1) Fail();
  }

  void Text(std::string& text) {
    uint64_t size = 0;
    Number(size);
    if (size > bytes_.size()) return Fail();
    text = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
  }

  template <typename T, typename EachItem>
  void List(std::vector<T>& items, const EachItem& each) {
    uint64_t size = 0;
    Number(size);
    for (uint64_t i = 0; i < size && !failed_; ++i) each(items.emplace_back());
  }

  bool WentWell() const { return !failed_ && bytes_.empty(); }

 private:
  /// Marks the input as faulty. All further reads return zeros.
  void Fail() {
    failed_ = true;
    bytes_ = {};
  }

  std::string_view bytes_;
  bool failed_ = false;
};

template <typename Codec>
struct Members {
  Codec& codec;

  void Each(Setting& setting) const {
    codec.Text(setting.key);
    codec.Text(setting.value);
    codec.Number(setting.source);
  }

  void Each(Transform& transform) const {
    for (double& entry : transform.reshaped()) codec.Number(entry);
  }

  void Each(MeshRef& mesh) const {
    codec.Number(mesh.file);
    codec.Number(mesh.mesh);
    codec.Number(mesh.first_triangle);
    codec.Number(mesh.triangle_count);
  }

  void Each(Part& part) const {
    codec.Text(part.name);
    Each(part.mesh);
    codec.Number(part.role);
    Each(part.to_object);
    Each(part.settings);
  }

  void Each(HeightRange& range) const {
    codec.Number(range.from_mm);
    codec.Number(range.to_mm);
    Each(range.settings);
  }

  void Each(Instance& instance) const {
    Each(instance.to_plate);
    codec.Number(instance.printable);
    codec.Number(instance.placed);
  }

  void Each(SceneObject& object) const {
    codec.Text(object.name);
    Each(object.parts);
    Each(object.ranges);
    Each(object.settings);
    Each(object.instances);
  }

  void Each(ProjectPlate::Member& member) const {
    codec.Number(member.object);
    codec.Number(member.instance);
  }

  void Each(ProjectPlate& plate) const {
    codec.Text(plate.name);
    Each(plate.members);
    Each(plate.settings);
    codec.Number(plate.locked);
  }

  void Each(std::string& text) const { codec.Text(text); }
  void Each(int32_t& index) const { codec.Number(index); }

  void Each(Project& project) const {
    codec.Text(project.application);
    codec.Number(project.dialect);
    Each(project.settings);
    Each(project.objects);
    Each(project.plates);
    Each(project.without_effect);
    Each(project.painted);
  }

  template <typename T>
  void Each(std::vector<T>& items) const {
    codec.List(items, [this](T& item) { Each(item); });
  }
};

}  // namespace

std::string EncodeProject(const Project& project) {
  Writer writer;
  Project copy = project;  // the list of members requires a mutable object
  Members<Writer>{writer}.Each(copy);
  return std::move(writer).Take();
}

absl::StatusOr<Project> DecodeProject(std::string_view bytes) {
  Reader reader(bytes);
  Project project;
  Members<Reader>{reader}.Each(project);
  if (!reader.WentWell()) return absl::InvalidArgumentError("a project that is none");
  return project;
}

}  // namespace slicefarm::slicing
