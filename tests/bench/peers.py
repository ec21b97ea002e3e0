"""Times two slicers alternately on the same models; see peers.sh."""
import argparse
import math
import os
import pathlib
import re
import statistics
import sys
import tempfile

WORD = re.compile(r"([XYZEF])(-?[\d.]+)")


def lengths_mm(gcode):
    """Returns the lengths of extruding and of travel moves of a G-code file, in the XY plane."""
    x = y = e = 0.0
    relative_e = False
    path = travel = 0.0
    for line in gcode.open(errors="replace"):
        code = line.split(";", 1)[0]
        head = code[:4].split(" ", 1)[0].strip()
        if head in ("M82", "M83"):
            relative_e = head == "M83"
        elif head == "G92":
            e = float(dict(WORD.findall(code)).get("E", e))
        elif head in ("G0", "G1"):
            words = dict(WORD.findall(code))
            nx, ny = float(words.get("X", x)), float(words.get("Y", y))
            step = math.hypot(nx - x, ny - y)
            de = 0.0
            if "E" in words:
                de = float(words["E"]) if relative_e else float(words["E"]) - e
                e = 0.0 if relative_e else float(words["E"])
            if de > 0:
                path += step
            else:
                travel += step
            x, y = nx, ny
    return path, travel


def run(command):
    """Returns wall seconds, CPU seconds and peak memory in MB of one whole process; None if it failed."""
    start = os.times().elapsed
    pid = os.fork()
    if pid == 0:
        null = os.open(os.devnull, os.O_RDWR)
        for fd in (0, 1, 2):
            os.dup2(null, fd)
        os.execvp(command[0], command)
    _, status, usage = os.wait4(pid, 0)
    wall = os.times().elapsed - start
    if status != 0:
        return None
    return {"wall_s": wall, "cpu_s": usage.ru_utime + usage.ru_stime, "rss_mb": usage.ru_maxrss / 1024}


def measure(model, args, folder):
    ours, peers = folder / "ours.gcode", folder / "peers.gcode"
    commands = [
        (ours, [args.slicefarm, "slice", str(model), "-o", str(ours), "--config", args.config]),
        (peers, ["prusa-slicer", "--export-gcode", "--load", args.config, "--center", "125,105", "-o", str(peers), str(model)]),
    ]
    runs = [[], []]
    for _ in range(args.runs):
        for i, (_, command) in enumerate(commands):
            runs[i].append(run(command))
    figures = []
    for i, (gcode, _) in enumerate(commands):
        if any(r is None for r in runs[i]) or not gcode.exists():
            figures.append(None)
            continue
        figure = {key: statistics.median(r[key] for r in runs[i]) for key in runs[i][0]}
        figure["path_mm"], figure["travel_mm"] = lengths_mm(gcode)
        figures.append(figure)
    return figures


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--config", required=True)
    parser.add_argument("--slicefarm", required=True)
    parser.add_argument("models", nargs="+", type=pathlib.Path)
    args = parser.parse_args()
    failed = False
    for model in args.models:
        with tempfile.TemporaryDirectory() as folder:
            ours, peer = measure(model, args, pathlib.Path(folder))
        failed |= ours is None
        for key in ("wall_s", "cpu_s", "rss_mb", "path_mm", "travel_mm"):
            a = f"{ours[key]:.3f}" if ours else "failed"
            b = f"{peer[key]:.3f}" if peer else "failed"
            ratio = f"{ours[key] / peer[key]:.3f}" if ours and peer else "-"
            print(model.stem, key, a, b, ratio, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
