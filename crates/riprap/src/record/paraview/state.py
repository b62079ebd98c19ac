# Opens the run beside this file in ParaView: File > Load State, or
#     paraview --script=paraview.py
#     pvpython paraview.py picture.png       (one picture of the last frame, without a window)
#
# Written by riprap (`riprap paraview RUN`); change it as you like. It uses the names of paraview.simple of ParaView 5.11.

import os
import sys

from paraview.simple import *

HERE = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
#SETTINGS#

paraview.simple._DisableFirstRenderCameraReset()


def opened(name):
    """Reader of a series of the run; None if the run has none."""
    path = os.path.join(HERE, name)
    if not os.path.exists(path):
        return None
    reader = PVDReader(registrationName=name, FileName=path)
    reader.UpdatePipeline()
    return reader


def coloured(display, association, array, title, low, high, colours="Viridis (matplotlib)", log=False):
    """Colours by an array, vectors by length, with one range for all times."""
    ColorBy(display, (association, array, "Magnitude") if array in VECTORS else (association, array))
    table = GetColorTransferFunction(array)
    table.ApplyPreset(colours, True)
    if high > low:
        table.RescaleTransferFunction(low, high)
    if log and low > 0.0:
        table.MapControlPointsToLogSpace()
        table.UseLogScale = 1
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    display.SetScalarBarVisibility(view, True)


view = GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]

blocks = opened("run.pvd")
if blocks is None:
    raise SystemExit("no run.pvd beside this script: it belongs into the run folder")

# Blocks, moved by EXAGGERATION times their displacement beyond where they are.
shown = blocks
if EXAGGERATION > 1.0:
    # Arrays on cells must become arrays on points before anything can be warped by them.
    points = CellDatatoPointData(registrationName="points", Input=blocks, PassCellData=1)
    shown = WarpByVector(registrationName="exaggerated", Input=points)
    shown.Vectors = ["POINTS", "displacement"]
    shown.ScaleFactor = EXAGGERATION - 1.0
surface = Show(shown, view)
surface.Representation = "Surface With Edges"
surface.EdgeColor = [0.35, 0.35, 0.35]
low, high = RANGES.get(COLOUR, (0.0, 0.0))
coloured(surface, "CELLS", COLOUR, f"{COLOUR} [{UNITS.get(COLOUR, '-')}]", low, high)

# Cracks between deformable blocks: opening, over the blocks made glassy.
cracks = opened("cracks.pvd")
if cracks is not None:
    surface.Opacity = 0.25
    faces = Show(cracks, view)
    faces.Representation = "Surface"
    low, high = RANGES.get("opening", (0.0, 0.0))
    coloured(faces, "CELLS", "opening", "crack opening [m]", low, high, "Black-Body Radiation")

# Forces of contacts as arrows, hidden at first: click the eye beside "forces".
contacts = opened("contacts.pvd")
if contacts is not None and LONGEST_FORCE > 0.0:
    forces = Glyph(registrationName="forces", Input=contacts, GlyphType="Arrow")
    forces.OrientationArray = ["POINTS", "force_on_a"]
    forces.ScaleArray = ["POINTS", "force_on_a"]
    forces.ScaleFactor = 0.05 * SIZE / LONGEST_FORCE
    forces.GlyphMode = "All Points"
    arrows = Show(forces, view)
    ColorBy(arrows, None)
    arrows.DiffuseColor = [0.8, 0.2, 0.1]
    Hide(forces, view)

# A cut through the middle, hidden at first.
if not PLANAR:
    cut = Clip(registrationName="cut", Input=shown)
    cut.ClipType = "Plane"
    cut.ClipType.Origin = CENTRE
    cut.ClipType.Normal = [0.0, 1.0, 0.0]
    half = Show(cut, view)
    half.Representation = "Surface With Edges"
    ColorBy(half, ("CELLS", COLOUR, "Magnitude") if COLOUR in VECTORS else ("CELLS", COLOUR))
    Hide(cut, view)
    Show(shown, view)

scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()
annotation = AnnotateTimeFilter(registrationName="time", Input=blocks)
annotation.Format = "t = {time:.4g} s"
label = Show(annotation, view)
label.Color = [0.0, 0.0, 0.0]

if PLANAR:
    view.InteractionMode = "2D"
    view.CameraPosition = [CENTRE[0], CENTRE[1], 10.0 * SIZE]
    view.CameraFocalPoint = CENTRE
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.6 * SIZE
else:
    view.CameraPosition = [CENTRE[0] + 0.8 * SIZE, CENTRE[1] - 1.6 * SIZE, CENTRE[2] + 0.9 * SIZE]
    view.CameraFocalPoint = CENTRE
    view.CameraViewUp = [0.0, 0.0, 1.0]
    ResetCamera(view)
Render(view)

if len(sys.argv) > 1 and sys.argv[1].endswith(".png"):
    SaveScreenshot(sys.argv[1], view, ImageResolution=[1600, 1000])
