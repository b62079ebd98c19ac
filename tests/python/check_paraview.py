"""Runs the state script of a run folder without ParaView and checks what it asks for.

`paraview.simple` is a stand-in with the names of ParaView 5.11 that the script may use; objects take any property, so that
what is tested is that the script runs to its end, opens files that are there, and names arrays that the frames have.
"""

import runpy
import sys
import types
from pathlib import Path

SIMPLE = [
    "AnnotateTimeFilter", "CellDatatoPointData", "Clip", "ColorBy", "GetActiveViewOrCreate", "GetAnimationScene",
    "GetColorTransferFunction", "GetScalarBar", "Glyph", "Hide", "PVDReader", "PythonAnnotation", "Render", "ResetCamera",
    "SaveScreenshot", "Show", "WarpByVector", "XMLUnstructuredGridReader", "_DisableFirstRenderCameraReset",
]


class Anything:
    """Takes every property and method."""

    def __init__(self, **given):
        self.__dict__.update(given)

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        if name.startswith("Camera"):
            return [0.0, 0.0, 0.0]
        return Anything()

    def __setattr__(self, name, value):
        # `ClipType = "Plane"` makes an object with properties of its own.
        pass

    def __call__(self, *_, **given):
        return Anything(**given)


def check(folder, on_blocks, on_contacts):
    """The numbers of the script, after it has run; AssertionError says what is wrong."""
    script = Path(folder) / "paraview_state.py"
    used, opened = [], []

    def record(name):
        def call(*args, **given):
            if name == "ColorBy" and args[1][1] is not None:
                used.append((args[1][0], args[1][1]))
            if "FileName" in given:
                opened.extend([given["FileName"]] if isinstance(given["FileName"], str) else given["FileName"])
            return Anything(**given)

        return call

    package, simple = types.ModuleType("paraview"), types.ModuleType("paraview.simple")
    for name in SIMPLE:
        setattr(simple, name, record(name))
    package.simple = simple
    simple.paraview = package
    simple.__all__ = [n for n in SIMPLE if not n.startswith("_")] + ["paraview"]
    before = {n: sys.modules.get(n) for n in ("paraview", "paraview.simple")}
    sys.modules.update({"paraview": package, "paraview.simple": simple})
    arguments, sys.argv = sys.argv, [str(script)]
    try:
        settings = runpy.run_path(str(script))
    finally:
        sys.argv = arguments
        for name, module in before.items():
            sys.modules.pop(name) if module is None else sys.modules.update({name: module})
    assert opened, f"{script} opens nothing"
    missing = [f for f in opened if not Path(f).is_file()]
    assert not missing, f"{script} opens {missing}, which are not there"
    for association, name in used:
        there = on_blocks if association == "CELLS" else on_contacts
        assert name in there or name == "opening", f"{script} colours by {name}, which no frame has"
    assert set(settings["VECTORS"]) <= set(on_blocks), f"{script}: {settings['VECTORS']} are not all in the frames"
    assert settings["LONGEST_FORCE"] == 0.0 or "force_on_a" in on_contacts, f"{script}: the frames have no force_on_a"
    return settings
