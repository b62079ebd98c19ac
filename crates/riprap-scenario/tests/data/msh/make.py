"""Makes the .msh files of tests/data/msh: cylinder of tetrahedra and a sheared pair of bricks, with gmsh 4.15.2."""
import sys
import gmsh

def write(stem):
    for version in (2.2, 4.1):
        for binary in (0, 1):
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            gmsh.write(f"{stem}_{str(version).replace('.', '')}_{'binary' if binary else 'ascii'}.msh")

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)

gmsh.model.add("cylinder")
body = gmsh.model.occ.addCylinder(0, 0, 0, 0, 0, 2, 1)
gmsh.model.occ.synchronize()
gmsh.model.addPhysicalGroup(3, [body], 7, "rock core")
ends = [s for s in gmsh.model.getEntities(2) if abs(gmsh.model.occ.getCenterOfMass(*s)[2] - 1) > 0.9]
gmsh.model.addPhysicalGroup(2, [s[1] for s in ends], 8, "ends")
gmsh.option.setNumber("Mesh.MeshSizeMin", 0.9)
gmsh.option.setNumber("Mesh.MeshSizeMax", 0.9)
gmsh.model.mesh.generate(3)
write("cylinder")
gmsh.clear()

gmsh.model.add("bricks")
for k in range(2):
    s = gmsh.model.geo
    p = [s.addPoint(x + k, y, 0) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    l = [s.addLine(p[i], p[(i + 1) % 4]) for i in range(4)]
    f = s.addPlaneSurface([s.addCurveLoop(l)])
    for c in l:
        s.mesh.setTransfiniteCurve(c, 2)
    s.mesh.setTransfiniteSurface(f)
    s.mesh.setRecombine(2, f)
    v = s.extrude([(2, f)], 0.25, 0, 1, [2], recombine=True)
    s.synchronize()
    gmsh.model.addPhysicalGroup(3, [v[1][1]], 1 + k, ["left", "right"][k])
gmsh.model.mesh.generate(3)
write("bricks")
gmsh.finalize()
