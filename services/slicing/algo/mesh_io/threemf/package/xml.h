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

struct XmlAttribute {
  std::string_view name;
  std::string_view value;
};

using XmlAttributes = std::span<const XmlAttribute>;

/// The value of the attribute of this name.
std::optional<std::string_view> Find(XmlAttributes attributes, std::string_view name);
/// The same, whatever namespace prefix the file gives the name: `path` finds `p:path`.
std::optional<std::string_view> FindPrefixed(XmlAttributes attributes, std::string_view name);

/// What is told of a document as it is read. Errors need no place: the parser adds it.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  /// `line`: where the element begins.
  virtual absl::Status Start(std::string_view name, XmlAttributes attributes, int64_t line) = 0;
  virtual absl::Status End(std::string_view name) = 0;
  virtual absl::Status Text(std::string_view text);
};

/// A bare error of what a document says: MESH_MALFORMED, without a place.
absl::Status Malformed(std::string_view what);

/// An XML document, piece by piece (expat), to a handler. Makes no system calls but for memory.
///
/// Errors: those of the handler, and MESH_MALFORMED for what is not well-formed, for any document
/// type definition (there are no entities to expand then), for elements nested deeper than
/// limits::kMaxXmlDepth and tags longer than limits::kMaxXmlTagBytes. All have metadata `part` and
/// `line` and end in "(PART, line N)".
class XmlParser {
 public:
  /// `part`: the name of the document in its archive. Keeps the handler.
  XmlParser(std::string part, XmlHandler& handler);
  ~XmlParser();
  XmlParser(const XmlParser&) = delete;
  XmlParser& operator=(const XmlParser&) = delete;

  absl::Status Feed(std::string_view text, bool last);

  /// The next piece stands so many lines further down than what was fed before.
  void SkipLines(int64_t lines) { skipped_lines_ += lines; }

  /// Whether all that was fed is understood: no tag, comment or the like is begun and not ended.
  bool AtBoundary() const;

  /// The line that is being read.
  int64_t line() const;
  /// `error`, with the place that is being read.
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

/// All of a document. Errors: those of XmlParser.
absl::Status ParseXml(std::string_view text, std::string part, XmlHandler& handler);

}  // namespace slicefarm::slicing::threemf
