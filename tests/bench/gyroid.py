#!/usr/bin/env python3
"""Writes a lattice of gyroid cells in a cube as a binary STL, for scans with many small islands.

usage: gyroid.py OUT.stl [SIDE_MM [CELLS [STEPS [WALL]]]]

The walls are the points with |sin x cos y + sin y cos z + sin z cos x| < WALL / 2, cut off at the cube's faces.
Marching tetrahedra over STEPS^3 cubes find their surface. The surface is closed: each edge belongs to two facets. The
defaults, 50 mm with 5 x 5 x 5 cells, give about 684,000 facets.
"""
import array
import math
import struct
import sys

# A cube as six tetrahedra around its diagonal; corner number = x + 2 y + 4 z.
TETRAHEDRA = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]


def field(side, cells, steps, wall):
    """Returns the coordinates and the values at (steps + 3)^3 points. Values < 0 are inside; the outermost points are
    outside.
    """
    k = 2 * math.pi * cells / side
    places = [i * side / steps for i in range(-1, steps + 2)]
    sines = [math.sin(k * p) for p in places]
    cosines = [math.cos(k * p) for p in places]
    beyond = [max(-p, p - side) * k + 1e-3 for p in places]
    n = len(places)
    values = array.array("d")
    for x in range(n):
        for y in range(n):
            a, b = sines[x] * cosines[y], max(beyond[x], beyond[y])
            for z in range(n):
                gyroid = a + sines[y] * cosines[z] + sines[z] * cosines[x]
                values.append(max(abs(gyroid) - wall / 2, b, beyond[z]))
    return places, values


def crossing(a, b):
    """Returns the zero crossing on the edge between two corners (value, x, y, z). The result does not depend on the
    order of the corners.
    """
    if b < a:
        a, b = b, a
    t = a[0] / (a[0] - b[0])
    return tuple(p + (q - p) * t for p, q in zip(a[1:], b[1:]))


def facing(facet, inside, outside):
    """Returns the facet, oriented so that its normal points from the inner corner to the outer corner."""
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = facet
    ux, uy, uz, vx, vy, vz = bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az
    way = ((uy * vz - uz * vy) * (outside[1] - inside[1]) +
           (uz * vx - ux * vz) * (outside[2] - inside[2]) +
           (ux * vy - uy * vx) * (outside[3] - inside[3]))
    return facet if way >= 0 else (facet[0], facet[2], facet[1])


def facets_of(corners):
    """Yields the facets of one tetrahedron with corners (value, x, y, z)."""
    inside = [c for c in corners if c[0] < 0]
    outside = [c for c in corners if c[0] >= 0]
    if len(inside) == 2:
        (p, q), (r, s) = inside, outside
        quad = [crossing(p, r), crossing(p, s), crossing(q, s), crossing(q, r)]
        found = [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    elif inside and outside:
        alone, others = (inside[0], outside) if len(inside) == 1 else (outside[0], inside)
        found = [tuple(crossing(alone, other) for other in others)]
    else:
        return
    for facet in found:
        yield facing(facet, inside[0], outside[0])


def facets(places, values):
    n = len(places)
    offsets = [(c & 1) * n * n + (c >> 1 & 1) * n + (c >> 2) for c in range(8)]
    for x in range(n - 1):
        for y in range(n - 1):
            row = (x * n + y) * n
            for z in range(n - 1):
                cube = [values[row + z + o] for o in offsets]
                if min(cube) >= 0 or max(cube) < 0:
                    continue
                corners = [(v, places[x + (c & 1)], places[y + (c >> 1 & 1)], places[z + (c >> 2)])
                           for c, v in enumerate(cube)]
                for tetrahedron in TETRAHEDRA:
                    yield from facets_of([corners[c] for c in tetrahedron])


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    side, cells, steps, wall = (float(a) for a in (sys.argv[2:] + ["50", "5", "53", "0.8"][len(sys.argv) - 2:]))
    count = 0
    with open(sys.argv[1], "wb") as out:
        out.write(b"\0" * 84)
        for facet in facets(*field(side, cells, int(steps), wall)):
            corners = [struct.pack("<3f", *corner) for corner in facet]
            if len(set(corners)) == 3:
                out.write(b"\0" * 12 + b"".join(corners) + b"\0\0")
                count += 1
        out.seek(80)
        out.write(struct.pack("<I", count))
    print(f"{sys.argv[1]}: {count} facets")


if __name__ == "__main__":
    main()
