#!/usr/bin/env python3
"""Tests that check_types.py finds each type that two files of a small tree define, and nothing else."""
import pathlib

from planted_tree import told_of

CHECK = pathlib.Path(__file__).with_name("check_types.py")
# path: (text, qualified names that must be reported with that file as the first of two)
TREE = {
    "services/a/branches.h": ("namespace slicefarm::plan {\nstruct Node {\n  int x = 0;\n};\n}  // namespace\n", ["slicefarm::plan::Node"]),
    "services/b/branches.h": ("namespace slicefarm {\nnamespace plan {\nclass Node final : public Base {\n};\n}\n}\n", []),
    "services/a/other.h": ("namespace slicefarm::other {\nstruct Node {};\n}\n", []),
    "services/a/hidden.cc": ("namespace slicefarm::plan {\nnamespace {\nstruct Node {};\n}\n}\n", []),
    "services/a/local.cc": ("namespace slicefarm::plan {\nint F() {\n  struct Node {};\n  return '}' + \"{\"[0] + 1'000;\n}\nenum class Kind : int { kA };\n}\n", ["slicefarm::plan::Kind"]),
    "services/b/kind.h": ("namespace slicefarm::plan {\nenum class Kind {\n};\n}\n", []),
    "services/a/forward.h": ("namespace slicefarm::plan {\nstruct Node;\nstruct Tree* F(struct Tree* t);\ntemplate <class T>\nstruct Box {};\n}\n", []),
    "services/b/special.h": ("namespace slicefarm::plan {\ntemplate <>\nstruct Box<int> {};\nstruct Tree { struct Node {}; };\n}\n", ["slicefarm::plan::Tree"]),
    "tests/tree_test.cc": ("namespace slicefarm::plan {\nstruct Tree {\n  // struct Tree { in a comment\n  struct Leaf {};\n};\n}\n", []),
}


def main():
    expected = sorted(f"{path}: {name} is defined in " for path, (_, names) in TREE.items() for name in names)
    said = sorted(told_of(CHECK, TREE))
    assert len(said) == len(expected), "\n".join(said)
    for line, start in zip(said, expected):
        assert line.startswith(start), f"{line!r} instead of {start!r}"
    print(f"{len(said)} planted types found, nothing else")


if __name__ == "__main__":
    main()
