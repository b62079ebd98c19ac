"""Discrete-element simulation of blocky rock.

A scenario is a dictionary, a TOML text or a file; a run leaves a run folder; fields and histories are NumPy arrays
with units::

    import riprap

    scenario = riprap.Scenario("slide.toml", set={"interfaces.default.friction_angle": "15 deg"})
    print(scenario.check())
    run = scenario.run(threads=2)
    slip = run.histories()["slip"]
    print(slip[-1], slip.unit)
"""

from . import shapes
from ._data import Field, Fields, Frame, Table
from ._folder import RunFolder
from ._monte_carlo import MonteCarlo, monte_carlo
from ._plot import Picture, plot, shot
from ._riprap import Progress, explain, si, version
from ._results import Muckpile, Removable, RemovableBlock, Runout, Strength, muckpile, removable, runout, strength
from ._run import resume, run
from ._safety import Safety, safety
from ._scenario import Report, Scenario
from ._simulation import Simulation, Value
from ._sweep import Sweep, sweep
from ._trust import Found, Trust, Trusted, find, trust
from ._words import FieldInfo, fields, schema
from .errors import (
    Diagnostic,
    FolderError,
    OutputError,
    PlotError,
    RiprapError,
    RunError,
    ScenarioError,
    ShapeError,
    UnstableError,
)

__version__ = version()

__all__ = [
    "Diagnostic",
    "Field",
    "FieldInfo",
    "Fields",
    "FolderError",
    "Found",
    "Frame",
    "MonteCarlo",
    "Muckpile",
    "OutputError",
    "Picture",
    "PlotError",
    "Progress",
    "Removable",
    "RemovableBlock",
    "Report",
    "RiprapError",
    "RunError",
    "RunFolder",
    "Runout",
    "Safety",
    "Scenario",
    "ScenarioError",
    "ShapeError",
    "Simulation",
    "Strength",
    "Sweep",
    "Table",
    "Trust",
    "Trusted",
    "UnstableError",
    "Value",
    "__version__",
    "explain",
    "fields",
    "find",
    "monte_carlo",
    "muckpile",
    "plot",
    "removable",
    "resume",
    "run",
    "runout",
    "safety",
    "schema",
    "shapes",
    "shot",
    "si",
    "strength",
    "sweep",
    "trust",
]
