#!/usr/bin/env python3
"""What supports a G-code file holds: `supports.py FILE` prints `support_mm3 layers`.

By the E values of beads whose `;TYPE:` begins with `Support material`; filament of 1.75 mm. `layers`: heights at which
such beads lie.
"""
import math
import re
import sys

FILAMENT_MM2 = math.pi / 4 * 1.75**2
WORD = re.compile(r'([XYZEF])(-?[0-9.]+)')


def measure(path):
    relative, at, z, in_support, used, heights = False, 0.0, 0.0, False, 0.0, set()
    with open(path, encoding='utf-8', errors='replace') as file:
        for line in file:
            if line.startswith(';TYPE:'):
                in_support = line.startswith(';TYPE:Support material')
            code = line.split(';', 1)[0]
            command = code.split(' ', 1)[0].strip()
            if command in ('M82', 'M83'):
                relative = command == 'M83'
            if command not in ('G0', 'G1', 'G2', 'G3', 'G92'):
                continue
            words = {name: float(value) for name, value in WORD.findall(code)}
            z = words.get('Z', z)
            if 'E' not in words:
                continue
            pushed = words['E'] if relative else words['E'] - at
            at = words['E']
            if command != 'G92' and in_support and pushed > 0 and ('X' in words or 'Y' in words):
                used += pushed
                heights.add(round(z, 3))
    return used * FILAMENT_MM2, len(heights)


if __name__ == '__main__':
    volume, layers = measure(sys.argv[1])
    print(f'{volume:.0f} {layers}')
