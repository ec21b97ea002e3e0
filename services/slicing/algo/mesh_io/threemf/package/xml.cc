#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

#include <expat.h>
#include <fmt/core.h>

#include <new>
#include <utility>

#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/point_hash.h"
#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"

namespace slicefarm::slicing::threemf {
namespace {

/// Returns a salt for expat's hash table, never 0. Without a salt expat requests entropy from the
/// system, which a sandboxed reader may not do.
unsigned long HashSalt() {
  return static_cast<unsigned long>(PointHash::OfProcess()({1, 2, 3})) | 1;
}

/// Size of a piece of text passed to expat, which takes an int.
constexpr size_t kMaxPieceBytes = 1 << 20;

}  // namespace

std::optional<std::string_view> Find(XmlAttributes attributes, std::string_view name) {
  for (const XmlAttribute& attribute : attributes)
    if (attribute.name == name) return attribute.value;
  return std::nullopt;
}

std::optional<std::string_view> FindPrefixed(XmlAttributes attributes, std::string_view name) {
  for (const XmlAttribute& attribute : attributes) {
    const size_t colon = attribute.name.find(':');
    if (colon != std::string_view::npos && attribute.name.substr(colon + 1) == name)
      return attribute.value;
  }
  return std::nullopt;
}

absl::Status XmlHandler::Text(std::string_view) { return absl::OkStatus(); }

absl::Status Malformed(std::string_view what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed, what);
}

struct XmlParser::Callbacks {
  static XmlParser& Of(void* data) { return *static_cast<XmlParser*>(data); }

  static void Start(void* data, const char* name, const char** attributes) {
    XmlParser& parser = Of(data);
    if (!parser.failed_.ok()) return;
    if (++parser.depth_ > limits::kMaxXmlDepth) {
      parser.Fail(LimitError(Reason::kMeshMalformed, "elements within each other",
                             limits::kMaxXmlDepth, parser.depth_));
      return;
    }
    parser.attributes_.clear();
    for (; *attributes != nullptr; attributes += 2)
      parser.attributes_.push_back({attributes[0], attributes[1]});
    parser.Fail(parser.handler_.Start(name, parser.attributes_, parser.line()));
  }

  static void End(void* data, const char* name) {
    XmlParser& parser = Of(data);
    if (!parser.failed_.ok()) return;
    --parser.depth_;
    parser.Fail(parser.handler_.End(name));
  }

  static void Text(void* data, const char* text, int size) {
    XmlParser& parser = Of(data);
    if (parser.failed_.ok()) parser.Fail(parser.handler_.Text({text, static_cast<size_t>(size)}));
  }

  static void Doctype(void* data, const char*, const char*, const char*, int) {
    Of(data).Fail(Malformed("the file has a document type definition, which 3MF does not allow"));
  }
};

void XmlParser::Freer::operator()(XML_ParserStruct* parser) const { XML_ParserFree(parser); }

XmlParser::XmlParser(std::string part, XmlHandler& handler)
    : part_(std::move(part)), handler_(handler), parser_(XML_ParserCreate(nullptr)) {
  if (parser_ == nullptr) throw std::bad_alloc();
  XML_SetHashSalt(parser_.get(), HashSalt());
  XML_SetUserData(parser_.get(), this);
  XML_SetElementHandler(parser_.get(), &Callbacks::Start, &Callbacks::End);
  XML_SetCharacterDataHandler(parser_.get(), &Callbacks::Text);
  XML_SetStartDoctypeDeclHandler(parser_.get(), &Callbacks::Doctype);
}

XmlParser::~XmlParser() = default;

absl::Status XmlParser::Feed(std::string_view text, bool last) {
  do {
    const std::string_view piece = text.substr(0, kMaxPieceBytes);
    text.remove_prefix(piece.size());
    fed_ += static_cast<int64_t>(piece.size());
    const XML_Status parsed = XML_Parse(parser_.get(), piece.data(), static_cast<int>(piece.size()),
                                        last && text.empty() ? 1 : 0);
    if (!failed_.ok()) return failed_;
    if (parsed == XML_STATUS_ERROR) return SyntaxError();
    // The parser has not yet handled the text behind its last event.
    const int64_t pending = fed_ - XML_GetCurrentByteIndex(parser_.get());
    if (pending > limits::kMaxXmlTagBytes + static_cast<int64_t>(kMaxPieceBytes))
      return Placed(
          LimitError(Reason::kMeshMalformed, "bytes of a tag", limits::kMaxXmlTagBytes, pending));
  } while (!text.empty());
  return absl::OkStatus();
}

bool XmlParser::AtBoundary() const { return XML_GetCurrentByteIndex(parser_.get()) == fed_; }

int64_t XmlParser::line() const {
  return static_cast<int64_t>(XML_GetCurrentLineNumber(parser_.get())) + skipped_lines_;
}

absl::Status XmlParser::Placed(const absl::Status& error) const {
  if (!absl::IsInvalidArgument(error)) return error;
  return WithLocation({part_, line()}, error);
}

absl::Status XmlParser::SyntaxError() const {
  const XML_Error code = XML_GetErrorCode(parser_.get());
  if (code == XML_ERROR_NO_MEMORY) {
    if (const std::new_handler handler = std::get_new_handler()) handler();
    throw std::bad_alloc();
  }
  return Placed(Malformed(fmt::format("not XML: {}", XML_ErrorString(code))));
}

void XmlParser::Fail(const absl::Status& error) {
  if (error.ok() || !failed_.ok()) return;
  failed_ = Placed(error);
  XML_StopParser(parser_.get(), XML_FALSE);
}

absl::Status ParseXml(std::string_view text, std::string part, XmlHandler& handler) {
  return XmlParser(std::move(part), handler).Feed(text, true);
}

}  // namespace slicefarm::slicing::threemf
