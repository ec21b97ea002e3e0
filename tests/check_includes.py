#!/usr/bin/env python3
"""Fails if a file names a type whose header it does not include, directly or indirectly.

usage: check_includes.py [repo root]        exit 1 and one line per violation

The preset `cold` compiles all files of a library as one unit. Then a missing include is hidden as long as another file
has it. The check covers the types whose name is declared in one header only.
"""
import functools
import pathlib
import re
import sys

INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
# Comments and quoted text, which are ignored.
NOISE = re.compile(r'R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.S)
DECLARED = re.compile(r"^(?:(?:class|struct|enum class)(?: \[\[\w+\]\])? (\w+)(?: final)?(?=[\s:{;])|using (\w+) =)", re.M)
FORWARD = re.compile(r"^(?:class|struct|enum class) (\w+)(?: : \w+)?;", re.M)

TEST_FILE = re.compile(r"_test\.(cc|h)$")
FOREIGN = {"boost", "v1", "grpc", "std", "testing"}
# Words that are also names of members, or of types of one file.
ELSEWHERE = set(
    """Attempt Call Candidate Claimed Done Entries Join Kind Link Move Path Piece Place Plate Reply Run Shared Span Stack Tenant Then Turn
    Value Visit boost""".split()
)
USE = re.compile(r"(?<![.\w>])(?:(\w+)::)?(\w+)(?=\s*[&*>{]|::|\s+\w)")


def sources(root):
    files = [f for d in ("common", "processes", "services") for e in ("h", "cc") for f in sorted((root / d).rglob(f"*.{e}"))]
    return {str(f.relative_to(root)): f.read_text() for f in files}


def headers_by_type(code):
    """Returns the header of each type; None if several headers declare it."""
    found = {}
    for path, text in code.items():
        if not path.endswith(".h"):
            continue
        for names in DECLARED.finditer(text):
            name = names.group(1) or names.group(2)
            if FORWARD.match(text, names.start()) or name in ELSEWHERE:
                continue
            found[name] = path if found.get(name, path) == path else None
    return {name: path for name, path in found.items() if path}


def check(texts):
    includes = {path: [i for i in INCLUDE.findall(text) if i in texts] for path, text in texts.items()}
    code = {path: NOISE.sub(" ", text) for path, text in texts.items()}
    types = headers_by_type(code)

    @functools.cache
    def reached(path):
        seen, left = {path}, [path]
        while left:
            for included in includes[left.pop()]:
                if included not in seen:
                    seen.add(included)
                    left.append(included)
        return seen

    for path, text in sorted(code.items()):
        own = {a or b for a, b in re.findall(r"\b(?:enum class|class|struct|enum|typename) (\w+)\b|\busing (\w+) =", text)}
        for name in sorted({name for scope, name in USE.findall(text) if scope not in FOREIGN}):
            header = types.get(name)
            if header and not TEST_FILE.search(path) and TEST_FILE.search(header):
                continue  # product code means another type of this name
            if header and name not in own and header not in reached(path):
                yield f"{path}: names {name}, and does not include {header}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    errors = list(check(sources(root)))
    print("\n".join(errors))
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
