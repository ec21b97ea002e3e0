#!/usr/bin/env python3
"""Exhausts a resource of a farm: `key value limit` rows. A value must not exceed its limit (`-`: a value for comparison).
The exit code is 1 if a limit is exceeded.

  tests/load/exhaust.py [request] [memory] [tenant] [disk] [rows] [texts]   without arguments: all

Each word is a module beside this file, exhaust_WORD.py. Its measure() yields the rows, and its docstring describes it.
"""
import argparse
import importlib
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]


def words():
    return sorted(path.stem.removeprefix("exhaust_") for path in HERE.glob("exhaust_*.py"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="WORD", help=", ".join(words()))
    options = parser.parse_args()
    unknown = set(options.words) - set(words())
    if unknown:
        parser.error(f"there is no {', '.join(sorted(unknown))}; there are {', '.join(words())}")
    exceeded = False
    for word in options.words or words():
        for key, value, limit in importlib.import_module(f"exhaust_{word}").measure():
            print(key, f"{value:.6g}", "-" if limit is None else f"{limit:.6g}", flush=True)
            exceeded |= limit is not None and value > limit
    sys.exit(exceeded)


if __name__ == "__main__":
    main()
