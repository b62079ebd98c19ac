"""Makes the files of tests/data/shapes with ezdxf 1.4.5 and pyvista 0.49.1; the tessellations are those of Neper 4.10.2-45:

neper -T -n 8 -id 1 -o grains3d
neper -T -n 6 -id 1 -dim 2 -domain "square(2,1)" -o grains2d
"""

import ezdxf
import pyvista

for version in ("R12", "R2010"):
    drawing = ezdxf.new(version)
    if version == "R2010":
        drawing.header["$INSUNITS"] = 4  # mm
    drawing.layers.add("rock")
    space = drawing.modelspace()
    square = [(0, 0), (2000, 0), (2000, 1000), (0, 1000)]
    if version == "R12":
        space.add_polyline2d(square, close=True, dxfattribs={"layer": "rock"})
    else:
        space.add_lwpolyline(square, close=True, dxfattribs={"layer": "rock"})
    space.add_polyline2d([(2000, 0), (3000, 0), (3000, 1000), (2000, 1000)], close=True, dxfattribs={"layer": "rock"})
    # A half disk by its bulge, and the same seen from behind.
    half = [(0, 2000, 0, 0, 1), (1000, 2000, 0, 0, 0)]
    for extrusion in ((0, 0, 1), (0, 0, -1)):
        attributes = {"layer": "round", "extrusion": extrusion}
        if version == "R12":
            line = space.add_polyline2d([(p[0], p[1], p[4]) for p in half], format="xyb", close=True, dxfattribs=attributes)
        else:
            line = space.add_lwpolyline(half, close=True, dxfattribs=attributes)
    space.add_line((500, -100), (500, 1100), dxfattribs={"layer": "joints"})
    space.add_polyline2d([(-100, 500), (1000, 500), (2100, 600)], dxfattribs={"layer": "joints"})
    space.add_circle((0, 0), 100)
    drawing.saveas(f"section_{version}.dxf")
    if version == "R2010":
        drawing.saveas(f"section_{version}_binary.dxf", fmt="bin")

cube = pyvista.Cube(center=(1, 1.5, 2), x_length=2, y_length=3, z_length=4)
tetrahedron = pyvista.Tetrahedron(center=(10, 0, 0))
both = (cube.triangulate().clean() + tetrahedron.triangulate().clean()).extract_surface()
for binary in (True, False):
    both.save(f"two_{'binary' if binary else 'ascii'}.stl", binary=binary)
