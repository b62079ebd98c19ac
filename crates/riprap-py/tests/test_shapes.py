"""Shapes from the files of other tools, made by those tools where they can be had."""

import itertools

import numpy as np
import pytest

import riprap
from riprap import shapes


def in_plane(blocks):
    return {
        "riprap": 1,
        "title": "Shapes of a file",
        "space": {"planar": {"gravity": ["0 m/s2", "-9.81 m/s2"]}},
        "materials": {"rock": {"density": "2600 kg/m3"}},
        "interfaces": {"default": {"normal_stiffness": "10 GPa/m", "friction_angle": "30 deg"}},
        "blocks": blocks,
        "phases": [{"name": "a", "until": {"steps": 5}}],
    }


def in_space(blocks):
    return {
        "riprap": 1,
        "title": "Shapes of a file",
        "space": {"spatial": {"gravity": "9.81 m/s2"}},
        "materials": {"rock": {"density": "2400 kg/m3", "young": "18 GPa", "poisson": 0.25}},
        "interfaces": {"default": {"cohesion": "4 MPa", "friction_angle": "30 deg"}},
        "blocks": blocks,
        "phases": [{"name": "a", "until": {"steps": 5, "time": "1 ms"}}],
    }


def tess(cells=(2, 1, 1)):
    """A box of cubes in the format of Neper 3.4, faces shared between cells."""
    nx, ny, nz = cells
    corner, faces, polyhedra = {}, {}, []
    for x, y, z in itertools.product(range(nx), range(ny), range(nz)):
        rings = [
            [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)], [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
            [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)], [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)],
            [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)], [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
        ]  # fmt: skip
        signed = []
        for ring in rings:
            ring = [corner.setdefault((x + a, y + b, z + c), len(corner) + 1) for a, b, c in ring]
            key = frozenset(ring)
            signed.append(-faces[key][0] if key in faces else len(faces) + 1)
            faces.setdefault(key, (len(faces) + 1, ring))
        polyhedra.append(signed)
    lines = ["***tess", " **format", "   3.4", " **general", "   3 standard", " **cell", f"  {len(polyhedra)}", " **vertex", f" {len(corner)}"]
    lines += [f"   {i} {x:.12f} {y:.12f} {z:.12f} 0" for (x, y, z), i in corner.items()]
    lines += [" **edge", " 0", " **face", f" {len(faces)}"]
    for number, ring in faces.values():
        lines += [f"   {number} {len(ring)} {' '.join(map(str, ring))}", "     4 1 2 3 4", "    0.0 0.0 0.0 1.0", "     0 0 0.0 0.0 0.0"]
    lines += [" **polyhedron", f" {len(polyhedra)}"]
    lines += [f"   {i + 1} {len(p)} {' '.join(map(str, p))}" for i, p in enumerate(polyhedra)]
    return "\n".join([*lines, "***end", ""])


def test_cells_of_neper(tmp_path):
    file = tmp_path / "cubes.tess"
    file.write_text(tess((2, 1, 2)))
    blocks = shapes.from_tess(file, material="rock", name="grain")
    assert [b["name"] for b in blocks] == ["grain.1", "grain.2", "grain.3", "grain.4"]
    assert all(len(b["polyhedron"]["vertices"]) == 8 and len(b["polyhedron"]["faces"]) == 6 for b in blocks)
    scenario = riprap.Scenario(in_space(blocks))
    report = scenario.check()
    assert report.model["blocks"] == 4 and report.model["mass"] == pytest.approx(4 * 2400, rel=1e-9)
    with riprap.Simulation(scenario) as sim:
        assert len(sim.frame().contact_points) >= 4
    small = shapes.from_tess(file, material="rock", unit="mm")
    assert small[0]["polyhedron"]["vertices"][-1][2].endswith("m")
    assert riprap.si(small[0]["polyhedron"]["vertices"][-1][2]) == pytest.approx(1e-3)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda t: "nonsense", "line 1"),
        (lambda t: t[: len(t) // 2], "line"),
        (lambda t: t.replace("   1 0.000000000000", "   1 zero"), "line 10: a number is expected"),
        (lambda t: t.replace("   3 standard", "   7 standard"), "line 5"),
        (lambda t: t.replace(" **polyhedron\n 2", " **polyhedron\n 2000000"), "entries in a file"),
        (lambda t: t.replace(" **polyhedron\n 2", " **polyhedron\n 3"), "line"),
        (lambda t: t.replace("   1 6 1 2", "   1 6 1 99"), "there is no face 99"),
    ],
)
def test_broken_tessellations_have_a_line(tmp_path, change, says):
    file = tmp_path / "broken.tess"
    file.write_text(change(tess()))
    with pytest.raises(riprap.ShapeError, match=says) as caught:
        shapes.from_tess(file, material="rock")
    assert "broken.tess`, line" in str(caught.value)


def test_polylines_of_a_drawing(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    drawing = ezdxf.new()
    space = drawing.modelspace()
    space.add_lwpolyline([(0, 0), (2000, 0), (2000, 1000), (0, 1000)], close=True, dxfattribs={"layer": "rock"})
    space.add_polyline2d([(2000, 0), (3000, 0), (3000, 1000), (2000, 1000)], close=True, dxfattribs={"layer": "rock"})
    # A half circle, by its bulge.
    space.add_lwpolyline([(0, 2000, 1), (1000, 2000, 0)], format="xyb", close=True, dxfattribs={"layer": "round"})
    space.add_lwpolyline([(0, 0), (5000, 5000)], dxfattribs={"layer": "rock"})
    file = tmp_path / "section.dxf"
    drawing.saveas(file)
    blocks = shapes.from_dxf(file, material="rock", unit="mm", layers=["rock"])
    assert [b["name"] for b in blocks] == ["block.1", "block.2"]
    report = riprap.Scenario(in_plane(blocks)).check()
    assert report.model["mass"] == pytest.approx(3 * 2600, rel=1e-9)
    (round_one,) = shapes.from_dxf(file, material="rock", unit="mm", layers=["round"], sagitta=0.1)
    points = np.array([[riprap.si(x) for x in p] for p in round_one["polygon"]["points"]])
    x, y = points.T
    area = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
    assert area == pytest.approx(np.pi / 8, rel=1e-3)
    drawing.header["$INSUNITS"] = 4  # mm
    drawing.saveas(file)
    (own, _) = shapes.from_dxf(file, material="rock", unit=None, layers=["rock"])
    assert own == blocks[0]
    with pytest.raises(ValueError, match="sagitta is -1"):
        shapes.from_dxf(file, material="rock", sagitta=-1)
    with pytest.raises(riprap.ShapeError, match="no closed polylines on the layers air"):
        shapes.from_dxf(file, material="rock", layers=["air"])
    for name, bytes_ in [("a.dxf", b"nonsense"), ("b.dxf", file.read_bytes()[:3000]), ("c.dxf", b"")]:
        (tmp_path / name).write_bytes(bytes_)
        with pytest.raises(riprap.ShapeError, match=name):
            shapes.from_dxf(tmp_path / name, material="rock")


def test_stl_there_and_back(blast, tmp_path):
    frame = blast.frame(0)
    chosen = [0, frame.n_blocks // 2]
    file = shapes.to_stl(frame, tmp_path / "two.stl", blocks=chosen)
    assert file.stat().st_size == 84 + 50 * 24
    blocks = shapes.from_stl(file, material="rock")
    assert len(blocks) == 2
    ours = np.prod([np.ptp(np.asarray(frame.corners(b)), axis=0) for b in chosen], axis=1)
    theirs = [np.prod(np.ptp([[riprap.si(x) for x in p] for p in b["polyhedron"]["vertices"]], axis=0)) for b in blocks]
    assert np.allclose(sorted(ours), sorted(theirs), rtol=1e-5)
    assert riprap.Scenario(in_space(blocks)).check().model["blocks"] == 2


def test_stl_of_pyvista(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    for binary in (True, False):
        file = tmp_path / f"cube{binary}.stl"
        pyvista.Cube(x_length=2, y_length=3, z_length=4).triangulate().clean().save(file, binary=binary)
        (cube,) = shapes.from_stl(file, material="rock")
        assert len(cube["polyhedron"]["vertices"]) == 8
    mass = riprap.Scenario(in_space([cube])).check().model["mass"]
    assert mass == pytest.approx(24 * 2400, rel=1e-6)
    again = pyvista.read(shapes.to_stl(riprap.Simulation(in_space([cube])).frame(), tmp_path / "again.stl"))
    assert again.volume == pytest.approx(24, rel=1e-6)
    torus = tmp_path / "torus.stl"
    pyvista.ParametricTorus().triangulate().clean().save(torus)
    with pytest.raises(riprap.ShapeError, match="not convex"):
        shapes.from_stl(torus, material="rock")


def test_broken_stl_files_are_told(tmp_path, slide):
    cube = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
    for text, says in [
        (cube, "not closed"),
        (cube.replace("1 0 0", "1 zero 0"), "line 5"),
        (cube[: cube.index("vertex 0 1 0")], "byte .*truncated"),
        ("", "byte 0"),
        ("x" * 200, "byte 200"),
        (cube.replace("1 0 0", "nan 0 0"), "line 5"),
    ]:
        (tmp_path / "a.stl").write_text(text)
        with pytest.raises(riprap.ShapeError, match=says):
            shapes.from_stl(tmp_path / "a.stl", material="rock")
    with pytest.raises(riprap.ShapeError, match="cannot read"):
        shapes.from_stl(tmp_path / "nowhere.stl", material="rock")
    with pytest.raises(riprap.ShapeError, match="in the plane"):
        shapes.to_stl(slide.frame(), tmp_path / "a.stl")


def test_random_bytes_do_no_harm(tmp_path):
    random = np.random.default_rng(1)
    good = tess().encode()
    for i in range(200):
        data = bytearray(good)
        for at in random.integers(0, len(data), 5):
            data[at] = random.integers(0, 256)
        file = tmp_path / "x.tess"
        file.write_bytes(data)
        try:
            shapes.from_tess(file, material="rock")
        except riprap.ShapeError:
            pass
