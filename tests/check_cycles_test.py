#!/usr/bin/env python3
"""Tests that check_cycles.py finds each include cycle of folders in a small tree, and nothing else."""
import pathlib

from planted_tree import told_of

CHECK = pathlib.Path(__file__).with_name("check_cycles.py")


def including(*headers):
    return ("".join(f'#include "{header}"\n' for header in headers),)


TREE = {
    "services/a/algo/one/x.h": including("services/a/algo/two/y.h"),
    "services/a/algo/two/y.h": including("services/a/algo/three/z.h"),
    "services/a/algo/three/z.h": including(),
    "services/a/algo/three/z.cc": including("services/a/algo/three/z.h", "services/a/algo/one/x.h"),
    "services/b/algo/top.cc": including("services/b/algo/under/low.h", "services/a/algo/one/x.h"),
    "services/b/algo/under/low.h": including(),
    "services/b/algo/under/low_test.cc": including("services/b/algo/top.h"),
    "services/b/algo/top.h": including(),
    "common/c/p.h": including("common/c/parts/q.h"),
    "common/c/parts/q.h": including("common/c/p.h"),
}
EXPECTED = [
    "common/c: includes itself through common/c/parts (--list shows where)",
    "services/a/algo/one: includes itself through services/a/algo/three, services/a/algo/two (--list shows where)",
]


def main():
    said = sorted(told_of(CHECK, TREE))
    assert said == EXPECTED, "\n".join(said)
    print(f"{len(said)} planted cycles found, nothing else")


if __name__ == "__main__":
    main()
