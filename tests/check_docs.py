#!/usr/bin/env python3
"""Fails where the documentation names something that does not exist.

usage: check_docs.py [repo root]        exit 1 and one line per violation

- Reasons of errors: common/base/error.cc, error_reason.proto, the table in proto/slicefarm/v1/README.md and the headings of
  docs/users/troubleshooting.md have the same reasons, and a test expects each reason.
- Tests: each `Suite.Name` (or `.Name` after one) in a table of docs/reliability.md is a test.
- Paths: README.md, CHANGELOG.md, docs, processes/README.md and proto/slicefarm/v1/README.md name files and folders that exist.
  A path may have `<name>`, `*` or `{a,b}`, and a file of C++ may be named without its suffix.
- The first version of CHANGELOG.md is the version of CMakeLists.txt.
- Links: the file and the heading of each link of these documents exist.
- Alerts: deploy/monitoring/alerts.yml and the table of docs/users/alerts.md have the same names.
"""
import itertools
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
SOURCES = ["common", "processes", "services", "tests"]
DOCUMENTS = ["README.md", "CHANGELOG.md", "processes/README.md", "proto/slicefarm/v1/README.md"]
PATH = re.compile(r"(?<![\w./~*-])(?:\.ci|cmake|common|deploy|docs|processes|proto|services|tests)/[\w./<>*{},+-]*")
LINK = re.compile(r"\[[^\]]*\]\(([^)#\s]*)(#[^)\s]*)?\)")


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
    guide = set(re.findall(r"^### ([A-Z_]+)$", read("docs/users/troubleshooting.md"), re.M))
    for where, there in [("error_reason.proto", enum), ("the README's table", table), ("docs/users/troubleshooting.md", guide)]:
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


def documents():
    found = [*(ROOT / name for name in DOCUMENTS), *sorted((ROOT / "docs").rglob("*.md"))]
    return [path for path in found if path.exists()]


def alternatives(path):
    """Returns the paths of `a/{b,c}.h`: a/b.h and a/c.h."""
    parts = [part[1:-1].split(",") if part.startswith("{") else [part] for part in re.split(r"(\{[^}]*\})", path)]
    return ["".join(each) for each in itertools.product(*parts)]


def exists(path):
    pattern = re.sub(r"<\w+>", "*", path).rstrip("/")
    return any(next(ROOT.glob(pattern + suffix), None) for suffix in ("", ".h", ".cc", ".py"))


def check_paths():
    for document in documents():
        for number, line in enumerate(document.read_text().splitlines(), 1):
            for found in PATH.findall(line):
                for path in alternatives(found.rstrip(".,:;-")):
                    if not exists(path):
                        yield f"{document.relative_to(ROOT)}:{number}: there is no {path}"


def check_version():
    if not (ROOT / "CHANGELOG.md").exists():
        yield "there is no CHANGELOG.md"
        return
    version = re.search(r"^project\(\w+ VERSION ([\d.]+)", read("CMakeLists.txt"), re.M)[1]
    newest = re.search(r"^## ([\d.]+)", read("CHANGELOG.md"), re.M)[1]
    if newest != version:
        yield f"CHANGELOG.md begins with {newest}, CMakeLists.txt has {version}"


def check_alerts():
    rules = set(re.findall(r"^ *- alert: (\w+)$", read("deploy/monitoring/alerts.yml"), re.M))
    rows = set(re.findall(r"^\|.*?`(\w+)` \|", read("docs/users/alerts.md"), re.M))
    for name in sorted(rules - rows):
        yield f"alert {name} is not in docs/users/alerts.md"
    for name in sorted(rows - rules):
        yield f"{name} of docs/users/alerts.md is no alert"


def anchors(document):
    """Returns the anchors of the document's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", document.read_text(), re.M)
    return {"#" + re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)).strip().lower().replace(" ", "-")
            for text in headings}


def check_links():
    for document in documents():
        for target, anchor in LINK.findall(document.read_text()):
            if re.match(r"\w+:", target):
                continue
            file = (document.parent / target).resolve() if target else document
            name = f"{document.relative_to(ROOT)}: the link {target}{anchor}"
            if not file.exists():
                yield f"{name} has no file"
            elif anchor and file.suffix == ".md" and anchor not in anchors(file):
                yield f"{name} has no heading"


def main():
    problems = [*check_reasons(), *check_named_tests(), *check_paths(), *check_version(), *check_links(), *check_alerts()]
    for problem in problems:
        print(problem)
    if not problems:
        print("everything that the documentation names exists")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
