#!/usr/bin/env python3
"""What the documentation names must be there:

  - the reasons of errors: the same in common/base/error.cc, error_reason.proto and proto/slicefarm/v1/README.md, and each
    looked for by a test;
  - tests: every `Suite.Name` (or `.Name` after one) in a table of docs/reliability.md.

Run without arguments from anywhere; exit code 1 and one line for each thing that is missing."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ["common", "processes", "services", "tests"]


def read(path):
    return (ROOT / path).read_text()


def test_sources():
    for folder in SOURCES:
        yield from sorted((ROOT / folder).rglob("*_test.*"))


def check_reasons():
    names = re.findall(r'\{Reason::(k\w+), "(\w+)"\}', read("common/base/error.cc"))
    known = {name for _, name in names}
    enum = set(re.findall(r"^  ([A-Z_]+) = [1-9]\d*;", read("proto/slicefarm/v1/error_reason.proto"), re.M))
    table = set(re.findall(r"^\| ([A-Z_]+) \|", read("proto/slicefarm/v1/README.md"), re.M))
    for where, there in [("error_reason.proto", enum), ("the README's table", table)]:
        for name in sorted(known - there):
            yield f"{name} is not in {where}"
        for name in sorted(there - known):
            yield f"{name} of {where} is no reason"
    tests = "\n".join(path.read_text() for path in test_sources())
    for value, name in names:
        if f"Reason::{value}" not in tests and name not in tests:
            yield f"no test looks for {name}"


def existing_tests():
    found = set()
    for path in test_sources():
        for suite, name in re.findall(r"\bTEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", path.read_text()):
            found.add((suite.removesuffix("Test"), name))
    return found


def check_named_tests():
    existing = existing_tests()
    for line in read("docs/reliability.md").splitlines():
        if not line.startswith("| "):
            continue
        suite = None
        for given, name in re.findall(r"`([A-Z]\w+)?\.([A-Z]\w+)`", line.rsplit("|", 2)[-2]):
            suite = given or suite
            if (suite, name) not in existing:
                yield f"docs/reliability.md: there is no test {suite}.{name}"


def main():
    problems = [*check_reasons(), *check_named_tests()]
    for problem in problems:
        print(problem)
    if not problems:
        print("what the documentation names is there")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
