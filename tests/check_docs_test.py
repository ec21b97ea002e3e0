#!/usr/bin/env python3
"""check_docs.py must find each planted violation in a small tree, and nothing else."""
import pathlib

from planted_tree import told_of

CHECK = pathlib.Path(__file__).with_name("check_docs.py")
TREE = {
    "CMakeLists.txt": ("project(farm VERSION 1.2.0 LANGUAGES CXX)\n",),
    "CHANGELOG.md": ("# Changelog\n\n## 1.1.0\n",),
    "common/base/error.cc": ('{Reason::kLate, "LATE"}\n{Reason::kEarly, "EARLY"}\n',),
    "proto/slicefarm/v1/error_reason.proto": ("  LATE = 1;\n  EARLY = 2;\n",),
    "proto/slicefarm/v1/README.md": ("| LATE | CODE | never |\n| EARLY | CODE | never |\n| ODD | CODE | never |\n",),
    "docs/users/troubleshooting.md": ("# Help\n\n### LATE\n\nSee [the guide](../guide.md#two-words) and [a gap](#nothing).\n",),
    "docs/guide.md": ("# Two words\n\nFiles: common/base/error, common/base/{error,fault}.cc, `services/<name>/README.md`, common/gone/.\n"
                      "[a page](missing.md) [a site](https://example.org/docs/none)\n",),
    "services/coordinator/README.md": ("# Clock\n",),
    "deploy/monitoring/alerts.yml": ("      - alert: Down\n      - alert: Slow\n",),
    "docs/users/alerts.md": ("| alert | step |\n|---|---|\n| `Down` | start |\n| `Gone` | look |\n",),
    "docs/reliability.md": ("| a promise | `Clock.Ticks`, `.Stops` |\n",),
    "services/coordinator/clock_test.cc": ("TEST(Clock, Ticks) { Reason::kLate; }\n",),
}
EXPECTED = [
    "CHANGELOG.md begins with 1.1.0, CMakeLists.txt has 1.2.0",
    "EARLY is not in docs/users/troubleshooting.md",
    "Gone of docs/users/alerts.md is no alert",
    "ODD of the README's table is no reason",
    "alert Slow is not in docs/users/alerts.md",
    "docs/guide.md: the link missing.md has no file",
    "docs/guide.md:3: there is no common/base/fault.cc",
    "docs/guide.md:3: there is no common/gone/",
    "docs/reliability.md: there is no test Clock.Stops",
    "docs/users/troubleshooting.md: the link #nothing has no heading",
    "no test looks for EARLY",
]


def main():
    said = sorted(told_of(CHECK, TREE))
    assert said == EXPECTED, "\n".join(said)
    print(f"{len(said)} planted violations found, nothing else")


if __name__ == "__main__":
    main()
