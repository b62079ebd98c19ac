"""Removable blocks and run-out."""

import math
from pathlib import Path

import pytest

import riprap

SCENES = Path(__file__).parents[3] / "scenes"


def test_removable_blocks():
    found = riprap.removable(SCENES / "verify/spatial-rigid/g4_roof_wedge.toml", factor=1.5)
    (wedge,) = found.key_blocks
    assert wedge.mode == "falling" and wedge.support_force == pytest.approx(1.5 * 11547.005)
    assert found.ground == 3 and "1 key block" in found.words and found.not_counted == ["in_situ"]
    cliff = riprap.removable(SCENES / "spatial/wedge.toml", factor=1.1, rounds=5)
    exact = math.tan(math.radians(39.47)) / math.tan(math.radians(38.47))
    assert [block.round for block in cliff.blocks] == [1, 2]
    assert all(block.factor_of_safety == pytest.approx(exact, rel=1e-4) for block in cliff.blocks)
    with pytest.raises(ValueError, match="valid names: load"):
        riprap.removable(SCENES / "spatial/wedge.toml", phase="lood")


def test_runout(tmp_path):
    text = """
    riprap = 1
    title = "thrown"
    [space.planar]
    gravity = ["0 m/s2", "-10 m/s2"]
    [materials.rock]
    density = "2000 kg/m3"
    [interfaces.default]
    normal_stiffness = "100 MPa/m"
    friction_angle = "30 deg"
    [[blocks]]
    name = "stone"
    material = "rock"
    rectangle = { size = ["1 m", "1 m"], corner = ["-0.5 m", "19.5 m"] }
    velocity = ["10 m/s", "0 m/s"]
    [[blocks]]
    name = "floor"
    material = "rock"
    rectangle = { size = ["100 m", "1 m"], corner = ["-50 m", "-1 m"] }
    [[supports]]
    on = { block = "floor" }
    fixed = {}
    [[phases]]
    name = "fly"
    until = { time = "1.5 s" }
    time_step = "1 ms"
    [[outputs]]
    frames = { every = "0.5 s" }
    """
    run = riprap.Scenario(text).run(tmp_path / "a.run", threads=1)
    found = riprap.runout(run, lines={"road": "7 m"})
    assert found.runout["largest"] == pytest.approx(15.0) and found.moving == 1
    assert found.passages[0]["height"] == pytest.approx(20.0 - 5.0 * 0.7**2)
    assert found.lines["road"]["share"] == 1.0 and "1 rock of 1 run" in found.words
    with pytest.raises(ValueError, match="is not a line"):
        riprap.runout(run, lines={"road": "7 s"})
