#include "services/motion/algo/text/comment_text.h"

#include "common/base/text.h"

namespace slicefarm::motion {

std::string OneLine(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '\n':
        line += "\\n";
        break;
      case '\r':
        line += "\\r";
        break;
      case '\\':
        line += "\\\\";
        break;
      default:
        line += c;
    }
  }
  return ReplaceControls(line, ' ');
}

std::string CommentLine(std::string_view line) { return ReplaceControls(line, ' '); }

std::string JsonString(std::string_view text) {
  std::string json = "\"";
  for (const char c : ReplaceControls(text, ' ')) {
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  return json + '"';
}

}  // namespace slicefarm::motion
