#!/usr/bin/env python3
"""check_tidy.py must find a fault in a changed file, and none in files that were not changed."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

TESTS = pathlib.Path(__file__).parent
FAULT = """#include <string>
#include <utility>
inline std::string {name}(std::string text) {{
  std::string other = std::move(text);
  return other + text;
}}
"""


def git(root, *words):
    subprocess.run(["git", "-c", "user.name=t", "-c", "user.email=t@localhost", *words], cwd=root, check=True, capture_output=True)


def check(root, since="HEAD~1"):
    run = subprocess.run([sys.executable, TESTS / "check_tidy.py", root, "--since", since], capture_output=True, text=True)
    return run.returncode, run.stdout


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        shutil.copy(TESTS.parent / ".clang-tidy", root)
        (root / "common").mkdir()
        (root / "common/old.cc").write_text(FAULT.format(name="Old"))
        (root / "common/sound.cc").write_text("int Sound() { return 1; }\n")
        git(root, "init", "-q")
        git(root, "add", ".")
        git(root, "commit", "-qm", "first")
        assert check(root) == (0, "there is no commit HEAD~1: no file was checked\n")
        (root / "common/sound.cc").write_text("int Sound() { return 2; }\n")
        git(root, "commit", "-qam", "second")
        assert check(root) == (0, "1 changed files checked, 0 with findings\n"), check(root)
        (root / "common/new.h").write_text(FAULT.format(name="New"))
        (root / "common/new.cc").write_text('#include "common/new.h"\n')
        git(root, "add", ".")
        code, said = check(root)
        assert code == 1 and "common/new.h:5" in said and "bugprone-use-after-move" in said and "old.cc" not in said, said
    print("the planted fault was found, nothing else")


if __name__ == "__main__":
    main()
