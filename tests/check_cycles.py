#!/usr/bin/env python3
"""Fails if folders include each other, directly or through other folders.

usage: check_cycles.py [repo root] [--list]        exit 1 and one line per violation; --list shows the includes of each
cycle

A folder can be read, built and tested by itself. Folders in an include cycle cannot: they form one unit. Test headers
may include any header.
"""
import collections
import pathlib
import re
import sys

INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
TEST_FILE = re.compile(r"_test\.(cc|h)$")


def includes_between_folders(root):
    """Returns {(folder, included folder): [(file, included file)]} of product code."""
    found = collections.defaultdict(list)
    files = [f for d in ("common", "processes", "services") for e in ("h", "cc") for f in sorted((root / d).rglob(f"*.{e}"))]
    for file in files:
        path = file.relative_to(root)
        if TEST_FILE.search(path.name):
            continue
        for included in INCLUDE.findall(file.read_text()):
            folder = pathlib.PurePosixPath(included).parent
            if folder != path.parent and (root / included).exists():
                found[str(path.parent), str(folder)].append((str(path), included))
    return found


def reached(start, edges):
    """Returns all folders that `start` includes, directly or through other folders."""
    seen, left = set(), [start]
    while left:
        for folder in edges[left.pop()] - seen:
            seen.add(folder)
            left.append(folder)
    return seen


def cycles(found):
    """Returns the sets of folders in which each folder reaches every other folder."""
    edges = collections.defaultdict(set)
    for a, b in found:
        edges[a].add(b)
    reach = {folder: reached(folder, edges) for folder in list(edges)}
    groups = {frozenset(b for b in reach[a] if a in reach.get(b, ())) for a in reach if a in reach[a]}
    return sorted(map(sorted, groups))


def check(found):
    for group in cycles(found):
        yield f"{group[0]}: includes itself through {', '.join(group[1:])} (--list shows where)"


def show(found):
    for group in cycles(found):
        print(" ".join(group))
        for (a, b), includes in sorted(found.items()):
            if a in group and b in group:
                for path, included in includes:
                    print(f"  {path} includes {included}")


def main():
    names = [a for a in sys.argv[1:] if not a.startswith("--")]
    found = includes_between_folders(pathlib.Path(names[0] if names else ".").resolve())
    if "--list" in sys.argv:
        show(found)
        return 0
    errors = list(check(found))
    print("\n".join(errors) or "no folders include each other")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
