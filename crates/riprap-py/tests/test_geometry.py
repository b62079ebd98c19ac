"""Graphs for networkx, shapes from and to trimesh and COMPAS. What is not installed is left out, with its name as the reason."""

import numpy as np
import pytest

import riprap


def metres(points):
    return [[f"{x} m" for x in map(float, p)] for p in points]


def scene(vertices, faces):
    """A solid 2 m above a floor."""
    return {
        "riprap": 1,
        "title": "A solid of another tool",
        "space": {"spatial": {"gravity": ["0 m/s2", "0 m/s2", "-10 m/s2"]}},
        "materials": {"rock": {"density": "2500 kg/m3", "young": "10 GPa", "poisson": 0.25}},
        "interfaces": {"default": {"friction_angle": "30 deg", "normal_stiffness": "1 GPa/m"}},
        "blocks": [
            {"name": "floor", "material": "rock", "brick": {"size": ["8 m", "8 m", "1 m"], "corner": ["-4 m", "-4 m", "-3 m"]}},
            {"name": "solid", "material": "rock", "polyhedron": {"vertices": metres(vertices), "faces": [list(map(int, f)) for f in faces]}},
        ],
        "supports": [{"on": {"block": "floor"}, "fixed": {}}],
        "phases": [{"name": "fall", "until": {"time": "0.1 s"}, "time_step": "1 ms"}],
    }


def triangles(faces):
    return [[face[0], face[k], face[k + 1]] for face in faces for k in range(1, len(face) - 1)]


def test_the_graph_of_a_wall_is_one_for_networkx():
    networkx = pytest.importorskip("networkx")
    course = [(0, 0), (1, 0), (2, 0), (0.5, 0.5), (1.5, 0.5), (9, 0)]
    bricks = [
        {"name": f"brick.{k}", "material": "rock", "rectangle": {"size": ["1 m", "0.5 m"], "corner": [f"{x} m", f"{y} m"]}}
        for k, (x, y) in enumerate(course)
    ]
    wall = {
        "riprap": 1,
        "title": "Five bricks, and one by itself",
        "space": {"planar": {"gravity": ["0 m/s2", "-10 m/s2"]}},
        "materials": {"rock": {"density": "2500 kg/m3"}},
        "interfaces": {"default": {"normal_stiffness": "1 GPa/m", "friction_angle": "30 deg", "damping_ratio": 0.5}},
        "blocks": bricks,
        "supports": [{"on": {"blocks": ["brick.0", "brick.1", "brick.2", "brick.5"]}, "fixed": {}}],
        "phases": [{"name": "rest", "until": {"time": "0.5 s"}}],
    }
    with riprap.Simulation(wall, threads=1) as sim:
        sim.advance(time=0.4)
        nodes, edges = sim.graph()
    graph = networkx.Graph()
    graph.add_nodes_from(nodes)
    graph.add_edges_from(edges)
    assert graph.number_of_nodes() == 6
    parts = sorted(map(len, networkx.connected_components(graph)))
    assert parts == [1, 5]
    # Half the weight of an upper brick on each of the two below it, 2500 kg/m3 of a metre by half a metre.
    for upper, lower in (("brick.3", ("brick.0", "brick.1")), ("brick.4", ("brick.1", "brick.2"))):
        borne = [abs(graph.edges[upper, name]["force_on_a"][1]) for name in lower]
        assert sum(borne) == pytest.approx(12.5e3, rel=0.02)
    assert networkx.shortest_path_length(graph, "brick.3", "brick.4") <= 2


def test_a_mesh_of_trimesh_goes_in_and_comes_out():
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.creation.icosahedron()
    with riprap.Simulation(scene(mesh.vertices, mesh.faces), threads=1) as sim:
        block = trimesh.creation.box(extents=(1, 0.8, 0.6), transform=trimesh.transformations.translation_matrix((2.5, 0, 0)))
        mass = sim.add_block("box", block.vertices, block.faces, material="rock")
        assert mass == pytest.approx(2500 * block.volume, rel=1e-9)
        sim.advance(time=0.05)
        frame, names = sim.frame(), sim.names
        for name, shape in (("solid", mesh), ("box", block)):
            k = [names[int(b)] for b in frame.blocks["block"]].index(name)
            out = trimesh.Trimesh(np.asarray(frame.corners(k)), triangles(frame.faces(k)), process=False)
            assert out.is_watertight and out.volume == pytest.approx(shape.volume, rel=1e-9)
            # It has fallen 5 m/s2 t2.
            fallen = shape.center_mass[2] - out.center_mass[2]
            assert fallen == pytest.approx(5 * sim.time**2, rel=0.05)


def test_a_mesh_of_compas_goes_in_and_comes_out():
    pytest.importorskip("compas")
    # Which its geometry imports.
    pytest.importorskip("scipy")
    from compas.datastructures import Mesh
    from compas.geometry import Box

    box = Box(1.0, 0.8, 0.6)
    vertices, faces = box.to_vertices_and_faces()
    with riprap.Simulation(scene(vertices, faces), threads=1) as sim:
        sim.advance(time=0.05)
        frame = sim.frame()
        out = Mesh.from_vertices_and_faces(np.asarray(frame.corners(1)).tolist(), [f.tolist() for f in frame.faces(1)])
    assert out.number_of_faces() == 6 and out.is_manifold()
    assert out.volume() == pytest.approx(0.48, rel=1e-9)
