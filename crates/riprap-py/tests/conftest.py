"""Scenes and runs that several tests look at. The tests run against the installed wheel."""

import os
from pathlib import Path

import pytest

import riprap

ROOT = Path(__file__).resolve().parents[3]
SCENES = ROOT / "scenes"


def pytest_configure():
    # The package of the working tree has no compiled half; a mix-up would test the wrong one.
    assert "site-packages" in str(Path(riprap.__file__)), f"riprap is not installed: {riprap.__file__}"


@pytest.fixture(scope="session")
def slide_file():
    return SCENES / "planar/slide.toml"


@pytest.fixture(scope="session")
def slide(slide_file, tmp_path_factory):
    """A block that slides for 1 s, run once."""
    return riprap.run(slide_file, tmp_path_factory.mktemp("slide") / "slide.run", threads=1, progress=False)


@pytest.fixture(scope="session")
def blast(tmp_path_factory):
    """A small charge in bricks, run for half a millisecond."""
    changes = {
        "phases.0.until.time": "0.5 ms",
        "outputs.0.frames.every": "0.25 ms",
        "outputs.1.history.name": "charge.pressure",
        "outputs.2.history.every": "25 us",
    }
    scenario = riprap.Scenario(SCENES / "spatial/blast.toml", set=changes)
    return scenario.run(tmp_path_factory.mktemp("blast") / "blast.run", threads=2, progress=False)


@pytest.fixture(scope="session")
def binary():
    """The command line, if it has been built."""
    path = Path(os.environ.get("RIPRAP_BINARY", ""))
    if not path.is_file():
        pytest.skip("RIPRAP_BINARY names no binary of the command line")
    return path


def sliding(friction="20 deg", time="0.2 s"):
    """A scenario as a dictionary: a block on a plane at 35 degrees."""
    level = {"rotate": {"angle": "-35 deg", "about": ["0 m", "0 m"]}, "material": "rock"}
    return {
        "riprap": 1,
        "title": "A block slides",
        "space": {"planar": {"gravity": ["0 m/s2", "-9.81 m/s2"]}},
        "materials": {"rock": {"density": "2600 kg/m3"}},
        "interfaces": {"default": {"normal_stiffness": "100 GPa/m", "friction_angle": friction, "damping_ratio": 0.2}},
        "blocks": [
            {"name": "plane", "rectangle": {"size": ["8 m", "0.5 m"], "corner": ["-1 m", "-0.5 m"]}, **level},
            {"name": "block", "rectangle": {"size": ["1 m", "0.5 m"], "corner": ["-0.5 m", "-0.1 um"]}, **level},
        ],
        "supports": [{"on": {"block": "plane"}, "fixed": {}}],
        "phases": [{"name": "slide", "until": {"time": time}}],
        "outputs": [
            {"history": {"name": "slip", "field": "block.displacement", "of": "block", "along": "-35 deg", "every": "5 ms"}},
            {"frames": {"every": "50 ms"}},
        ],
    }


@pytest.fixture
def sliding_block():
    return sliding
