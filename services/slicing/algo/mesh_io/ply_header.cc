#include "services/slicing/algo/mesh_io/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/text_lines.h"

namespace slicefarm::slicing {
namespace {

/// Limits of the header, larger than the headers of all known programs. They are needed because
/// each property costs time per element.
constexpr size_t kMaxElements = 64;
constexpr size_t kMaxProperties = 256;

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{{"char", PlyType::kInt8},
                                                  {"uchar", PlyType::kUint8},
                                                  {"short", PlyType::kInt16},
                                                  {"ushort", PlyType::kUint16},
                                                  {"int", PlyType::kInt32},
                                                  {"uint", PlyType::kUint32},
                                                  {"float", PlyType::kFloat},
                                                  {"double", PlyType::kDouble},
                                                  {"int8", PlyType::kInt8},
                                                  {"uint8", PlyType::kUint8},
                                                  {"int16", PlyType::kInt16},
                                                  {"uint16", PlyType::kUint16},
                                                  {"int32", PlyType::kInt32},
                                                  {"uint32", PlyType::kUint32},
                                                  {"float32", PlyType::kFloat},
                                                  {"float64", PlyType::kDouble}}};

std::optional<PlyType> TypeOf(std::string_view name) {
  const auto* found = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                   [name](const TypeName& type) { return type.name == name; });
  return found == kTypeNames.end() ? std::nullopt : std::optional(found->type);
}

std::optional<PlyEncoding> EncodingOf(std::string_view name) {
  if (name == "ascii") return PlyEncoding::kAscii;
  if (name == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (name == "binary_big_endian") return PlyEncoding::kBigEndian;
  return std::nullopt;
}

/// Parser of the header, line by line. Binary data may follow its last line directly, so the parser
/// finds the line ends itself.
class HeaderParser {
 public:
  explicit HeaderParser(std::string_view bytes) : bytes_(bytes) {}

  absl::StatusOr<PlyHeader> Run() && {
    for (;;) {
      const std::optional<std::string_view> line = NextLine();
      if (!line) return Error(Reason::kMeshTruncated, "a PLY without `end_header`");
      if (static_cast<int64_t>(line->size()) > limits::kMaxAsciiLineBytes)
        return Error(Reason::kMeshMalformed, "a line of the header is too long");
      Words words(*line);
      const std::string_view keyword = words.Next();
      if (keyword == "end_header") return Finish();
      if (absl::Status status = Statement(keyword, words); !status.ok()) return status;
    }
  }

 private:
  std::optional<std::string_view> NextLine() {
    const size_t end = bytes_.find('\n', header_.bytes);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view line = bytes_.substr(header_.bytes, end - header_.bytes);
    header_.bytes = end + 1;
    ++header_.lines;
    return line;
  }

  absl::Status Statement(std::string_view keyword, Words& words) {
    if (keyword == "format") return Format(words);
    if (keyword == "element") return Element(words);
    if (keyword == "property") return Property(words);
    const bool says_nothing = keyword == "ply" || keyword == "comment" || keyword == "obj_info";
    if (keyword.empty() || says_nothing) return absl::OkStatus();
    return Error(Reason::kMeshMalformed, "not a statement of a PLY's header");
  }

  absl::Status Format(Words& words) {
    const std::optional<PlyEncoding> encoding = EncodingOf(words.Next());
    if (!encoding) return Error(Reason::kMeshMalformed, "the encoding of the PLY file is unknown");
    header_.encoding = *encoding;
    has_format_ = true;
    return absl::OkStatus();
  }

  absl::Status Element(Words& words) {
    PlyElement element;
    element.name = words.Next();
    if (std::any_of(element.name.begin(), element.name.end(), IsControl))
      return Error(Reason::kMeshMalformed, "an element's name has control characters");
    const std::string_view count = words.Next();
    const char* const end = count.data() + count.size();
    const auto [at, error] = std::from_chars(count.data(), end, element.count);
    if (error != std::errc() || at != end || element.count < 0)
      return Error(Reason::kMeshMalformed, "an element must have a name and a count");
    if (header_.elements.size() >= kMaxElements)
      return Error(Reason::kMeshMalformed, "too many elements");
    header_.elements.push_back(std::move(element));
    return absl::OkStatus();
  }

  absl::Status Property(Words& words) {
    if (header_.elements.empty())
      return Error(Reason::kMeshMalformed, "a property before any element");
    PlyProperty property;
    std::string_view type = words.Next();
    if (type == "list") {
      const std::optional<PlyType> count_type = TypeOf(words.Next());
      if (!count_type || *count_type >= PlyType::kFloat)
        return Error(Reason::kMeshMalformed, "the length of a list must be an integer");
      property.is_list = true;
      property.count_type = *count_type;
      type = words.Next();
    }
    const std::optional<PlyType> known = TypeOf(type);
    property.name = words.Next();
    if (!known || property.name.empty())
      return Error(Reason::kMeshMalformed, "a property must have a type and a name");
    property.type = *known;
    std::vector<PlyProperty>& all = header_.elements.back().properties;
    if (all.size() >= kMaxProperties) return Error(Reason::kMeshMalformed, "too many properties");
    all.push_back(std::move(property));
    return absl::OkStatus();
  }

  absl::StatusOr<PlyHeader> Finish() {
    if (!has_format_) return Error(Reason::kMeshMalformed, "a PLY without `format`");
    return std::move(header_);
  }

  absl::Status Error(Reason reason, std::string_view what) const {
    return MakeError(absl::StatusCode::kInvalidArgument, reason,
                     std::string(what) + " (line " + std::to_string(header_.lines) + ")",
                     {{"line", std::to_string(header_.lines)}});
  }

  std::string_view bytes_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

size_t PlySize(PlyType type) {
  constexpr std::array<size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<size_t>(type)];
}

absl::StatusOr<PlyHeader> ReadPlyHeader(std::string_view bytes) {
  return HeaderParser(bytes).Run();
}

}  // namespace slicefarm::slicing
