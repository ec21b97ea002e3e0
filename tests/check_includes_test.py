#!/usr/bin/env python3
"""Tests that check_includes.py finds the violations planted in a small tree, and nothing else."""
import pathlib

from planted_tree import told_of

CHECK = pathlib.Path(__file__).with_name("check_includes.py")
SCENE = "struct SceneObject {\n  int parts;\n};\nenum class PartRole : int { kPart };\n"
# path: (text, types in the text that are named without their headers)
TREE = {
    "common/model/scene.h": (SCENE, []),
    "common/model/twice.h": ("struct TwoHeaders {};\nclass ReplicaSet;\n", []),
    "services/a/twice.h": ("struct TwoHeaders {};\n", []),
    "services/a/through.h": ('#include "common/model/scene.h"\n', []),
    "services/a/reached.cc": ('#include "services/a/through.h"\nSceneObject object;\n', []),
    "services/a/missed.h": ("void Take(const SceneObject& object, PartRole role);\n", ["PartRole", "SceneObject"]),
    "services/a/missed.cc": ('#include "services/a/missed.h"\nauto role = PartRole::kPart;\n', ["PartRole"]),
    "services/a/forward.h": ("struct SceneObject;\nvoid Take(const SceneObject& object);\n", []),
    "services/a/wire.cc": ("v1::SceneObject proto;\n", []),
    "services/a/quoted.cc": ('// SceneObject object\nauto s = "SceneObject object";\n', []),
    "services/a/outcome_test.h": ("struct Outcome {};\n", []),
    "services/a/outcome.cc": ("enum class PartRole {};\nOutcome outcome;\nPartRole role;\n", []),
    "services/a/outcome_test.cc": ("Outcome outcome;\n", ["Outcome"]),
    "services/a/either.cc": ("TwoHeaders two;\nReplicaSet set;\n", []),
}


def main():
    lines = told_of(CHECK, TREE)
    planted = [(path, name) for path, (_, names) in TREE.items() for name in names]
    told = [(line.split(":")[0], line.split()[2].rstrip(",")) for line in lines]
    assert sorted(told) == sorted(planted), lines
    print(f"{len(planted)} planted violations found, nothing else")


if __name__ == "__main__":
    main()
