#!/usr/bin/env python3
"""Writes parts for judging seams and measures the seams of a G-code file.

usage: seams.py part NAME        an STL on stdout: one of PARTS
       seams.py measure FILE     one row: loops jumps% step_mean step_p95 on_corner% overhanging% avoidable%

loops: closed outer walls above the first layer.
jumps: loops that start more than 1 mm from the nearest start in the layer below.
step: distance to this nearest start, over all loops.
on_corner: share of the loops with a corner that start at a corner. A corner turns by 15 degrees inwards or 30 degrees
outwards over half a millimetre on either side.
overhanging: starts that are more than 1.43 layer heights (55 degrees) outside the outer walls of the layer below.
avoidable: overhanging starts of loops of which at least a fifth does not overhang; share of all loops.
FILE may be of any slicer that names its features by `;TYPE:`.
"""
import math
import sys

ARM_MM = 0.5
NEAR_MM = 0.3
TAN_STEEP = 1.43
STEP_MM = 1.0


# ---- Parts

def prism(sections):
    """Returns the triangles through sections (z, ring). All rings have equally many points; each ring is convex or
    star-shaped around its middle.
    """
    out = []
    n = len(sections[0][1])
    point = lambda k, i: (*sections[k][1][i % n], sections[k][0])
    for k in range(len(sections) - 1):
        for i in range(n):
            a, b, c, d = point(k, i), point(k, i + 1), point(k + 1, i + 1), point(k + 1, i)
            out += [(a, b, c), (a, c, d)]
    for k, flip in ((0, True), (len(sections) - 1, False)):
        z, ring = sections[k]
        middle = (sum(p[0] for p in ring) / n, sum(p[1] for p in ring) / n, z)
        for i in range(n):
            t = (middle, point(k, i), point(k, i + 1))
            out.append(t[::-1] if flip else t)
    return out


def circle(radius, n=120, at=0.0):
    return [(radius * math.cos(2 * math.pi * i / n), at + radius * math.sin(2 * math.pi * i / n)) for i in range(n)]


def square(side, turn=0.0):
    return [(side / math.sqrt(2) * math.cos(turn + math.pi * (2 * i + 1) / 4),
             side / math.sqrt(2) * math.sin(turn + math.pi * (2 * i + 1) / 4)) for i in range(4)]


def rounded(side, radius, steps=12):
    middle = side / 2 - radius
    return [(sx * middle + radius * math.cos(a), sy * middle + radius * math.sin(a))
            for q, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1)))
            for i in range(steps + 1)
            for a in (math.pi / 2 * (q + i / steps),)]


def shell(heights, radius, n=240):
    """Returns the triangles of a solid with rings around the z axis; radius(angle, z) gives their radius."""
    angles = [2 * math.pi * i / n for i in range(n)]
    return prism([(z, [(r * math.cos(a), r * math.sin(a)) for a in angles for r in (max(radius(a, z), 1e-3),)])
                  for z in heights])


def ball(height, steps=120):
    """Returns heights at equal angles from pole to pole."""
    return [height / 2 * (1 - math.cos(math.pi * k / steps)) for k in range(steps + 1)]


def of_ball(z, height):
    """Returns the radius of a ball at this height."""
    return math.sqrt(max(z * (height - z), 0))


def bump(x, width):
    return math.exp(-(x / width) ** 2)


def head(a, z):
    """Returns the radius of a head at an angle and height: an egg with a nose, a brow and ears."""
    front = math.remainder(a, 2 * math.pi)
    skull = 0.8 * of_ball(z, 50) * (0.8 + 0.2 * math.cos(a))
    ears = bump(z - 26, 5) * bump(abs(front) - 1.7, 0.12)
    face = 5 * bump(z - 22, 4) * bump(front, 0.25) + 1.2 * bump(z - 31, 2.5) * bump(front, 0.9)
    return skull + (face + 3 * ears) * min(1, 8 * z * (50 - z) / 2500)


PARTS = {
    "cylinder": lambda: prism([(0, circle(15)), (30, circle(15))]),
    # Turns by 0.4 degrees per layer of 0.2 mm, so its corners move 0.1 mm per layer.
    "twisted_cube": lambda: prism([(0.2 * k, square(20, math.radians(0.4 * k))) for k in range(151)]),
    "box": lambda: prism([(0, square(20)), (20, square(20))]),
    "rounded_box": lambda: prism([(0, rounded(20, 3)), (20, rounded(20, 3))]),
    "ell": lambda: prism([(z, [(0, 0), (20, 0), (20, 8), (8, 8), (8, 20), (0, 20)]) for z in (0, 20)]),
    "sphere": lambda: prism([(15 - 15 * math.cos(math.pi * k / 60), circle(max(15 * math.sin(math.pi * k / 60), 1e-3)))
                             for k in range(61)]),
    "ellipsoid": lambda: shell(ball(32), lambda a, z: of_ball(z, 32) / 16 / math.hypot(math.cos(a) / 22, math.sin(a) / 12)),
    "bumpy_ball": lambda: shell(ball(40), lambda a, z: of_ball(z, 40) * (
        1 + 0.08 * math.sin(3 * a + z / 5) + 0.05 * math.sin(5 * a - z / 3) + 0.03 * math.cos(11 * a) * math.sin(z / 2))),
    "vase": lambda: shell([z / 3 for z in range(151)],
                          lambda a, z: (16 + 5 * math.sin(z / 9)) * (1 + 0.12 * math.cos(7 * (a - z / 60)))),
    "head": lambda: shell(ball(50), head),
    # A thread of 4 mm with flanks at 45 degrees.
    "screw": lambda: shell([z / 10 for z in range(401)],
                           lambda a, z: 8 + 2 * (1 - abs(2 * ((z / 4 - a / (2 * math.pi)) % 1) - 1))),
    # Leans 60 degrees to the rear, where seams would be.
    "leaning": lambda: prism([(z, [(0, 0), (20, 0), (20, 20 + 1.73 * z), (0, 20 + 1.73 * z)]) for z in (0, 20)]),
}


def write_stl(triangles):
    print("solid part")
    for t in triangles:
        print("facet normal 0 0 0\nouter loop")
        for p in t:
            print(f"vertex {p[0]:.6f} {p[1]:.6f} {p[2]:.6f}")
        print("endloop\nendfacet")
    print("endsolid part")


# ---- G-code

def read_layers(path):
    """Returns [(z, [loops of outer walls])] from the bottom up; a loop is the list of its points from the start."""
    layers = {}
    at = {"X": 0.0, "Y": 0.0, "Z": 0.0}
    outer, loop, relative, e_at = False, [], False, 0.0

    def finish():
        nonlocal loop
        if len(loop) > 3 and math.dist(loop[0][:2], loop[-1][:2]) < 0.15:
            layers.setdefault(round(max(p[2] for p in loop), 3), []).append([p[:2] for p in loop])
        loop = []

    for line in open(path):
        if line.startswith(";TYPE:"):
            kind = line[6:].strip()
            was, outer = outer, kind in ("External perimeter", "Outer wall", "WALL-OUTER") or (
                outer and kind in ("Overhang perimeter", "Overhang wall"))
            if was and not outer:
                finish()
            continue
        words = line.split(";")[0].split()
        if not words:
            continue
        if words[0] in ("M82", "M83"):
            relative = words[0] == "M83"
        if words[0] == "G92":
            e_at = next((float(w[1:]) for w in words[1:] if w[0] == "E"), e_at)
        if words[0] not in ("G0", "G1"):
            continue
        to = {w[0]: float(w[1:]) for w in words[1:] if w[0] in "XYZE"}
        before = (at["X"], at["Y"], at["Z"])
        at.update({k: v for k, v in to.items() if k != "E"})
        amount = (to["E"] if relative else to["E"] - e_at) if "E" in to else 0.0
        e_at = to.get("E", e_at)
        if ("X" in to or "Y" in to) and amount > 0 and outer:
            if not loop:
                loop.append(before)
            loop.append((at["X"], at["Y"], at["Z"]))
        elif "X" in to or "Y" in to:
            finish()
    finish()
    return sorted(layers.items())


def along(loop, step):
    """Returns points along a loop, `step` apart."""
    out, left = [], 0.0
    for a, b in zip(loop, loop[1:]):
        edge = math.dist(a, b)
        while edge > 0 and left < edge:
            out.append((a[0] + (b[0] - a[0]) * left / edge, a[1] + (b[1] - a[1]) * left / edge))
            left += step
        left -= edge
    return out


def turns(loop):
    """Returns (point, turn in degrees) every 0.1 mm; outward turns are positive."""
    fine = along(loop, 0.1)
    n, arm = len(fine), int(ARM_MM / 0.1)
    if n < 4 * arm:
        return []
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(loop, loop[1:]))
    out = []
    for i in range(n):
        a, p, b = fine[i - arm], fine[i], fine[(i + arm) % n]
        u, v = (p[0] - a[0], p[1] - a[1]), (b[0] - p[0], b[1] - p[1])
        turn = math.degrees(math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]))
        out.append((p, turn if area > 0 else -turn))
    return out


def is_hole(loop, others):
    return sum(inside(loop[0], o) for o in others if o is not loop) % 2 == 1


def inside(p, ring):
    odd = False
    for a, b in zip(ring, ring[1:]):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]):
            odd = not odd
    return odd


def distance_to(p, ring):
    least = math.inf
    for a, b in zip(ring, ring[1:]):
        dx, dy = b[0] - a[0], b[1] - a[1]
        length2 = dx * dx + dy * dy
        t = 0 if length2 == 0 else max(0, min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2))
        least = min(least, math.hypot(a[0] + t * dx - p[0], a[1] + t * dy - p[1]))
    return least


def overhang(p, below):
    """Returns the distance of a point outside the outer walls of the layer below; 0 if it is inside them."""
    if sum(inside(p, ring) for ring in below) % 2 == 1:
        return 0.0
    return min((distance_to(p, ring) for ring in below), default=math.inf)


def measure(path):
    layers = read_layers(path)
    steps, with_corner, on_corner, hanging, avoidable = [], 0, 0, 0, 0
    for (z_below, below), (z, loops) in zip(layers, layers[1:]):
        if z - z_below > 1:
            continue
        reach = TAN_STEEP * (z - z_below)
        for loop in loops:
            start = loop[0]
            steps.append(min(math.dist(start, other[0]) for other in below))
            sign = -1 if is_hole(loop, loops) else 1
            corners = [p for p, turn in turns(loop) if not -15 < turn * sign < 30]
            if corners:
                with_corner += 1
                on_corner += min(math.dist(start, p) for p in corners) <= NEAR_MM
            if overhang(start, below) > reach:
                hanging += 1
                points = along(loop, STEP_MM)
                avoidable += sum(overhang(p, below) <= reach for p in points) * 5 >= len(points)
    n = max(len(steps), 1)
    steps.sort()
    percent = lambda part, whole: f"{100 * part / whole:.1f}" if whole else "-"
    print(len(steps), percent(sum(s > 1 for s in steps), n), f"{sum(steps) / n:.3f}",
          f"{steps[min(n * 95 // 100, n - 1)]:.3f}" if steps else "-", percent(on_corner, with_corner),
          percent(hanging, n), percent(avoidable, n))


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "part" and sys.argv[2] in PARTS:
        write_stl(PARTS[sys.argv[2]]())
    elif len(sys.argv) == 3 and sys.argv[1] == "measure":
        measure(sys.argv[2])
    else:
        sys.exit(__doc__)
