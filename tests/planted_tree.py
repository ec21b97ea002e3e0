"""Runs a check on a small tree in which violations are planted, for the tests of checks."""
import pathlib
import subprocess
import sys
import tempfile


def told_of(check, tree):
    """Returns the output lines of the check, which must fail, for a tree: one line per violation. `tree`: path to
    (text, ...).
    """
    with tempfile.TemporaryDirectory() as root:
        for path, (text, *_) in tree.items():
            file = pathlib.Path(root, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        run = subprocess.run([sys.executable, check, root], capture_output=True, text=True)
    assert run.returncode == 1, run
    return run.stdout.splitlines()
