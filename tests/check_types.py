#!/usr/bin/env python3
"""Fails if two files define the same qualified type name: a program that links both would mix up their member
functions.

usage: check_types.py [repo root]        exit 1 and one line per name
"""
import collections
import pathlib
import re
import sys

NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#(?:\\\n|[^\n])*', re.S | re.M)
DIGIT_SEPARATOR = re.compile(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])")
NAMESPACE = re.compile(r"\b(?:inline\s+)?namespace\s*([\w:]*)\s*$")
TYPE = re.compile(r"(?:^|\s)(?:class|struct|union|enum(?:\s+(?:class|struct))?)\s+([\w:]+)\s*(?:final\b\s*)?(?::[^:].*)?$", re.S)
SPECIALISATION = re.compile(r"\btemplate\s*<\s*>")


def definitions(text):
    """Yields the qualified names of the types that `text` defines in named namespaces."""
    text = NOISE.sub(" ", DIGIT_SEPARATOR.sub("", text))
    scopes = []  # name of each open namespace or type; None for any other brace
    start = 0
    for match in re.finditer(r"[{};]", text):
        if match[0] == "{":
            head = text[start : match.start()].strip()
            scope = None
            if space := NAMESPACE.search(head):
                scope = space[1] or None
            elif named := TYPE.search(head):
                scope = named[1]
                if scopes and None not in scopes and not SPECIALISATION.search(head):
                    yield "::".join([*scopes, scope])
            scopes.append(scope)
        elif match[0] == "}" and scopes:
            scopes.pop()
        start = match.end()


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    files = [f for d in ("common", "processes", "services", "tests") for e in ("h", "cc") for f in sorted((root / d).rglob(f"*.{e}"))]
    found = collections.defaultdict(set)
    for file in files:
        for name in definitions(file.read_text()):
            found[name].add(file.relative_to(root).as_posix())
    if not found:
        print(f"no types under {root}")
        return 1
    twice = [f"{min(where)}: {name} is defined in {max(where)} too" for name, where in sorted(found.items()) if len(where) > 1]
    print("\n".join(twice) or f"{len(found)} types, each defined once")
    return 1 if twice else 0


if __name__ == "__main__":
    sys.exit(main())
