#include "services/motion/algo/macro/text_pattern.h"

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace slicefarm::motion {
namespace {

constexpr size_t kLongest = 1'000;
constexpr int kDeepest = 50;

using CharSet = std::bitset<256>;

CharSet Range(char first, char last) {
  CharSet set;
  for (int c = static_cast<unsigned char>(first); c <= static_cast<unsigned char>(last); ++c) {
    set.set(static_cast<size_t>(c));
  }
  return set;
}

CharSet Single(char c) { return Range(c, c); }

/// What a backslash and `c` stand for.
CharSet Escaped(char c) {
  const CharSet digits = Range('0', '9');
  const CharSet word = digits | Range('a', 'z') | Range('A', 'Z') | Single('_');
  const CharSet space = Range('\t', '\r') | Single(' ');
  switch (c) {
    case 'd':
      return digits;
    case 'D':
      return ~digits;
    case 'w':
      return word;
    case 'W':
      return ~word;
    case 's':
      return space;
    case 'S':
      return ~space;
    case 'n':
      return Single('\n');
    default:
      return Single(c);
  }
}

struct Instruction {
  enum Kind : uint8_t { kRead, kFork, kMatch };
  Kind kind = kMatch;
  uint32_t set = 0;  ///< of kRead: what it takes
  // Of kFork: both ways on, from here. A kRead goes on to the next instruction.
  int32_t first = 0;
  int32_t second = 0;
};

/// Compiles by recursive descent. A part of the pattern is a stretch of instructions that is
/// entered at its start and left past its end; as ways on are relative, stretches can be put
/// together.
class Compiler {
 public:
  explicit Compiler(std::string_view pattern) : pattern_(pattern) {}

  struct Program {
    std::vector<Instruction> code;
    std::vector<CharSet> sets;
  };

  absl::StatusOr<Program> Compile() {
    Part code = Alternatives();
    if (error_.empty() && at_ < pattern_.size()) error_ = "unexpected \")\"";
    if (!error_.empty()) return absl::InvalidArgumentError("regular expression: " + error_);
    code.push_back({});
    return Program{std::move(code), std::move(sets_)};
  }

 private:
  using Part = std::vector<Instruction>;

  static int32_t Offset(size_t size) { return static_cast<int32_t>(size); }

  static Instruction Fork(int32_t first, int32_t second) {
    return {Instruction::kFork, 0, first, second};
  }

  static void Append(Part& part, const Part& more) {
    part.insert(part.end(), more.begin(), more.end());
  }

  Part Alternatives() {
    if (++depth_ > kDeepest) error_ = "too deep";
    Part part = Sequence();
    while (error_.empty() && Take('|')) {
      const Part other = Sequence();
      // fork; part; jump past other; other
      Part both = {Fork(1, Offset(part.size()) + 2)};
      Append(both, part);
      both.push_back(Fork(Offset(other.size()) + 1, Offset(other.size()) + 1));
      Append(both, other);
      part = std::move(both);
    }
    --depth_;
    return part;
  }

  Part Sequence() {
    Part part;
    while (error_.empty() && at_ < pattern_.size() && pattern_[at_] != '|' &&
           pattern_[at_] != ')') {
      Append(part, Repeated());
    }
    return part;
  }

  Part Repeated() {
    Part part = Atom();
    while (error_.empty()) {
      const size_t size = part.size();
      Part repeated;
      if (Take('*')) {
        repeated = {Fork(1, Offset(size) + 2)};
        Append(repeated, part);
        repeated.push_back(Fork(-Offset(size) - 1, -Offset(size) - 1));
      } else if (Take('+')) {
        repeated = part;
        repeated.push_back(Fork(-Offset(size), 1));
      } else if (Take('?')) {
        repeated = {Fork(1, Offset(size) + 1)};
        Append(repeated, part);
      } else {
        break;
      }
      part = std::move(repeated);
    }
    return part;
  }

  Part Atom() {
    const char c = pattern_[at_++];
    switch (c) {
      case '(':
        return Group();
      case '[':
        return Read(Class());
      case '.':
        return Read(~CharSet());
      case '^':
      case '$':
        return {};
      case '*':
      case '+':
      case '?':
        error_ = "nothing to repeat";
        return {};
      case '\\':
        if (at_ == pattern_.size()) {
          error_ = "ends in a backslash";
          return {};
        }
        return Read(Escaped(pattern_[at_++]));
      default:
        return Read(Single(c));
    }
  }

  Part Group() {
    if (pattern_.substr(at_).starts_with("?:")) at_ += 2;
    Part part = Alternatives();
    if (error_.empty() && !Take(')')) error_ = "\"(\" without \")\"";
    return part;
  }

  CharSet Class() {
    const bool negated = Take('^');
    CharSet set;
    for (bool first = true; at_ < pattern_.size(); first = false) {
      const char c = pattern_[at_++];
      if (c == ']' && !first) return negated ? ~set : set;
      if (c == '\\' && at_ < pattern_.size()) {
        set |= Escaped(pattern_[at_++]);
      } else if (at_ + 1 < pattern_.size() && pattern_[at_] == '-' && pattern_[at_ + 1] != ']') {
        set |= Range(c, pattern_[at_ + 1]);
        at_ += 2;
      } else {
        set |= Single(c);
      }
    }
    error_ = "\"[\" without \"]\"";
    return set;
  }

  Part Read(const CharSet& set) {
    sets_.push_back(set);
    return {{Instruction::kRead, static_cast<uint32_t>(sets_.size() - 1), 0, 0}};
  }

  bool Take(char c) {
    if (at_ == pattern_.size() || pattern_[at_] != c) return false;
    ++at_;
    return true;
  }

  std::string_view pattern_;
  size_t at_ = 0;
  int depth_ = 0;
  std::string error_;
  std::vector<CharSet> sets_;
};

/// The instructions that the automaton may be at.
class States {
 public:
  explicit States(const std::vector<Instruction>& code) : code_(code), on_(code.size(), false) {}

  void Add(uint32_t start) {
    pending_.push_back(start);
    while (!pending_.empty()) {
      const uint32_t i = pending_.back();
      pending_.pop_back();
      if (on_[i]) continue;
      on_[i] = true;
      list_.push_back(i);
      if (code_[i].kind != Instruction::kFork) continue;
      for (const int32_t way : {code_[i].first, code_[i].second}) {
        pending_.push_back(i + static_cast<uint32_t>(way));
      }
    }
  }
  void Clear() {
    for (const uint32_t i : list_) on_[i] = false;
    list_.clear();
  }
  const std::vector<uint32_t>& list() const { return list_; }

 private:
  const std::vector<Instruction>& code_;
  std::vector<bool> on_;
  std::vector<uint32_t> list_;
  std::vector<uint32_t> pending_;
};

}  // namespace

absl::StatusOr<bool> MatchesPattern(std::string_view text, std::string_view pattern) {
  if (pattern.size() > kLongest) {
    return absl::InvalidArgumentError("regular expression: too long");
  }
  const auto program = Compiler(pattern).Compile();
  if (!program.ok()) return program.status();
  States even(program->code);
  States odd(program->code);
  States* now = &even;
  States* next = &odd;
  now->Add(0);
  for (const char c : text) {
    next->Clear();
    for (const uint32_t i : now->list()) {
      const Instruction& instruction = program->code[i];
      if (instruction.kind != Instruction::kRead) continue;
      if (program->sets[instruction.set].test(static_cast<unsigned char>(c))) next->Add(i + 1);
    }
    std::swap(now, next);
  }
  return std::any_of(now->list().begin(), now->list().end(),
                     [&](uint32_t i) { return program->code[i].kind == Instruction::kMatch; });
}

}  // namespace slicefarm::motion
