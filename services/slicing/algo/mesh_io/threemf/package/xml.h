#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/base/error.h"

struct XML_ParserStruct;

namespace slicefarm::slicing::threemf {

/// Name and value of an attribute.
struct XmlAttribute {
  std::string_view name;
  std::string_view value;
};

/// Attributes of an element.
using XmlAttributes = std::span<const XmlAttribute>;

/// Returns the value of the attribute with this name.
std::optional<std::string_view> Find(XmlAttributes attributes, std::string_view name);
/// Returns the value of the attribute with this name, with or without a namespace prefix: `path`
/// finds `p:path`.
std::optional<std::string_view> FindPrefixed(XmlAttributes attributes, std::string_view name);

/// Receiver of the elements of a document. Errors of its functions need no location, because the
/// parser adds it.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  /// Handles the start of an element. `line`: line where the element begins.
  virtual absl::Status Start(std::string_view name, XmlAttributes attributes, int64_t line) = 0;
  /// Handles the end of an element.
  virtual absl::Status End(std::string_view name) = 0;
  /// Handles a piece of text between tags.
  virtual absl::Status Text(std::string_view text);
};

/// Returns a MESH_MALFORMED error about the contents of a document, without a location.
absl::Status Malformed(std::string_view what);

/// Parser that passes an XML document to a handler, piece by piece (expat). It makes no system
/// calls except for memory.
///
/// Errors: any error of the handler. MESH_MALFORMED for a document that is not well-formed, is
/// nested deeper than limits::kMaxXmlDepth, or has a tag longer than limits::kMaxXmlTagBytes. A
/// document type definition is an error too, so there are no entities to expand. All errors have
/// metadata `part` and `line` and end in "(PART, line N)".
class XmlParser {
 public:
  /// `part`: name of the document in its archive. Keeps a reference to the handler.
  XmlParser(std::string part, XmlHandler& handler);
  ~XmlParser();
  XmlParser(const XmlParser&) = delete;
  XmlParser& operator=(const XmlParser&) = delete;

  /// Parses the next piece of text. `last`: the document ends with it.
  absl::Status Feed(std::string_view text, bool last);

  /// Counts lines that the caller has read without the parser, so that later line numbers are
  /// right.
  void SkipLines(int64_t lines) { skipped_lines_ += lines; }

  /// Returns true if the parser is between two tags: no tag, comment or similar is incomplete.
  bool AtBoundary() const;

  /// Returns the number of the line being read, from 1.
  int64_t line() const;
  /// Returns `error` with the location (document and line) that the parser has reached.
  absl::Status Placed(const absl::Status& error) const;

 private:
  struct Callbacks;
  struct Freer {
    void operator()(XML_ParserStruct* parser) const;
  };
  absl::Status SyntaxError() const;
  void Fail(const absl::Status& error);

  std::string part_;
  XmlHandler& handler_;
  std::unique_ptr<XML_ParserStruct, Freer> parser_;
  std::vector<XmlAttribute> attributes_;
  absl::Status failed_;
  int64_t depth_ = 0;
  int64_t fed_ = 0;
  int64_t skipped_lines_ = 0;
};

/// Parses a whole document. Errors: as XmlParser.
absl::Status ParseXml(std::string_view text, std::string part, XmlHandler& handler);

}  // namespace slicefarm::slicing::threemf
