#!/usr/bin/env python3
"""check_prose.py must find each planted fault of a small tree, and nothing else; and its limits must count."""
import collections
import pathlib
import tempfile

import check_prose

LONG = " ".join(["word"] * 31) + "."
# path: (text, the expected findings as "line: rule (detail)")
TREE = {
    "a/headless.h": ("/// Of beads, by layer.\nint a;\n\n/// Bead widths, in nm.\nint b;\n", ["1: headless (Of)"]),
    "a/whether.h": ("// Whether a job waits.\nbool a;\n", ["1: headless (Whether)"]),
    "a/member.h": ("int a;  ///< of a layer\nint b;  ///< height of a layer,\n        ///< which nobody reads\n", ["1: headless (of)", "2: wh (nobody)"]),
    "a/wh.cc": ("int a;\n// Returns what\n// was read.\nint F();\n", ["2: wh (what)"]),
    "a/private.cc": ("// Keeps the ways apart.\n", ["1: private (ways -> travel, toolpath or pass)"]),
    "a/code.cc": ("// Calls `what` and `whatever`.\nconst char* what = \"what comes to those\";  // what\n", []),
    "a/long.cc": (f"// {LONG}\n", ["1: long (31 words)"]),
    "a/list.cc": (f"// Steps:\n// - {' '.join(['word'] * 20)}\n// - {' '.join(['word'] * 20)}\n", []),
    "a/wire.proto": ("// Which job.\nmessage Job {}\n", ["1: headless (Which)"]),
    "a/script.py": (
        "#!/usr/bin/env python3\n# Those of a run.\nparser.add_argument('--n', help={})\n".format('"whose number"'),
        ["2: headless (Those)", "2: wh (Those)", "3: headless (whose)", "3: wh (whose)"],
    ),
    "a/script.sh": ("#!/bin/sh\n# Also runs.\ntrue\n", ["2: headless (Also)"]),
    "CMakeLists.txt": ("# From here on.\n", ["1: headless (From)"]),
    "README.md": (
        "# What it is\n\nOf all programs the best, whatever it does.\n\n```\nwhat\n```\n| what |\n- tells of jobs\n",
        ["3: wh (whatever)", "9: private (tells of -> reports)"],
    ),
    "a/table.cc": (
        'SettingSpec Flag(std::string_view key, std::string_view standard, std::string_view doc) {\n  return {.doc = doc};\n}\n'
        'auto add = [&](std::string_view key, std::string_view doc) {};\n'
        'SettingSpec a = {.key = "a", .doc = "width of "\n                "a wall"};\n'
        'SettingSpec b = Flag("b", "1, or 0", "Prints the walls first");\n'
        'SettingSpec c = Flag("c", F("x", 1), "The walls first");\n'
        'SettingSpec d = Flag("d", "1", "Print the walls first.");\n'
        'SettingSpec e = Flag("e", "1", "Print the walls first; 0: infill first");\n'
        'add("f", "Which wall");\n',
        [
            "5: setting (begins with width)",
            "7: setting (begins with Prints)",
            "8: setting (begins with The)",
            "9: setting (ends with a full stop)",
            "11: headless (Which)",
            "11: setting (begins with Which)",
        ],
    ),
    "a/flags.cc": (
        'app.add_option("--a", a, "Of jobs that "\n               "wait");\napp.add_flag("-q,--quiet", q, "Print nothing")->needs(a);\n'
        'auto* c = app.add_subcommand(\n    "c", "Show whatever is there");\nc->footer("Example:\\n  how it goes on");\n',
        ["1: headless (Of)", "5: wh (whatever)", "6: private (goes on -> continues)"],
    ),
    "corpus/README.md": ("What others wrote.\n", []),
}


def found_in(tree):
    """Returns the findings in a tree by path, each as "line: rule (detail)"."""
    found = collections.defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path, (text, _) in tree.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text)
        counts, lines = check_prose.check(root)
    assert sum(counts.values()) == len(lines), counts
    for line in lines:
        path, number, rest = line.split(":", 2)
        found[path].append(f"{number}:{rest[: rest.index('):') + 1]}")
    return counts, found


def main():
    counts, found = found_in(TREE)
    for path, (_, expected) in TREE.items():
        assert sorted(found[path]) == sorted(expected), f"{path}: {found[path]} instead of {expected}"
    assert set(counts) == set(check_prose.RULES) == set(check_prose.LIMITS), "a fault of each rule is planted, and each has a limit"
    limits = dict(counts)
    assert not check_prose.exceeded(counts, limits)
    for rule in limits:
        assert [line.split(":")[0] for line in check_prose.exceeded(counts, {**limits, rule: limits[rule] - 1})] == [rule]
    print(f"{sum(counts.values())} planted faults found, nothing else")


if __name__ == "__main__":
    main()
