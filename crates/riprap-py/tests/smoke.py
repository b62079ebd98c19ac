"""The wheel alone, with nothing but NumPy: a run, its histories, a picture. usage: smoke.py RUNFOLDER"""

import sys
from importlib.util import find_spec
from pathlib import Path

import riprap

assert find_spec("pandas") is None and find_spec("pyvista") is None, "this environment is not clean"
text = (Path(__file__).resolve().parents[3] / "scenes/planar/slide.toml").read_text()
run = riprap.run(text, sys.argv[1], threads=2, existing="replace")
slip = run.histories()["slip"]
assert run.passed and slip.unit == "m" and 1.2 < slip[-1] < 1.4, slip
assert run.plot("histories").file(".svg").stat().st_size > 1000
print(f"riprap {riprap.__version__} on Python {sys.version.split()[0]}: slip {slip[-1]:.4f} {slip.unit}")
