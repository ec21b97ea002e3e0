#!/usr/bin/env python3
"""Tests the verdict of deploy/test.sh: each step that fails makes the command fail, also a test that passes the second time.

The script runs in a small tree. Each program that it calls there is a script that fails if the variable FAILS names it.
"""
import os
import pathlib
import shutil
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).parent.parent
# Checks that need no build.
CHECKS = sorted({path.stem.removeprefix("check_") for path in (ROOT / "tests").glob("check_*.py") if not path.stem.endswith("_test")} - {"tidy"})
# Fails if the variable FAILS names it, or names it with the number of the call, such as `ctest1`.
STEP = """#!/usr/bin/env bash
name=$(basename "$0"); count=$(($(cat "$TREE/$name.calls" 2>/dev/null || echo 0) + 1)); echo $count > "$TREE/$name.calls"
[[ " $FAILS " != *" $name "* && " $FAILS " != *" $name$count "* ]]
"""
PYTHON_STEP = """import os, pathlib, sys
sys.exit(pathlib.Path(__file__).stem in os.environ["FAILS"].split())
"""
# (name of the case, steps that fail, does the command pass)
CASES = [
    ("nothing fails", "", True),
    ("a test fails twice", "ctest", False),
    ("a test fails once and passes the second time", "ctest1", False),
    ("the build fails", "cmake", False),
    ("no packages", "setup.sh", False),
    ("clang-tidy", "check_tidy", False),
    ("the slow tests of the day", "rotation", False),
    ("the page of the API", "make_api.py", False),
    *[(f"check of {check}", f"check_{check}", False) for check in CHECKS],
]


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


def plant(tree):
    """Writes the two scripts and a step for each program that they call."""
    for script in ("deploy/test.sh", "tests/checks.sh"):
        (tree / script).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / script, tree / script)
    for step in ("deploy/setup.sh", "docs/make_api.py", "bin/cmake", "bin/ctest"):
        write(tree / step, STEP)
    for check in (*(f"check_{check}" for check in CHECKS), "check_tidy", "rotation"):
        write(tree / "tests" / f"{check}.py", PYTHON_STEP)
    write(tree / "build/Testing/Temporary/LastTest.log", "[  FAILED  ] Planted.Test\n")


def main():
    for name, fails, passes in CASES:
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder)
            plant(tree)
            env = os.environ | {"PATH": f"{tree}/bin:{os.environ['PATH']}", "TREE": str(tree), "FAILS": fails}
            run = subprocess.run([tree / "deploy/test.sh"], env=env, capture_output=True, text=True, check=False)
            assert (run.returncode == 0) == passes, f"{name}: exit {run.returncode}\n{run.stdout}{run.stderr}"
            assert (tree / "ctest.calls").exists() or not passes, f"{name}: no test ran"
            if "ctest" in fails:
                assert "Planted.Test" in run.stderr, f"{name}: the failed test is not named\n{run.stderr}"
    print(f"{len(CASES)} verdicts as expected")


if __name__ == "__main__":
    main()
