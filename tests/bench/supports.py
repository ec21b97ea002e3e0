#!/usr/bin/env python3
"""Measures the supports of a G-code file, and writes a plate for viewing.

`supports.py FILE` prints `support_mm3 layers`. The volume is computed from the E values of beads whose `;TYPE:` begins
with `Support material`, for filament of 1.75 mm. `layers`: number of heights with such beads.

`supports.py cones` prints an STL of upside-down cones on feet of 4 mm. Their sides rise by 20 to 80 degrees from the
horizontal.
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


def cones(corners=180):
    """Returns the facets of a row of cones, each 6 mm high."""
    facets, x = [], 0.0
    for degrees in range(20, 81, 10):
        spread = 6 / math.tan(math.radians(degrees))
        x += spread + 4
        rings = [[(x + r * math.cos(2 * math.pi * k / corners), r * math.sin(2 * math.pi * k / corners), z) for k in range(corners)]
                 for r, z in ((2, 0), (2, 1), (2 + spread, 7))]
        for low, high in zip(rings, rings[1:]):
            for k in range(corners):
                n = (k + 1) % corners
                facets += [(low[k], low[n], high[n]), (low[k], high[n], high[k])]
        for k in range(1, corners - 1):
            facets += [(rings[0][0], rings[0][k + 1], rings[0][k]), (rings[-1][0], rings[-1][k], rings[-1][k + 1])]
        x += spread + 4
    return facets


def print_stl(facets):
    print('solid cones')
    for facet in facets:
        print('facet normal 0 0 0\nouter loop')
        for corner in facet:
            print('vertex {:.6f} {:.6f} {:.6f}'.format(*corner))
        print('endloop\nendfacet')
    print('endsolid cones')


if __name__ == '__main__':
    if sys.argv[1] == 'cones':
        print_stl(cones())
        sys.exit()
    volume, layers = measure(sys.argv[1])
    print(f'{volume:.0f} {layers}')
