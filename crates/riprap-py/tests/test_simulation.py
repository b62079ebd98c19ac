"""Simulations advanced step by step."""

import math
import threading

import numpy as np
import pytest

import riprap


def test_step_by_step_is_the_same_run(sliding_block, tmp_path):
    """Pauses change no bit of the state nor of the files."""
    scene = sliding_block()
    whole = riprap.run(scene, tmp_path / "whole.run", threads=1, progress=False)
    with riprap.Simulation(scene, tmp_path / "steps.run", threads=2) as sim:
        assert sim.steps == 0 and sim.time == 0 and sim.running and sim.phase == "slide"
        assert sim.advance(steps=7) and sim.steps == 7
        assert sim.advance(steps=0) and sim.steps == 7
        assert sim.advance(time=0.03) and 0.037 > sim.time >= 0.03
        while sim.advance(steps=500):
            pass
        assert not sim.running and not sim.advance()
        assert sim.state_hash == whole.state_hash
    steps = riprap.RunFolder(tmp_path / "steps.run")
    assert steps.finished and steps.state_hash == whole.state_hash
    for name in ("histories.csv", "energy.csv", "events.jsonl"):
        assert (steps.path / name).read_bytes() == (whole.path / name).read_bytes()


def test_a_closed_simulation_can_be_resumed(sliding_block, tmp_path):
    scene = sliding_block()
    whole = riprap.run(scene, tmp_path / "whole.run", threads=1, progress=False)
    for steps in (0, 100):
        path = tmp_path / f"half{steps}.run"
        sim = riprap.Simulation(scene, path)
        sim.advance(steps=steps)
        run = sim.close()
        assert run.ended == "interrupted"
        with pytest.raises(ValueError, match="closed"):
            sim.advance(steps=1)
        assert "closed" in repr(sim)
        again = run.resume(threads=1, progress=False)
        assert again.state_hash == whole.state_hash
        for name in ("histories.csv", "energy.csv", "events.jsonl"):
            assert (again.path / name).read_bytes() == (whole.path / name).read_bytes()


def test_values_frames_and_energies(sliding_block):
    with riprap.Simulation(sliding_block()) as sim:
        assert sim.path is None and sim.names == ["plane", "block"]
        before = sim.field("displacement")
        sim.advance(time=0.1)
        after = sim.field("displacement")
        assert before.shape == after.shape == (2, 2) and after.unit == "m"
        assert np.all(before == 0) and after[1, 0] > 0 > after[1, 1]
        slip = sim.histories()["slip"]
        along = sim.value("block.displacement", of="block", along=[np.cos(np.radians(-35)), np.sin(np.radians(-35))])
        assert slip.unit == "m" and slip.value == pytest.approx(along.value, rel=1e-12)
        assert sim.value("block.displacement.x", of=["block"]).value == after[1, 0]
        assert float(sim.value("model.unbalanced")) >= 0
        energy = sim.energy()
        assert energy["kinetic"].unit == "J/m" and energy["kinetic"].value > 0
        assert abs(energy["residual"].value) < 1e-3 * energy["kinetic"].value


@pytest.mark.parametrize(
    ("name", "of", "hint"),
    [
        ("block.displacment.x", "block", "did you mean"),
        ("block.rotation", "blok", "did you mean \"block\""),
        ("block.rotation", (), "one block"),
        ("block.rotation", ["block", "plane"], "one block"),
        ("model.unbalanced", "block", "whole model"),
        ("block.rotation.x", "block", "scalar"),
    ],
)
def test_wrong_questions_are_answered(sliding_block, name, of, hint):
    with riprap.Simulation(sliding_block()) as sim, pytest.raises(ValueError, match=hint):
        sim.value(name, of)


def test_every_field_can_be_asked_for(sliding_block, blast):
    """No question about a field panics, whatever it is asked of."""
    for scene in (sliding_block(), blast.scenario):
        with riprap.Simulation(scene) as sim:
            sim.advance(steps=3)
            names = [sim.names[0], sim.names[-1], *(s["name"] for s in blast.manifest["sources"])]
            for info in riprap.fields(sim.scenario.space):
                for of in ([], names[:1], names[:2], names[-1:]):
                    try:
                        value = sim.value(info.name, of)
                    except ValueError:
                        continue
                    assert value.unit == info.unit


def test_snapshots_do_not_change(sliding_block):
    with riprap.Simulation(sliding_block()) as sim:
        sim.advance(steps=10)
        frame = sim.frame()
        kept = frame.points.copy()
        sim.advance(steps=100)
        assert np.array_equal(frame.points, kept)
        assert not np.array_equal(sim.frame().points, kept)


def test_a_callback_pauses(sliding_block):
    with riprap.Simulation(sliding_block(time="2 s")) as sim:
        assert sim.advance(callback=lambda p: False)
        step = sim.steps
        assert sim.advance(steps=5) and sim.steps == step + 5


def test_two_at_once_are_turned_away(sliding_block):
    """Asking during `advance`, from a callback or another thread, is an error and no deadlock."""
    with riprap.Simulation(sliding_block(time="2 s")) as sim:
        said = []

        def look(_):
            for ask in (lambda: sim.time, lambda: sim.advance(steps=1)):
                try:
                    ask()
                except RuntimeError as error:
                    said.append(str(error))
            return False

        sim.advance(callback=look)
        assert len(said) == 2 and "is advancing" in said[0]
        worker = threading.Thread(target=lambda: sim.advance(steps=10))
        worker.start()
        worker.join()
        assert sim.steps > 10


def test_the_past_is_gone(sliding_block):
    with riprap.Simulation(sliding_block()) as sim:
        with pytest.raises(ValueError, match="0 or more"):
            sim.advance(steps=-1)
        with pytest.raises(ValueError, match="0 or more"):
            sim.advance(time=float("nan"))


PUSHED = """
riprap = 1
title = "a stone is pushed over a table"
[space.planar]
gravity = ["0 m/s2", "-10 m/s2"]
[materials.rock]
density = "2500 kg/m3"
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "30 deg"
damping_ratio = 0.2
[[blocks]]
name = "table"
material = "rock"
rectangle = { size = ["8 m", "1 m"], corner = ["-2 m", "-1 m"] }
[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "0 m"] }
[[supports]]
name = "table"
on.block = "table"
motion = { velocity = { x = { constant = "0 m/s" }, y = { constant = "0 m/s" }, spin = { constant = "0 rad/s" } } }
[[loads]]
name = "push"
on.block = "stone"
point = { force = ["10 kN/m", "0 N/m"] }
time = { constant = 0.0 }
[[phases]]
name = "go"
until = { time = "2 s" }
[[outputs]]
frames = { every = "0.5 s" }
"""


def servo(out=None, gain=20.0):
    """A controller that holds the speed of the stone at 0.2 m/s."""
    with riprap.Simulation(PUSHED, out, threads=1) as sim:
        pushed = 0.0
        while sim.advance(steps=50):
            error = 0.2 - sim.value("block.velocity.x", of="stone").value
            pushed = pushed + 10.0 * gain * error * 50 * sim.dt
            sim.steer("push", factor=pushed + gain * error)
        speed = sim.value("block.velocity.x", of="stone").value
        return speed, pushed, sim.state_hash, sim.value("energy.residual_relative").value


def test_a_servo_holds_a_speed(tmp_path):
    speed, pushed, state, residual = servo(tmp_path / "a.run")
    assert abs(speed - 0.2) < 2e-3
    # Friction alone resists: 25 kN/m tan 30 deg, in units of the load.
    assert abs(pushed - 2.5 * math.tan(math.radians(30))) < 0.03
    assert abs(residual) < 1e-3
    assert servo()[2] == state
    events = riprap.RunFolder(tmp_path / "a.run").events()
    steered = [event for event in events if event["event"] == "steered"]
    assert len(steered) > 10 and steered[0]["name"] == "push" and steered[0]["factor"] > 0


def test_a_support_is_steered_by_its_velocity():
    with riprap.Simulation(PUSHED, threads=1) as sim:
        sim.advance(time=0.5)
        sim.steer("table", velocity=(0.1, 0.0))
        sim.advance(time=1.0)
        assert abs(sim.value("block.velocity.x", of="stone").value - 0.1) < 1e-3
        assert abs(sim.value("block.displacement.x", of="table").value - 0.1) < 1e-3
        for name, options, words in [
            ("pushh", {"factor": 1.0}, "did you mean"),
            ("table", {"factor": 1.0}, "is a support"),
            ("push", {"velocity": (1.0, 0.0)}, "is a load"),
            ("push", {"factor": math.nan}, "not finite"),
            ("table", {"velocity": (0.0, 0.0, 1.0)}, "along z"),
            ("push", {}, "give `factor`"),
        ]:
            with pytest.raises(ValueError, match=words):
                sim.steer(name, **options)


def test_a_change_is_that_of_a_phase(tmp_path):
    def go(out=None):
        with riprap.Simulation(PUSHED, out, threads=1) as sim:
            sim.advance(time=0.1)
            sim.set_force("stone", (20e3, 0.0))
            sim.advance(time=0.2)
            sim.set_force("stone", (0.0, 0.0), moment=0.0)
            sim.change({"interfaces": {"default": {"friction_angle": "0 deg"}}, "gravity": ["0 m/s2", "-5 m/s2"]})
            before = sim.value("block.velocity.x", of="stone").value
            sim.advance(time=0.2)
            after = sim.value("block.velocity.x", of="stone").value
            return before, after, sim.state_hash

    before, after, state = go(tmp_path / "a.run")
    # 20 kN/m against the friction of 25 kN/m of weight, for 0.2 s on 2.5 t/m. Friction takes 1.3 sqrt(m/ks) = 3 ms to rise, in which the stone gains
    # some 0.01 m/s more.
    assert before == pytest.approx(0.2 * (20 - 25 * math.tan(math.radians(30))) / 2.5 + 0.01, rel=0.01)
    assert after == pytest.approx(before, rel=1e-3)
    assert go()[2] == state
    run = riprap.RunFolder(tmp_path / "a.run")
    events = [event for event in run.events() if event["event"] in ("changed", "force set")]
    assert [event["event"] for event in events] == ["force set", "force set", "changed"]
    assert events[2]["keys"]["gravity"] == ["0 m/s2", "-5 m/s2"]
    assert run.ended == "interrupted"


def test_wrong_changes_are_refused_at_their_place():
    with riprap.Simulation(PUSHED, threads=1) as sim:
        sim.advance(steps=5)
        before = sim.state_hash
        with pytest.raises(ValueError, match="`kind` cannot change within a phase"):
            sim.change({"kind": "static"})
        with pytest.raises(ValueError, match="remove.0: there is no block or group \"ston\"; did you mean \"stone\""):
            sim.change({"remove": ["ston"]})
        with pytest.raises(riprap.ScenarioError, match="gravity"):
            sim.change({"gravity": [math.nan, 0.0]})
        with pytest.raises(ValueError, match="not finite"):
            sim.set_force("stone", (math.nan, 0.0))
        with pytest.raises(ValueError, match="held or moved by a support"):
            sim.set_velocity("table", (1.0, 0.0))
        assert sim.state_hash == before
        sim.change({"remove": ["stone"]})
        with pytest.raises(ValueError, match="has been removed"):
            sim.set_velocity("stone", (1.0, 0.0))


def test_an_added_block_falls_and_belongs_to_its_groups(tmp_path):
    corners = np.array([(0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)])

    def go(out=None):
        with riprap.Simulation(PUSHED, out, threads=1) as sim:
            sim.advance(time=0.1)
            mass = sim.add_block("crumb.1", corners + (0.0, 9.0), material="rock", velocity=(0.0, -1.0))
            booked = sim.energy()["edit_defect"].value
            sim.advance(time=0.2)
            fallen = sim.value("block.velocity.y", of="crumb.1").value
            sim.change({"fix": ["crumb.1"]})
            sim.advance(steps=10)
            assert sim.value("block.speed", of="crumb.1").value == 0.0
            return mass, booked, fallen, sim.state_hash

    mass, booked, fallen, state = go(tmp_path / "a.run")
    assert mass == pytest.approx(2500 * 0.25) and booked == pytest.approx(0.5 * mass)
    assert fallen == pytest.approx(-1.0 - 0.2 * 10.0, rel=1e-3)
    assert go()[3] == state
    events = [event for event in riprap.RunFolder(tmp_path / "a.run").events() if event["event"] == "block_added"]
    assert [(event["block"], event["mass"]) for event in events] == [("crumb.1", mass)]


def test_a_wrong_block_is_refused_and_changes_nothing():
    corners = np.array([(0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)]) + (0.0, 9.0)
    with riprap.Simulation(PUSHED, threads=1) as sim:
        sim.advance(steps=5)
        before = sim.state_hash
        for name, points, options, words in [
            ("stone", corners, {}, "a block or group has this name"),
            ("crumb", corners - (0.0, 9.1), {}, "inside block"),
            ("crumb", corners, {"material": "rok"}, 'did you mean "rock"'),
            ("crumb", corners, {"groups": "crums"}, 'there is no group "crums"'),
            ("crumb", corners * math.nan, {}, "non-finite"),
            ("crumb", corners, {"velocity": (math.inf, 0.0)}, "its velocity is not finite"),
            ("crumb", corners, {"faces": [(0, 1, 2)]}, "the model is in the plane"),
        ]:
            with pytest.raises(ValueError, match=words):
                sim.add_block(name, points, **{"material": "rock", **options})
        assert sim.state_hash == before


def test_a_callback_that_raises_leaves_a_checkpoint(tmp_path):
    def stumble(sim):
        if sim.steps >= 100:
            raise ZeroDivisionError("my law")

    path = tmp_path / "a.run"
    sim = riprap.Simulation(PUSHED, path, threads=1)
    with pytest.raises(ZeroDivisionError, match="my law") as raised:
        sim.run(stumble, every=50)
    assert "step 100" in raised.value.__notes__[0] and "can be resumed" in raised.value.__notes__[0]
    with pytest.raises(ValueError, match="closed"):
        sim.advance()
    again = riprap.resume(path, threads=1, progress=False)
    with riprap.Simulation(PUSHED, threads=1) as whole:
        assert not whole.run(lambda _: None, every=50)
        assert again.state_hash == whole.state_hash
    with riprap.Simulation(PUSHED, threads=1) as paused:
        assert paused.run(lambda sim: sim.steps < 100, every=50) and paused.steps == 100
        with pytest.raises(ValueError, match="1 or more"):
            paused.run(lambda _: None, every=0)


def test_contacts_are_read_only_arrays_and_a_graph():
    with riprap.Simulation(PUSHED, threads=1) as sim:
        sim.advance(time=0.5)
        contacts = sim.contacts()
        assert contacts["point"].shape == (len(contacts["block_a"]), 3)
        for name in ("block_a", "block_b", "force_on_a", "length", "slipping"):
            with pytest.raises(ValueError, match="read-only"):
                contacts[name][...] = 0
        with pytest.raises(ValueError, match="read-only"):
            sim.frame().points[0] = 0
        nodes, edges = sim.graph()
        assert [name for name, _ in nodes] == ["table", "stone"]
        ((a, b, data),) = edges
        assert {a, b} == {"table", "stone"} and data["length"] == pytest.approx(1.0, rel=1e-3)
        assert abs(data["force_on_a"][1]) == pytest.approx(25e3, rel=0.01)
