# Opens the run beside this file in ParaView: File > Load State, or
#     paraview --script=RUN/paraview_state.py
#     pvpython RUN/paraview_state.py picture.png       (one picture of the last frame, without a window)
#
# Written by riprap (`riprap paraview RUN`); change it as you like. Tried with ParaView 5.11.0.

import os
import sys

from paraview.simple import *

HERE = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
#SETTINGS#

paraview.simple._DisableFirstRenderCameraReset()


def opened(name, files):
    """Reader of a series of the run; None if the run has none."""
    path = os.path.join(HERE, name)
    if not os.path.exists(path):
        return None
    if BY_STEP:
        # Model time stands still in static phases: frames are counted instead.
        paths = [os.path.join(HERE, "frames", f"{files}_{number:06}.vtu") for number in FRAMES]
        if not all(os.path.exists(p) for p in paths):
            return None
        reader = XMLUnstructuredGridReader(registrationName=name, FileName=paths)
        reader.TimeArray = "None"
    else:
        reader = PVDReader(registrationName=name, FileName=path)
    reader.UpdatePipeline()
    return reader


def coloured(display, array, title, colours="Viridis (matplotlib)", place=0):
    """Colours by an array on cells, vectors by length, with one range for all times."""
    ColorBy(display, ("CELLS", array, "Magnitude") if array in VECTORS else ("CELLS", array))
    table = GetColorTransferFunction(array)
    table.AutomaticRescaleRangeMode = "Never"
    table.ApplyPreset(colours, True)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor, bar.LabelColor = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    bar.TitleFontSize, bar.LabelFontSize = 14, 12
    bar.WindowLocation = "Any Location"
    bar.Position = [0.88, 0.08 + 0.46 * place]
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.32, 14
    bar.RangeLabelFormat = "%-#.3g"
    bar.AutomaticLabelFormat, bar.LabelFormat = 0, "%-#.3g"
    display.SetScalarBarVisibility(view, True)


def ranged(array):
    """Sets the range of an array; last, because showing an object takes that of its first frame."""
    low, high = RANGES.get(array, (0.0, 0.0))
    if high > low:
        GetColorTransferFunction(array).RescaleTransferFunction(low, high)


view = GetActiveViewOrCreate("RenderView")
picture = sys.argv[1] if len(sys.argv) > 1 and sys.argv[1].endswith(".png") else None
if picture:
    view.ViewSize = [1600, 1000]
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]

blocks = opened("run.pvd", "frame")
if blocks is None:
    raise SystemExit("run.pvd or frames are missing beside this script: it belongs into the run folder")

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
if PLANAR:
    # Without light: the colours are those of the legend.
    surface.Ambient, surface.Diffuse = 1.0, 0.0
coloured(surface, COLOUR, f"{COLOUR} [{UNITS.get(COLOUR, '-')}]")

# Cracks between deformable blocks: opening, over the blocks made glassy.
cracks = opened("cracks.pvd", "cracks") if CRACKED else None
if cracks is not None:
    surface.Opacity = 0.25
    faces = Show(cracks, view)
    faces.Representation = "Surface With Edges"
    coloured(faces, "opening", "crack opening [m]", "Black-Body Radiation", 1)

# Forces of contacts as arrows, hidden at first: click the eye beside "forces".
contacts = opened("contacts.pvd", "contacts")
if contacts is not None and LONGEST_FORCE > 0.0:
    forces = Glyph(registrationName="forces", Input=contacts, GlyphType="Arrow")
    forces.OrientationArray = ["POINTS", "force_on_a"]
    forces.ScaleArray = ["POINTS", "force_on_a"]
    forces.ScaleFactor = 0.05 * SIZE / LONGEST_FORCE
    forces.GlyphMode = "All Points"
    arrows = Show(forces, view)
    ColorBy(arrows, ("POINTS", None))
    arrows.AmbientColor = arrows.DiffuseColor = [0.8, 0.2, 0.1]
    Hide(forces, view)

# A flat cut through the middle, hidden at first.
if not PLANAR:
    cut = Clip(registrationName="cut", Input=shown)
    cut.ClipType = "Plane"
    cut.ClipType.Origin = CENTRE
    cut.ClipType.Normal = [0.0, 1.0, 0.0]
    half = Show(cut, view)
    half.Representation = "Surface"
    ColorBy(half, ("CELLS", COLOUR, "Magnitude") if COLOUR in VECTORS else ("CELLS", COLOUR))
    Hide(cut, view)
    Show(shown, view)

scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()
if BY_STEP:
    annotation = PythonAnnotation(registrationName="time", Input=blocks)
    annotation.ArrayAssociation = "Point Data"
    annotation.Expression = f"{MOMENTS!r}[int(t_index)]"
else:
    annotation = AnnotateTimeFilter(registrationName="time", Input=blocks)
    annotation.Format = "t = {time:.4g} s"
label = Show(annotation, view)
label.Color = [0.0, 0.0, 0.0]
label.FontSize = 14
for array in [COLOUR] + (["opening"] if cracks is not None else []):
    ranged(array)

if PLANAR:
    view.InteractionMode = "2D"
    view.CameraPosition = [CENTRE[0], CENTRE[1], 10.0 * SIZE]
    view.CameraFocalPoint = CENTRE
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraParallelProjection = 1
    ResetCamera(view)
else:
    view.CameraPosition = [CENTRE[0] - 0.8 * SIZE, CENTRE[1] - 1.6 * SIZE, CENTRE[2] + 0.9 * SIZE]
    view.CameraFocalPoint = CENTRE
    view.CameraViewUp = [0.0, 0.0, 1.0]
    ResetCamera(view)
    # Room for the legend.
    view.CameraPosition = [c + 1.1 * (p - c) for p, c in zip(view.CameraPosition, view.CameraFocalPoint)]
Render(view)

if picture:
    SaveScreenshot(picture, view, ImageResolution=view.ViewSize)
