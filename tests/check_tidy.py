#!/usr/bin/env python3
"""Fails if clang-tidy finds a fault in a C++ file that was changed. The checks are in .clang-tidy.

usage: check_tidy.py [repo root] [--since COMMIT] [--build DIR] [--minutes M]       exit 1 and the findings

--since: files that differ from this commit, committed or not (HEAD~1). A changed header is checked with its .cc file.
--build: folder with generated headers (build).
--minutes: no check of a further file begins after this time (5); the remaining files are printed.
After a change of more than 60 files, such as a new name, nothing is checked.
Cost: about 15 s of CPU per file, on all cores.
"""
import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import time

FOLDERS = ("common/", "processes/", "services/", "tests/")
MOST_FILES = 60
SYSTEM = ("/usr/include/eigen3", "/usr/include/cairo", "/usr/include/suitesparse")


def changed(root, since):
    """Returns the changed C++ files of the repository; None if the commit does not exist, as in a shallow clone."""
    if subprocess.run(["git", "rev-parse", "--verify", "--quiet", f"{since}^{{commit}}"], cwd=root, capture_output=True).returncode:
        return None
    names = subprocess.run(["git", "diff", "--name-only", "--diff-filter=d", since], cwd=root, capture_output=True, text=True, check=True)
    return [name for name in names.stdout.splitlines()
            if name.startswith(FOLDERS) and name.endswith((".h", ".cc")) and "/corpus/" not in name]


def units(root, names):
    """Returns the files to compile, in order: changed .cc files, and the .cc files of changed headers."""
    sources = {name if name.endswith(".cc") else name[:-2] + ".cc" for name in names}
    return sorted(name for name in sources if (root / name).exists())


def findings(root, build, names, source):
    """Returns the messages of clang-tidy about the changed files in one translation unit."""
    headers = "|".join(name.replace(".", r"\.") for name in names if name.endswith(".h"))
    call = ["clang-tidy", "--quiet", f"--header-filter=({headers})$" if headers else "--header-filter=^$", source, "--", "-std=c++20",
            f"-I{root}", f"-I{build}", f"-I{build}/proto", *(f"-isystem{folder}" for folder in SYSTEM), "-DFMT_SHARED",
            f'-DSLICEFARM_CORPUS="{root}/tests/corpus"', f'-DSLICEFARM_SOURCE="{root}"', '-DSLICEFARM_PROGRAM=""',
            '-DSLICEFARM_BIN=""']
    run = subprocess.run(call, cwd=root, capture_output=True, text=True, check=False)
    return run.stdout.strip() if ": error:" in run.stdout or ": warning:" in run.stdout else ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", nargs="?", type=pathlib.Path, default=pathlib.Path(__file__).parent.parent)
    parser.add_argument("--since", default="HEAD~1")
    parser.add_argument("--build", type=pathlib.Path)
    parser.add_argument("--minutes", type=float, default=5)
    options = parser.parse_args()
    root = options.root.resolve()
    build = (options.build or root / "build").resolve()
    names = changed(root, options.since)
    if names is None:
        print(f"there is no commit {options.since}: no file was checked")
        return 0
    until, found, left_out = time.monotonic() + 60 * options.minutes, [], []
    sources = units(root, names)
    if len(sources) > MOST_FILES:
        print(f"{len(sources)} files were changed at once: no file was checked")
        return 0

    def check(source):
        if time.monotonic() >= until:
            left_out.append(source)
            return
        found.append(findings(root, build, names, source))

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(check, sources))
    for text in filter(None, found):
        print(text)
    for source in sorted(left_out):
        print("no time for", source)
    print(f"{len(sources) - len(left_out)} changed files checked, {len([text for text in found if text])} with findings")
    return 1 if any(found) else 0


if __name__ == "__main__":
    sys.exit(main())
