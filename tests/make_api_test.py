#!/usr/bin/python3
"""docs/make_api.py --check must accept the page that the script wrote, and refuse it after a comment, a field or an error changed."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CHANGES = [  # file, text, replacement
    ("proto/slicefarm/v1/jobs.proto", "// Cancels jobs independently", "// Stops jobs independently"),
    ("proto/slicefarm/v1/jobs.proto", "bool validate_only = 6;", "bool validate_only = 60;"),
    ("proto/slicefarm/v1/README.md", "no layer has an outline", "every layer is empty"),
    ("docs/api.md", "# API of slicefarm", "# API"),
]


def run(root, *arguments):
    return subprocess.run([sys.executable, root / "docs/make_api.py", *arguments], capture_output=True, text=True)


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        shutil.copytree(ROOT / "proto", root / "proto")
        shutil.copytree(ROOT / "docs", root / "docs")
        (root / "docs/api.md").unlink()
        assert run(root, "--check").returncode == 1, "a missing page was accepted"
        assert run(root).returncode == 0
        assert run(root, "--check").returncode == 0, "the written page was refused"
        for path, text, other in CHANGES:
            file = root / path
            before = file.read_text()
            assert text in before, f"{path} has no text {text!r}"
            file.write_text(before.replace(text, other, 1))
            answer = run(root, "--check")
            assert answer.returncode == 1 and "not up to date" in answer.stdout, f"{path}: {other!r} was accepted"
            file.write_text(before)
    print(f"{len(CHANGES)} planted changes found")


if __name__ == "__main__":
    main()
