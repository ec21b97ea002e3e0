#!/usr/bin/env python3
"""Compares tours of TSPLIB instances with the optimum, for every initial tour and every search depth.

usage: tours.py SLICEFARM FILE.tsp...      rows: name, then percent above the optimum (of an instance that is not in the
                                           table below: above the lower bound, marked *)
"""
import pathlib
import subprocess
import sys

OPTIMA = {
    "a280": 2579, "att48": 10628, "att532": 27686, "berlin52": 7542, "bier127": 118282, "ch130": 6110, "ch150": 6528,
    "d1291": 50801, "d493": 35002, "eil101": 629, "eil51": 426, "eil76": 538, "fnl4461": 182566, "gil262": 2378,
    "kroA100": 21282, "kroA150": 26524, "kroA200": 29368, "lin105": 14379, "lin318": 42029, "linhp318": 41345 + 3869,
    "pcb442": 50778, "pr1002": 259045, "pr2392": 378032, "pr76": 108159, "rat783": 8806, "rd100": 7910, "rd400": 15281,
    "st70": 675, "u574": 36905, "u724": 41910, "vm1084": 239297,
}
WAYS = {
    "nearest": ["--start", "nearest", "--moves", "none", "--local"],
    "greedy": ["--start", "greedy", "--moves", "none", "--local"],
    "insertion": ["--start", "insertion", "--moves", "none", "--local"],
    "christofides": ["--start", "christofides", "--moves", "none", "--local"],
    "2opt+oropt": ["--moves", "2opt", "--local"],
    "3opt": ["--moves", "3opt", "--local"],
    "chains": ["--moves", "chains", "--local"],
    "exchanges": [],
}


def seconds_for(nodes):
    return 1 if nodes <= 200 else 2 if nodes <= 1002 else 5


def solve(program, path, nodes, way):
    command = [program, "tsp", path, "--seed", "1", "--seconds", str(seconds_for(nodes))] + way
    out = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return dict(line.split(None, 1) for line in out.splitlines())


def main():
    program, files = sys.argv[1], sys.argv[2:]
    print("| instance |", " | ".join(WAYS), "| bound | seconds |")
    print("|---|" + "---|" * (len(WAYS) + 2))
    for path in files:
        name = pathlib.Path(path).stem
        nodes = int(solve(program, path, 1, WAYS["greedy"])["n"])
        rows = {way: solve(program, path, nodes, options) for way, options in WAYS.items()}
        last = rows["exchanges"]
        known = name in OPTIMA
        best = OPTIMA[name] if known else int(last["lower_bound"])
        above = [f"{100 * (int(row['length']) / best - 1):.2f}" for row in rows.values()]
        bound = f"{100 * (int(last['lower_bound']) / best - 1):.2f}"
        print("|", name + ("" if known else "*"), "|", " | ".join(above + [bound, last["seconds"]]), "|", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
