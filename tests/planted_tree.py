"""For tests of checks: a check of a small tree in which violations are planted."""
import pathlib
import subprocess
import sys
import tempfile


def told_of(check, tree):
    """What the check, which must fail, says of a tree: a line for each violation. `tree`: path to (text, ...)."""
    with tempfile.TemporaryDirectory() as root:
        for path, (text, *_) in tree.items():
            file = pathlib.Path(root, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        run = subprocess.run([sys.executable, check, root], capture_output=True, text=True)
    assert run.returncode == 1, run
    return run.stdout.splitlines()
