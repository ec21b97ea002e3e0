#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "services/slicing/algo/mesh_io/threemf/mesh_collector.h"
#include "services/slicing/algo/mesh_io/threemf/model_file.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {

/// Handler of the elements of a model file. It supports the core specification, and the paths to
/// other model files of the production extension. It skips all other elements, unless the file
/// requires an extension that the handler does not support.
///
/// Source: 3MF Consortium, Core Specification 1.3, Production Extension 1.1.
class ModelHandler : public XmlHandler {
 public:
  /// `meshes` receives the meshes, one for each object that has one.
  ModelHandler(MeshReading& reading, std::vector<RawMesh>& meshes)
      : reading_(reading), meshes_(meshes) {}

  absl::Status Start(std::string_view name, XmlAttributes attributes, int64_t line) override;
  absl::Status End(std::string_view name) override;
  absl::Status Text(std::string_view text) override;

  /// Returns true directly after the start tag `vertices` or `triangles`, which millions of
  /// elements with the name Repeated() may follow. The caller may pass these elements to Element
  /// instead of to the XML parser.
  bool RunBegins() const { return run_begins_; }
  /// Returns the name of the elements that may be passed to Element, with its prefix: `vertex` or
  /// `triangle`.
  std::string_view Repeated() const;
  /// Handles one element with the name Repeated().
  absl::Status Element(XmlAttributes attributes);

  /// Returns the model file; call it after the last element. Errors: MESH_MALFORMED if there was no
  /// `model`.
  absl::StatusOr<ModelFile> Take() &&;

 private:
  /// Element in which the parser is.
  enum class At : uint8_t {
    kDocument,
    kModel,
    kMetadata,
    kResources,
    kObject,
    kMesh,
    kVertices,
    kTriangles,
    kComponents,
    kBuild,
    kLeaf,
    kUnknown,  ///< unknown element; everything in it is skipped
  };

  absl::StatusOr<At> Enter(std::string_view name, XmlAttributes attributes);
  absl::StatusOr<At> EnterInModel(std::string_view name, XmlAttributes attributes);
  absl::StatusOr<At> EnterInObject(std::string_view name);
  absl::Status Model(XmlAttributes attributes);
  absl::Status Object(XmlAttributes attributes);
  absl::Status Component(XmlAttributes attributes);
  absl::Status Item(XmlAttributes attributes);
  absl::Status CountResource();
  absl::Status FinishMesh();

  MeshReading& reading_;
  std::vector<RawMesh>& meshes_;
  std::string prefix_;  ///< prefix of the core elements, with the colon
  std::string vertex_, triangle_;
  std::vector<At> path_ = {At::kDocument};
  ModelFile file_;
  bool has_model_ = false;
  std::optional<MeshCollector> mesh_;
  std::string metadata_name_;
  int64_t line_ = 0;
  bool run_begins_ = false;
};

}  // namespace slicefarm::slicing::threemf
