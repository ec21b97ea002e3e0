#!/usr/bin/env python3
"""Tests that the G-code does not depend on libm. Slices the corpus on this machine unchanged, and again
- with FMA and AVX2 hidden from libm, which then selects other variants of its functions, as on another CPU;
- with a libm that is wrong from the fourth digit on (rough_libm.cc), which also reveals uses that rarely differ between
  CPUs.

usage: portable_bytes_test.py SLICEFARM MODELS ROUGH_LIBM
"""
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile

MASK = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"
SETTINGS = [  # each entry is one run of every model
    [],
    ["--set", "perimeter_generator=classic", "--set", "fill_pattern=grid", "--set", "fill_angle=33.3"],
    ["--rotate", "10,20,30"],
]
# Python's functions are libm's, so a change here would also have changed the program.
LIBM = """
import math, random, struct
random.seed(1)
bits = 0
for _ in range(100000):
    x = random.uniform(0, 3)
    for y in math.sin(x), math.tan(x), math.atan2(x, 1.3), math.exp(x):
        bits = hash((bits, struct.pack("d", y)))
print(bits)
"""


def environments(rough_libm):
    plain = dict(os.environ, PYTHONHASHSEED="0")
    plain.pop("GLIBC_TUNABLES", None)
    return plain, {"another CPU": dict(plain, GLIBC_TUNABLES=MASK), "a rough libm": dict(plain, LD_PRELOAD=rough_libm)}


def libm_digest(environment):
    return subprocess.check_output([sys.executable, "-c", LIBM], env=environment)


def gcode_digest(program, model, settings, environment, folder):
    output = pathlib.Path(folder, "out.gcode")
    subprocess.run([program, "slice", model, "-o", output, "-q", *settings], env=environment, check=True,
                   stderr=subprocess.DEVNULL)
    return hashlib.sha256(output.read_bytes()).hexdigest()


def main():
    program, models, rough_libm = sys.argv[1], sorted(pathlib.Path(sys.argv[2]).glob("*.stl")), sys.argv[3]
    plain, others = environments(rough_libm)
    for name in list(others):
        if libm_digest(others[name]) == libm_digest(plain):
            assert name == "another CPU", f"{name} changes nothing"
            print("hiding FMA and AVX2 from libm changes nothing on this machine: left out")
            del others[name]
    assert models, "no models"
    differ = []
    with tempfile.TemporaryDirectory() as folder:
        for settings in SETTINGS:
            for model in models:
                want = gcode_digest(program, model, settings, plain, folder)
                for name, environment in others.items():
                    if gcode_digest(program, model, settings, environment, folder) != want:
                        differ.append(" ".join([name + ":", model.name, *settings]))
    assert not differ, "G-code depends on libm:\n" + "\n".join(differ)
    print(f"{len(models) * len(SETTINGS)} programs, the same bytes with {' and '.join(others)}")


if __name__ == "__main__":
    main()
