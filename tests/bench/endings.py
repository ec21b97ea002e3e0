#!/usr/bin/env python3
"""Measures how long `slicefarm slice` takes to end, by itself and after a signal.

    tests/bench/endings.py build/bin/slicefarm [--signals N] MODEL... [-- OPTION...]

For each model, the script measures the wall and CPU seconds of a whole run. Then it makes N runs (20) that receive
SIGTERM at times spread evenly over the whole run. It prints the longest and the mean time from the signal to the end,
the exit codes (7: cancelled; 0: finished before the signal), and the files that cancelled runs left behind. Models with
deep paint: shuttle_5.5_bushings_with_supports.3mf of DraftShift/StealthChanger (290,000 painted triangles) and
DragonBurner_EBB36_OrbiterV2_mounts V1.0.3mf (62,000).
"""
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time


def command(binary, model, output, options):
    return [binary, "slice", model, "-o", output, "--quiet", *options]


def whole_run(binary, model, options):
    """Returns the wall seconds, CPU seconds and exit code of a whole run."""
    with tempfile.TemporaryDirectory() as folder:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        start = time.monotonic()
        code = subprocess.run(command(binary, model, folder + "/out.gcode", options), stderr=subprocess.DEVNULL).returncode
        wall = time.monotonic() - start
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, code


def ended_run(binary, model, options, after_s):
    """Returns the seconds from the signal to the end, the exit code, and the files left behind."""
    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen(command(binary, model, folder + "/out.gcode", options), stderr=subprocess.DEVNULL)
        time.sleep(after_s)
        start = time.monotonic()
        process.send_signal(signal.SIGTERM)
        code = process.wait()
        return time.monotonic() - start, code, os.listdir(folder)


def main():
    arguments = sys.argv[1:]
    options = []
    if "--" in arguments:
        at = arguments.index("--")
        arguments, options = arguments[:at], arguments[at + 1:]
    signals = 20
    if "--signals" in arguments:
        at = arguments.index("--signals")
        signals = int(arguments[at + 1])
        del arguments[at:at + 2]
    if len(arguments) < 2:
        sys.exit(__doc__)
    binary, models = arguments[0], arguments[1:]
    print("model\twall_s\tcpu_s\tcode\tend_max_s\tend_mean_s\tcodes\tleft")
    for model in models:
        wall, cpu, code = whole_run(binary, model, options)
        times, codes, left = [], {}, set()
        for i in range(signals):
            seconds, ended, files = ended_run(binary, model, options, wall * (i + 0.5) / signals)
            times.append(seconds)
            codes[ended] = codes.get(ended, 0) + 1
            if ended != 0:
                left.update(files)
        said = " ".join(f"{key}:{count}" for key, count in sorted(codes.items()))
        print(f"{os.path.basename(model)}\t{wall:.2f}\t{cpu:.2f}\t{code}\t{max(times):.2f}\t{sum(times) / signals:.2f}\t{said}\t"
              f"{' '.join(sorted(left)) or '-'}")


if __name__ == "__main__":
    main()
