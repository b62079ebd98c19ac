"""Writes data/kirsch.msh: a quarter of a disk of rock of radius 20 m, one layer thick, around a round hole of 1 m that is still filled.

Rings of hexahedra whose sides grow with their distance from the centre; the core is a fan of prisms. Volumes "rock" and "core", surface "rim".
"""

import math
import sys

SECTORS, OUTER, THICK = 18, 20.0, 0.1
RINGS = round(math.log(OUTER) / (math.pi / 2 / SECTORS))

nodes = [(0.0, 0.0)]
for ring in range(RINGS + 1):
    r = OUTER ** (ring / RINGS)
    nodes += [
        (r * math.cos(a), r * math.sin(a))
        for a in (math.pi / 2 * s / SECTORS for s in range(SECTORS + 1))
    ]
flat = len(nodes)


def node(ring, sector, layer):
    return 2 + ring * (SECTORS + 1) + sector + layer * flat


elements = []
for s in range(SECTORS):
    low, high = ([1 + k * flat, node(0, s, k), node(0, s + 1, k)] for k in (0, 1))
    elements.append((6, 2, low + high))
for ring in range(RINGS):
    for s in range(SECTORS):
        low, high = (
            [node(ring, s, k), node(ring + 1, s, k), node(ring + 1, s + 1, k), node(ring, s + 1, k)]
            for k in (0, 1)
        )
        elements.append((5, 1, low + high))
for s in range(SECTORS):
    elements.append((3, 3, [node(RINGS, s, 0), node(RINGS, s + 1, 0), node(RINGS, s + 1, 1), node(RINGS, s, 1)]))

out = sys.stdout
out.write('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n')
out.write('$PhysicalNames\n3\n3 1 "rock"\n3 2 "core"\n2 3 "rim"\n$EndPhysicalNames\n')
out.write(f"$Nodes\n{2 * flat}\n")
for k in (0, 1):
    for n, (x, y) in enumerate(nodes):
        out.write(f"{1 + n + k * flat} {x:.12g} {y:.12g} {k * THICK:.12g}\n")
out.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
for n, (kind, tag, ids) in enumerate(elements):
    out.write(f"{n + 1} {kind} 2 {tag} {tag} {' '.join(map(str, ids))}\n")
out.write("$EndElements\n")
