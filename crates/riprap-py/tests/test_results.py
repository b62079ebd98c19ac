"""Removable blocks, run-out, results of a blast and strength."""

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


def test_muckpile(tmp_path):
    text = """
    riprap = 1
    title = "bricks are blown apart"
    [space.spatial]
    gravity = "9.81 m/s2"
    [materials.rock]
    density = "2000 kg/m3"
    young = "1 GPa"
    poisson = 0.25
    [interfaces.default]
    cohesion = "10 kPa"
    friction_angle = "30 deg"
    [[blocks]]
    name = "rock"
    material = "rock"
    grid.box = { size = ["3 m", "3 m", "3 m"], cell = "1 m", corner = ["-1.5 m", "-1.5 m", "0 m"] }
    [explosives.anfo]
    density = "1000 kg/m3"
    detonation_velocity = "4000 m/s"
    heat_of_explosion = "3688 kJ/kg"
    [sources.charge.gas_cavity]
    centre = ["0 m", "0 m", "1.5 m"]
    mass = "5 kg"
    explosive = "anfo"
    coupling = "decoupled"
    [[phases]]
    name = "blast"
    until.time = "0.1 s"
    [[outputs]]
    frames = { every = "50 ms" }
    """
    run = riprap.Scenario(text).run(tmp_path / "a.run", threads=1)
    found = riprap.muckpile(run, moved="10 cm", rock_factor=7)
    assert found.throw["blocks"] == 6 and found.throw["mass"] == pytest.approx(12000.0)
    assert found.kuz_ram["x50"] > 0.0 and "muckpile:" in found.words
    assert sum(part["share"] for part in found.energy["to"]) == pytest.approx(1.0, abs=1e-6)
    with pytest.raises(ValueError, match="is not like"):
        riprap.muckpile(run, moved="1 kg")


def test_strength(tmp_path):
    # 35 deg and 1 MPa, elastic before.
    for k, normal in enumerate((1e6, 2e6, 4e6)):
        peak = 1e6 + normal * math.tan(math.radians(35.0))
        rows = "".join(f"{i},{i},{-0.25 * i * peak},{0.001 * i},{normal}\n" for i in range(5))
        (tmp_path / f"{k}.run").mkdir()
        head = "step,time [s],load [N],slip [m],normal [Pa]\n"
        (tmp_path / f"{k}.run" / "histories.csv").write_text(head + rows + f"5,5,0,0.005,{normal}\n")
    found = riprap.strength(tmp_path, load="load", area=1.0, strain="slip", confining="normal", shear=True)
    assert found.cohesion[0] == pytest.approx(1e6) and found.friction[0] == pytest.approx(35.0)
    first = found.tests[0]
    assert first["modulus"] == pytest.approx(250.0 * first["peak"]) and not first["at_end"]
    with pytest.raises(ValueError, match="laod"):
        riprap.strength(tmp_path, load="laod")
