#!/usr/bin/env python3
"""Tests that check_format.py finds a file that is not formatted, and nothing else."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).with_name("check_format.py")
STYLE = pathlib.Path(__file__).parent.parent / ".clang-format"
TREE = {
    "common/a/good.h": "#pragma once\n\nint Area(int width, int height);\n",
    "common/a/wide.cc": "int  Area(int width,int height) { return width*height; }\n",
    "services/b/good.cc": "int Twice(int value) { return 2 * value; }\n",
    "tests/corpus/raw.h": "int   unformatted( );\n",
}


def run(root, *flags):
    return subprocess.run([sys.executable, CHECK, root, *flags], capture_output=True, text=True, check=False)


def main():
    with tempfile.TemporaryDirectory() as root:
        shutil.copy(STYLE, root)
        for path, text in TREE.items():
            file = pathlib.Path(root, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        found = run(root)
        assert found.returncode == 1 and found.stdout.splitlines() == [
            "common/a/wide.cc: not formatted (tests/check_format.py --fix)"
        ], found
        assert run(root, "--fix").returncode == 0
        assert run(root).returncode == 0
    print("1 planted file found and formatted, nothing else")


if __name__ == "__main__":
    main()
