#include "services/slicing/algo/mesh_io/threemf/model_handler.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/text_lines.h"
#include "services/slicing/algo/mesh_io/threemf/settings/names.h"
#include "services/slicing/algo/mesh_io/threemf/transform_text.h"

namespace slicefarm::slicing::threemf {
namespace {

struct Unit {
  std::string_view name;
  double mm;
};

constexpr std::array<Unit, 6> kUnits = {{{"micron", 0.001},
                                         {"millimeter", 1},
                                         {"centimeter", 10},
                                         {"inch", 25.4},
                                         {"foot", 304.8},
                                         {"meter", 1000}}};

/// Extensions that can be skipped, because they do not change the geometry: production, materials
/// and extensions of the slicers.
constexpr std::array<std::string_view, 5> kHarmless = {
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.slic3r.org/3mf/2017/06",
    "http://schemas.bambulab.com/package/2021",
};

absl::StatusOr<ResourceId> IdOf(XmlAttributes attributes, std::string_view name) {
  const std::optional<std::string_view> text = Find(attributes, name);
  if (!text) return Malformed(fmt::format("`{}` is missing", name));
  ResourceId id = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), id);
  const bool whole = error == std::errc() && end == text->data() + text->size();
  if (!whole || id == 0 || id > INT32_MAX)
    return Malformed(fmt::format("`{}` is not a number from 1 to {}", name, INT32_MAX));
  return id;
}

absl::StatusOr<ObjectUse> UseOf(XmlAttributes attributes, double unit_mm, int64_t line) {
  ObjectUse use;
  use.line = line;
  const absl::StatusOr<ResourceId> id = IdOf(attributes, "objectid");
  if (!id.ok()) return id.status();
  use.object = *id;
  use.path = FindPrefixed(attributes, "path").value_or("");
  const std::optional<std::string_view> text = Find(attributes, "transform");
  if (!text || Trim(*text).empty()) return use;
  const absl::StatusOr<Transform> transform = ParseTransform(*text, unit_mm);
  if (!transform.ok()) return transform.status();
  use.transform = *transform;
  return use;
}

absl::Status CheckExtensions(XmlAttributes attributes) {
  const std::string_view required = Find(attributes, "requiredextensions").value_or("");
  Words words(required);
  for (std::string_view prefix = words.Next(); !prefix.empty(); prefix = words.Next()) {
    const std::string declared = "xmlns:" + std::string(prefix);
    const std::string_view uri = Find(attributes, declared).value_or("");
    if (std::find(kHarmless.begin(), kHarmless.end(), uri) == kHarmless.end())
      return Malformed(fmt::format("the file needs a 3MF extension that is not supported: {}",
                                   CleanName(uri.empty() ? prefix : uri)));
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status ModelHandler::Start(std::string_view name, XmlAttributes attributes, int64_t line) {
  line_ = line;
  if (path_.back() == At::kUnknown) {
    path_.push_back(At::kUnknown);
    return absl::OkStatus();
  }
  if (path_.back() == At::kDocument) prefix_ = name.substr(0, name.find(':') + 1);
  const bool ours = name.starts_with(prefix_);
  absl::StatusOr<At> at = At::kUnknown;
  if (ours) at = Enter(name.substr(prefix_.size()), attributes);
  if (!at.ok()) return at.status();
  path_.push_back(*at);
  run_begins_ = !Repeated().empty();
  return absl::OkStatus();
}

absl::StatusOr<ModelHandler::At> ModelHandler::Enter(std::string_view name,
                                                     XmlAttributes attributes) {
  const auto leaf = [](const absl::Status& status) -> absl::StatusOr<At> {
    if (!status.ok()) return status;
    return At::kLeaf;
  };
  switch (path_.back()) {
    case At::kDocument:
    case At::kModel:
    case At::kResources:
      return EnterInModel(name, attributes);
    case At::kObject:
    case At::kMesh:
      return EnterInObject(name);
    case At::kVertices:
    case At::kTriangles:
      return prefix_ + std::string(name) == Repeated() ? leaf(Element(attributes)) : At::kUnknown;
    case At::kComponents:
      return name == "component" ? leaf(Component(attributes)) : At::kUnknown;
    case At::kBuild:
      return name == "item" ? leaf(Item(attributes)) : At::kUnknown;
    case At::kMetadata:
    case At::kLeaf:
    case At::kUnknown:
      break;
  }
  return At::kUnknown;
}

absl::StatusOr<ModelHandler::At> ModelHandler::EnterInModel(std::string_view name,
                                                            XmlAttributes attributes) {
  const auto go = [](const absl::Status& status, At at) -> absl::StatusOr<At> {
    if (!status.ok()) return status;
    return at;
  };
  const At here = path_.back();
  if (here == At::kDocument)
    return name == "model" ? go(Model(attributes), At::kModel)
                           : go(Malformed("the file is not a 3MF model"), At::kUnknown);
  if (here == At::kResources)
    return name == "object" ? go(Object(attributes), At::kObject) : At::kUnknown;
  if (name == "resources") return At::kResources;
  if (name == "build") return At::kBuild;
  if (name != "metadata") return At::kUnknown;
  metadata_name_ = Find(attributes, "name").value_or("");
  return At::kMetadata;
}

absl::StatusOr<ModelHandler::At> ModelHandler::EnterInObject(std::string_view name) {
  if (path_.back() == At::kMesh) {
    if (name == "vertices") return At::kVertices;
    return name == "triangles" ? At::kTriangles : At::kUnknown;
  }
  ObjectResource& object = file_.objects.back();
  if (name == "components") {
    if (object.mesh >= 0) return Malformed("an object has both a mesh and components");
    return At::kComponents;
  }
  if (name != "mesh") return At::kUnknown;
  if (object.mesh >= 0 || !object.components.empty())
    return Malformed("an object has more than one mesh, or components too");
  object.mesh = static_cast<int32_t>(meshes_.size());
  mesh_.emplace(file_.unit_mm, reading_);
  return At::kMesh;
}

absl::Status ModelHandler::Model(XmlAttributes attributes) {
  has_model_ = true;
  vertex_ = prefix_ + "vertex";
  triangle_ = prefix_ + "triangle";
  const std::string_view unit = Find(attributes, "unit").value_or("millimeter");
  const auto* const known = std::find_if(kUnits.begin(), kUnits.end(),
                                         [unit](const Unit& each) { return each.name == unit; });
  if (known == kUnits.end()) return Malformed("the unit is not one of 3MF's");
  file_.unit_mm = known->mm;
  return CheckExtensions(attributes);
}

absl::Status ModelHandler::Object(XmlAttributes attributes) {
  const absl::StatusOr<ResourceId> id = IdOf(attributes, "id");
  if (!id.ok()) return id.status();
  if (!file_.by_id.emplace(*id, file_.objects.size()).second)
    return Malformed(fmt::format("two objects have the id {}", *id));
  if (absl::Status status = CountResource(); !status.ok()) return status;
  ObjectResource object;
  object.id = *id;
  object.name = CleanName(Find(attributes, "name").value_or(""));
  object.type = CleanName(Find(attributes, "type").value_or("model"));
  object.coloured = Find(attributes, "pid").has_value();
  object.line = line_;
  file_.objects.push_back(std::move(object));
  return absl::OkStatus();
}

absl::Status ModelHandler::Component(XmlAttributes attributes) {
  absl::StatusOr<ObjectUse> use = UseOf(attributes, file_.unit_mm, line_);
  if (!use.ok()) return use.status();
  if (absl::Status status = CountResource(); !status.ok()) return status;
  file_.objects.back().components.push_back(*std::move(use));
  return absl::OkStatus();
}

absl::Status ModelHandler::Item(XmlAttributes attributes) {
  absl::StatusOr<ObjectUse> use = UseOf(attributes, file_.unit_mm, line_);
  if (!use.ok()) return use.status();
  const auto count = static_cast<int64_t>(file_.items.size()) + 1;
  if (count > limits::kMaxObjects)
    return LimitError(Reason::kMeshTooLarge, "objects, copies included", limits::kMaxObjects,
                      count);
  // The slicers write this attribute without a prefix, although the core specification does not
  // have it.
  const std::string_view printable = Find(attributes, "printable").value_or("1");
  file_.items.push_back({*std::move(use), printable != "0" && printable != "false"});
  return absl::OkStatus();
}

std::string_view ModelHandler::Repeated() const {
  if (path_.back() == At::kVertices) return vertex_;
  return path_.back() == At::kTriangles ? std::string_view(triangle_) : std::string_view();
}

absl::Status ModelHandler::Element(XmlAttributes attributes) {
  return path_.back() == At::kVertices ? mesh_->Vertex(attributes) : mesh_->Triangle(attributes);
}

absl::Status ModelHandler::End(std::string_view) {
  run_begins_ = false;
  const bool mesh_ends = path_.back() == At::kMesh;
  path_.pop_back();
  return mesh_ends ? FinishMesh() : absl::OkStatus();
}

absl::Status ModelHandler::CountResource() {
  if (++reading_.resources > limits::kMaxFileResources)
    return LimitError(Reason::kMeshTooLarge, "objects, components and painted areas of the file",
                      limits::kMaxFileResources, reading_.resources);
  return absl::OkStatus();
}

absl::Status ModelHandler::FinishMesh() {
  ObjectResource& object = file_.objects.back();
  object.triangles = mesh_->triangles();
  object.paint = mesh_->paint();
  object.coloured |= mesh_->coloured();
  object.marks = mesh_->TakeMarks();
  meshes_.push_back(std::move(*mesh_).Take());
  mesh_.reset();
  for (const PaintedArea* area : object.marks.Areas())
    if (area->triangles > 0)
      if (absl::Status status = CountResource(); !status.ok()) return status;
  return absl::OkStatus();
}

absl::Status ModelHandler::Text(std::string_view text) {
  run_begins_ = false;
  if (path_.back() != At::kMetadata || metadata_name_ != "Application") return absl::OkStatus();
  if (file_.application.size() < static_cast<size_t>(limits::kMaxNameBytes))
    file_.application += text;
  return absl::OkStatus();
}

absl::StatusOr<ModelFile> ModelHandler::Take() && {
  if (!has_model_) return Malformed("the file is not a 3MF model");
  file_.application = CleanName(file_.application);
  return std::move(file_);
}

}  // namespace slicefarm::slicing::threemf
