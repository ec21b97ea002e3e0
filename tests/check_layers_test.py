#!/usr/bin/env python3
"""Tests that check_layers.py finds the violations planted in a small tree, and nothing else."""
import pathlib

from planted_tree import told_of

CHECK = pathlib.Path(__file__).with_name("check_layers.py")
OWN = '#include "%s"\n'
# path: (text, words that must appear in the violations of that file)
TREE = {
    "common/geometry/turn.h": ("double Turn(double sin, double cos);  // sin(a), std::cos(a)\n", []),
    "common/geometry/turn.cc": ("double f(double a) { return std::sin(a); }\n", ["sin of libm"]),
    "common/geometry/turn_test.cc": ("double g = std::tan(1.0);\n", []),
    "common/geometry/root.cc": ("double r = std::sqrt(2) + x.log() + std::fmod(3, 2) + Sin(1) + my_exp(2);\n", []),
    "common/geometry/root_test.cc": ("", []),
    "common/base/power.cc": ("double p = ::pow(2, 3);\n", ["pow of libm"]),
    "common/model/arc.cc": ("double a = atan2(1, 2);\n", ["atan2 of libm"]),
    "common/config/log.cc": ("auto f = std::log10;\n", ["log10 of libm"]),
    "common/stage/far.h": ("inline float h = hypotf (3, 4);\n", ["hypot of libm"]),
    "services/beading/algo/bead.cc": ("double e = std::exp(1.0);\n", ["exp of libm"]),
    "services/beading/algo/bead_test.cc": ("", []),
    "services/cli/drawing.cc": ("double e = std::pow(10, 1);\n", []),
    "services/cli/console/print.h": ("", []),
    "services/cli/console/up.h": (OWN % "services/cli/drawing.h", ["console must not include cli"]),
    "services/cli/drawing.h": (OWN % "services/lab/beads.h", ["cli must not include lab"]),
    "services/lab/beads.h": (OWN % "services/cli/console/print.h" + OWN % "services/beading/algo/bead.h", []),
    "services/lab/measure.h": (OWN % "tests/support/memory_store.h", ["must not include tests/"]),
    "services/lab/measure_test.cc": (OWN % "tests/support/memory_store.h", []),
    "services/lab/draw.h": (OWN % "services/cli/drawing.h", ["lab must not include cli"]),
    "common/geometry/up.h": (OWN % "common/model/arc.h", ["geometry must not include model"]),
    "common/model/wire.h": (OWN % "slicefarm/v1/layer.pb.h", ["model must not include slicefarm"]),
    "common/geometry/lonely.cc": ("", ["no lonely_test.cc beside it"]),
    "common/geometry/loud.h": ("inline void f() { printf(0); }\n", ["printf in pure code"]),
    "common/elsewhere/a.h": ("", ["in no known layer"]),
    "services/infill/algo/other.h": (OWN % "services/beading/algo/bead.h", ["must not include service beading"]),
    "services/infill/algo/clip.h": ("#include <clipper.hpp>\n", ["Clipper is private"]),
    "services/infill/algo/from.h": (OWN % "a_test.h", ["only a file named"]),
    "common/geometry/once.h": ("auto e = std::ranges::unique(v); auto s = std::ranges::sort(v); std::unique(a, b);\n", ["std::ranges::unique"]),
    "common/model/view.h": ("auto e = std::views::reverse(v);\n", ["std::views::reverse"]),
    "common/geometry/once_test.cc": ("auto e = std::ranges::rotate(v);\n", []),
    "common/base/own_test.cc": ("namespace slicefarm::own_test {\nTEST(Own, A) {}\n}\n", []),
    "common/base/shared_test.cc": ("namespace slicefarm {\nTEST(Shared, A) {}\n}\n", ["no namespace of its own"]),
    "common/base/fixture_test.cc": ("namespace slicefarm::other {\nTEST_P(Fixture, A) {}\n}\n", ["no namespace of its own"]),
    "common/base/helper_test.cc": ("namespace slicefarm {\nint Help() { return 1; }\n}\n", []),
    "processes/fdm/task/chain.h": (OWN % "common/stage/far.h", []),
    "processes/fdm/job/job.h": (OWN % "services/coordinator/algo/plan.h", []),
    "processes/fdm/job/stage.h": (OWN % "services/infill/algo/other.h", ["must not include service infill"]),
    "processes/fdm/job/mine.h": (OWN % "processes/laser/job/theirs.h", ["only the list of processes may include", "names a process"]),
    "processes/fdm/settings/words.h": ("// as lasers do\n", ["names a process"]),
    "processes/laser/settings/words.h": ("// as lasers do\n", []),
    "processes/list/jobs.h": (OWN % "processes/fdm/job/job.h" + OWN % "processes/laser/job/theirs.h", []),
    "services/coordinator/algo/plan.h": ("// not of a laser\n", ["names a process"]),
    "services/coordinator/algo/ask_test.cc": (OWN % "processes/fdm/task/chain.h", []),
    "services/coordinator/server/ask.h": (OWN % "processes/list/jobs.h", []),
    "services/coordinator/server/name.h": (OWN % "processes/fdm/job/job.h", ["only the list of processes may include"]),
    "services/coordinator/algo/up.h": (OWN % "processes/list/jobs.h", ["algo must not include job"]),
    "common/model/way.h": ("struct Way {\n  double x = 0;\n  double y = 0;\n  Way operator-(Way o) const { return {x - o.x, y - o.y}; }\n};\n", ["vector of its own"]),
    "common/model/weighed.h": ("struct Weighed {\n  double x = 0, y = 0;\n  double weight = 1;\n};\n", []),
    "services/infill/algo/long.h": ("\n" * 501, ["501 lines, at most 500"]),
}


def main():
    said = told_of(CHECK, TREE)
    left = list(said)
    for path, (_, violations) in TREE.items():
        for words in violations:
            found = [line for line in left if line.startswith(path + ":") and words in line]
            assert len(found) == 1, f"{path}: {words!r} is told {len(found)} times in\n" + "\n".join(said)
            left.remove(found[0])
    assert not left, "told without reason:\n" + "\n".join(left)
    print(f"{sum(len(v) for _, v in TREE.values())} planted violations found, nothing else")


if __name__ == "__main__":
    main()
