#!/usr/bin/env python3
"""Fails if a C++ test can pass without testing anything, or depends on the clock.

usage: check_tests.py [repo root]        exit 1 and one line per violation

Rules:
  empty   all expectations of a test are inside loops over results, so a test with an empty result passes. Add an expectation
          outside of the loops, for example ASSERT_FALSE(result.empty()).
  clock   an expectation compares a time that was measured. Times belong in tests/bench.
  sleep   a test sleeps. Wait for the event instead.
  stub    a test file has an empty namespace and no test.
"""
import pathlib
import re
import sys

TEST = re.compile(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+), (\w+)\) \{", re.M)
CHECK = re.compile(r"\b(?:EXPECT|ASSERT)_\w+\(|\bADD_FAILURE\(|\bFAIL\(\)|\bASSIGN_OR_FAIL\(")
RANGE_FOR = re.compile(r"\bfor \(((?:[^();]|\((?:[^()]|\([^()]*\))*\))*?) : ((?:[^();]|\((?:[^()]|\([^()]*\))*\))*)\) ?")
# A constant, a list of values or a container that the test fills by hand: its elements can be seen.
VISIBLE = re.compile(
    r"^(?:\{|k[A-Z]|[A-Z]\w*\{\s*[^}\s]|std::string\(\s{3,}\)|all\w*$|cases$|GetParam"
    r"|std::(?:vector|array|initializer_list|pair|tuple|string_view)\b.*\{)"
)
CLOCK = re.compile(r"\b(?:EXPECT|ASSERT)_(?:LT|LE|GT|GE|NEAR)\([^;]*\b(?:steady_clock|high_resolution_clock)::now\(\)")
SLEEP = re.compile(r"\bstd::this_thread::sleep_(?:for|until)\(|\babsl::SleepFor\(|\b(?:usleep|nanosleep)\(")
STUB = re.compile(r"\bnamespace \{\s*\}")
TEXT = re.compile(r'R"\((?:.|\n)*?\)"|"(?:[^"\\\n]|\\.)*"|//[^\n]*|\'(?:[^\'\\\n]|\\.)\'')


def blanked(text):
    """Returns the text with comments and string literals replaced by spaces, so that braces and offsets stay right."""
    return TEXT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def end_of_block(text, begin):
    """Returns the offset behind the block or statement that begins at `begin`."""
    depth = 0
    for at in range(begin, len(text)):
        if text[at] in "{(":
            depth += 1
        elif text[at] in "})":
            depth -= 1
            if depth == 0 and text[at] == "}":
                return at + 1
        elif text[at] == ";" and depth == 0:
            return at + 1
    return len(text)


def declared_by_hand(body, name):
    """Returns true if the test declares the container with a list of values."""
    return re.search(rf"\b{re.escape(name)}(?:\[\])? ?(?:= ?)?\{{[^}}]", body) is not None


def listed_by_function(code, call):
    """Returns true if the call is of a function of this file, without arguments, that returns a list of values."""
    name = re.fullmatch(r"(\w+)\(\)", call)
    found = name and re.search(rf"^(?:const )?std::vector<.*>&? {name[1]}\(\) \{{", code, re.M)
    if not found:
        return False
    body = code[found.end() - 1 : end_of_block(code, found.end() - 1)]
    return re.search(r"(?:\breturn |= new std::vector<[^;{]*>)\{\s*[^}\s]", body) is not None


def unseen_loops(body, code):
    """Returns (begin, end) of each loop over a result that may be empty."""
    for found in RANGE_FOR.finditer(body):
        over = found[2].strip()
        if not (VISIBLE.match(over) or declared_by_hand(body, over) or listed_by_function(code, over)):
            yield found.end(), end_of_block(body, found.end())


def tests_of(text):
    """Yields (offset, name, body) of each test."""
    for found in TEST.finditer(text):
        begin = found.end() - 1
        yield found.start(), f"{found[1]}.{found[2]}", text[begin : end_of_block(text, begin)]


def faults(path, text):
    code = blanked(text)
    for offset, name, body in tests_of(code):
        line = code.count("\n", 0, offset) + 1
        checks = [found.start() for found in CHECK.finditer(body)]
        loops = list(unseen_loops(body, code))
        if checks and all(any(begin <= at < end for begin, end in loops) for at in checks):
            yield f"{path}:{line}: empty: {name} passes without results"
    for rule, pattern in (("clock", CLOCK), ("sleep", SLEEP), ("stub", STUB)):
        for found in pattern.finditer(code):
            yield f"{path}:{code.count(chr(10), 0, found.start()) + 1}: {rule}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    files = sorted(file for folder in ("common", "processes", "services", "tests") for file in (root / folder).rglob("*_test.cc"))
    found = [fault for file in files for fault in faults(file.relative_to(root), file.read_text())]
    print("\n".join(found) or f"{len(files)} files of tests, each test expects something")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
