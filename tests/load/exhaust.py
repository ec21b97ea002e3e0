#!/usr/bin/env python3
"""A farm on which something runs out: `key value limit` rows, where a limit is what must not be exceeded (`-`: a figure to
compare with). Ends with 1 if one is.

  tests/load/exhaust.py [request] [memory] [tenant] [disk] [rows] [texts]   without: all

Each word is a module of its own beside this file, exhaust_WORD.py, whose measure(farms) yields the rows; its first lines say
what it does.
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
