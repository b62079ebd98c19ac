"""Code in the loop: nodes, laws of one's own, parameters that change."""

import numpy as np
import pytest

import riprap


def stone(space="planar", friction="0 deg", until="0.4 s"):
    """A stone of a metre on a table, weight 25 kN."""
    flat = space == "planar"

    def block(name, size, corner):
        kind = "rectangle" if flat else "brick"
        if flat:
            size, corner = (size[0], size[2]), (corner[0], corner[2])
        shape = {kind: {"size": [f"{x} m" for x in size], "corner": [f"{x} m" for x in corner]}}
        return {"name": name, "material": "rock", **shape}

    rock = {"density": "2500 kg/m3"} | ({} if flat else {"young": "10 GPa", "poisson": 0.25})
    law = {"normal_stiffness": "1 GPa/m", "friction_angle": friction, "damping_ratio": 0.3}
    down = ["0 m/s2", "-10 m/s2"] if flat else ["0 m/s2", "0 m/s2", "-10 m/s2"]
    return {
        "riprap": 1,
        "title": "A stone on a table",
        "space": {space: {"gravity": down}},
        "materials": {"rock": rock},
        "interfaces": {"default": law if flat else {**law, "shear_stiffness": "0.5 GPa/m"}},
        "blocks": [block("table", (12, 1, 1), (-4, 0, -1)), block("stone", (1, 1, 1), (0, 0, 0))],
        "supports": [{"on": {"block": "table"}, "fixed": {}}],
        "phases": [{"name": "go", "until": {"time": until}, "time_step": "50 us"}],
    }


BAR = {
    "riprap": 1,
    "title": "A bar of tetrahedra",
    "space": {"spatial": {"gravity": "0 m/s2"}},
    "materials": {"rock": {"density": "2500 kg/m3", "young": "10 GPa", "poisson": 0}},
    "interfaces": {"default": {"brittle_bond": {"thickness": "1 mm", "elastic": True}}},
    "blocks": [
        {
            "name": "bar",
            "material": "rock",
            "brick": {"size": ["1 m", "1 m", "1 m"], "corner": ["0 m", "0 m", "0 m"]},
            "mechanics": {"deformable": {}},
        }
    ],
    "boundaries": [{"on": {"plane": "x-min"}, "roller": {}}],
    "phases": [{"name": "pull", "kind": "static", "until": {"unbalanced": 1e-10}}],
}


def test_nodes_are_pulled_by_their_numbers():
    with riprap.Simulation(BAR, threads=1) as sim:
        nodes = sim.nodes("bar")
        assert nodes["point"].shape == nodes["velocity"].shape == (15, 3) and nodes["mass"].sum() == pytest.approx(2500)
        with pytest.raises(ValueError, match="read-only"):
            nodes["point"][0] = 0
        end = np.flatnonzero(np.asarray(nodes["point"])[:, 0] > 0.99)
        # Thirds of four triangles: twice as much on the centre of the face.
        share = np.where(end < 8, 1 / 6, 1 / 3)[:, None]
        sim.set_force("bar", 1e6 * share * np.array([1.0, 0.0, 0.0]), nodes=end)
        sim.advance()
        moved = np.asarray(sim.nodes("bar")["displacement"])[end, 0]
        assert moved == pytest.approx(1e6 / 10e9, rel=1e-6)
    with riprap.Simulation(BAR, threads=1) as sim:
        for nodes, force, why in (
            ([99], (1, 0, 0), "it has nodes 0 to 14, not 99"),
            ([-1], (1, 0, 0), "numbers from 0, not -1"),
            ([3, 3], (1, 0, 0), "node 3 is named twice"),
            ([3], (np.nan, 0, 0), "the force on node 3 is not finite"),
        ):
            with pytest.raises(ValueError, match=why):
                sim.set_force("bar", force, nodes=nodes)
        with pytest.raises(ValueError, match="nodes take no moment"):
            sim.set_force("bar", (1, 0, 0), (0, 0, 1), nodes=[1])


@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_a_damper_of_python_follows_its_closed_form(space):
    calls = []

    def damper(contacts):
        calls.append(len(contacts["area"]))
        with pytest.raises(ValueError, match="read-only"):
            contacts["velocity"][...] = 0
        return 2.5e3 * contacts["velocity"]

    with riprap.Simulation(stone(space), threads=1) as sim:
        sim.advance(time=0.1)
        sim.set_velocity("stone", (1, 0, 0))
        sim.contact_law("damper", "stone", damper)
        sim.advance(time=0.2)
        closed = np.exp(-0.2)
        assert sim.value("block.speed", of="stone").value == pytest.approx(closed, rel=2e-3)
        assert sim.value("load.work", of="law damper").value == pytest.approx(-1250 * (1 - closed**2), rel=5e-3)
        assert abs(sim.value("energy.residual_relative").value) < 1e-6
        cost = sim.law_costs()["damper"]
        assert cost["calls"] == len(calls) and cost["seconds"] > 0 and set(calls) == {1}


def test_a_law_remembers_and_is_given_again(tmp_path):
    def glue(contacts):
        normal, moved = np.asarray(contacts["normal"]), np.asarray(contacts["displacement"])
        along = moved - (moved * normal).sum(axis=1)[:, None] * normal
        stress = 1e8 * along
        broken = contacts["memory"]
        broken[np.linalg.norm(stress, axis=1) > 2e3] = 1.0
        return np.where(np.asarray(broken) > 0, 0.0, stress)

    scene = stone(friction="20 deg")
    scene["space"]["planar"]["tilt"] = "25 deg"
    with riprap.Simulation(scene, threads=1) as whole:
        whole.contact_law("glue", ("stone", "table"), glue, memory=1)
        whole.advance()
        state = whole.state_hash
    path = tmp_path / "glued.run"
    with riprap.Simulation(scene, path, threads=1) as first:
        first.contact_law("glue", ("stone", "table"), glue, memory=1)
        first.advance(time=0.02)
    with pytest.raises(riprap.RunError, match="not known here; give it again"):
        riprap.resume(path, progress=False)
    with riprap.Simulation.reopen(path) as again:
        again.contact_law("glue", ("stone", "table"), glue, memory=1)
        again.advance()
        assert again.state_hash == state


def test_a_law_that_raises_stops_the_run_with_a_checkpoint(tmp_path):
    def late(contacts):
        if contacts["time"] > 0.01:
            raise ZeroDivisionError("my own mistake")
        return np.zeros((len(contacts["area"]), 3))

    path = tmp_path / "late.run"
    sim = riprap.Simulation(stone(), path, threads=1)
    sim.contact_law("late", "stone", late)
    with pytest.raises(ZeroDivisionError, match="my own mistake") as raised:
        sim.advance()
    assert "contact law `late` at step" in raised.value.__notes__[0]
    assert any(entry.name == "late" for entry in raised.traceback)
    assert sim.close().ended == "interrupted"
    with riprap.Simulation.reopen(path) as again:
        again.contact_law("late", "stone", lambda contacts: np.zeros((len(contacts["area"]), 2)))
        assert not again.advance()


def test_what_a_law_must_not_give_is_said():
    for answer, error, why in (
        (lambda n: np.full((n, 3), np.nan), riprap.RunError, "traction is not finite at the contact of `table` and `stone`"),
        (lambda n: np.zeros(n + 7), ValueError, "gave an array of shape"),
    ):
        sim = riprap.Simulation(stone(), threads=1)
        with pytest.raises(error, match=why):
            sim.contact_law("mine", "stone", lambda contacts, answer=answer: answer(len(contacts["area"])))
            sim.advance()
    with riprap.Simulation(stone(), threads=1) as sim:
        with pytest.raises(ValueError, match='did you mean "stone"'):
            sim.contact_law("mine", "stnoe", lambda _: None)
        with pytest.raises(ValueError, match="give one group, or two"):
            sim.contact_law("mine", ("stone", "table", "stone"), lambda _: None)


def test_parameters_change_by_name():
    with riprap.Simulation(stone("spatial", friction="30 deg"), threads=1) as sim:
        sim.advance(time=0.05)
        sim.set_interface("default", friction_angle="10 deg", cohesion="1 kPa")
        sim.set_material("rock", young="5 GPa")
        assert sim.value("block.mass", of="stone").value == pytest.approx(2500.0)
        sim.set_material("rock", density="5000 kg/m3")
        assert sim.value("block.mass", of="stone").value == pytest.approx(5000.0)
        with pytest.raises(riprap.ScenarioError, match="did you mean"):
            sim.set_interface("default", friction_angel="10 deg")
        assert sim.advance(time=0.05)
    with riprap.Simulation(stone("planar"), threads=1) as sim:
        with pytest.raises(ValueError, match=r"change `interfaces.NAME.normal_stiffness`"):
            sim.set_material("rock", young="5 GPa")
        sim.set_interface("default", normal_stiffness="2 GPa/m")


@pytest.mark.parametrize("space", ["planar", "spatial"])
def test_a_spin_is_set(space):
    scene = stone(space)
    scene["blocks"][1]["brick" if space == "spatial" else "rectangle"]["corner"][-1] = "9 m"
    with riprap.Simulation(scene, threads=1) as sim:
        sim.set_velocity("stone", spin=2.0 if space == "planar" else (0, 2.0, 0))
        sim.advance(time=0.1)
        assert sim.value("block.spin", of="stone").value == pytest.approx(2.0)
        assert sim.value("block.rotation", of="stone").value == pytest.approx(0.2, rel=1e-3)
        with pytest.raises(ValueError, match="`velocity`, `spin` or both"):
            sim.set_velocity("stone")


def test_contacts_of_the_plane_have_a_normal():
    with riprap.Simulation(stone(), threads=1) as sim:
        sim.advance(time=0.1)
        contacts = sim.contacts()
        (normal,) = np.asarray(contacts["normal"])
        first = sim.names[int(contacts["block_a"][0])]
        assert normal == pytest.approx([0, 1 if first == "table" else -1], abs=1e-6)
