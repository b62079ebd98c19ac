"""Reads every frame of a run folder with VTK and closes with `N passed, N failed, N skipped`.

Usage: python check_vtu.py RUN_FOLDER
"""

import math
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def problems_of_frame(path):
    """Returns what is wrong with one .vtu file, as a list of sentences."""
    reader = vtkXMLUnstructuredGridReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("VTK reports an error"))
    reader.SetFileName(str(path))
    reader.Update()
    if errors or reader.GetErrorCode() != 0:
        return errors or [f"VTK error code {reader.GetErrorCode()}"]
    grid = reader.GetOutput()
    found = []
    if grid.GetNumberOfCells() == 0 or grid.GetNumberOfPoints() == 0:
        found.append("no cells or no points")
    if not all(math.isfinite(b) for b in grid.GetBounds()):
        found.append("bounds are not finite")
    for i in range(grid.GetNumberOfCells()):
        if grid.GetCell(i).GetNumberOfPoints() < 3:
            found.append(f"cell {i} has fewer than 3 points")
            break
    for where, data, count in (
        ("cell", grid.GetCellData(), grid.GetNumberOfCells()),
        ("point", grid.GetPointData(), grid.GetNumberOfPoints()),
    ):
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            if array is None:
                continue  # strings
            name = array.GetName()
            if array.GetNumberOfTuples() != count:
                found.append(f"{where} array {name}: {array.GetNumberOfTuples()} values for {count}")
            for c in range(array.GetNumberOfComponents()):
                if count and not all(math.isfinite(v) for v in array.GetRange(c)):
                    found.append(f"{where} array {name} is not finite")
    return found


def problems_of_series(path):
    """Returns what is wrong with one .pvd file."""
    sets = xml.parse(path).getroot().findall("./Collection/DataSet")
    if not sets:
        return ["no frames listed"]
    times = [float(s.get("timestep")) for s in sets]
    found = [] if times == sorted(times) else ["times do not ascend"]
    found += [f"{s.get('file')} is missing" for s in sets if not (path.parent / s.get("file")).exists()]
    return found


def main():
    folder = Path(sys.argv[1])
    frames, series = sorted(folder.rglob("*.vtu")), sorted(folder.rglob("*.pvd"))
    print(f"VTK {vtkVersion.GetVTKVersion()}: {len(frames)} frames, {len(series)} series in {folder}")
    failed = 0
    for path, problems in [(p, problems_of_frame(p)) for p in frames] + [
        (p, problems_of_series(p)) for p in series
    ]:
        for problem in problems:
            print(f"{path}: {problem}")
        failed += bool(problems)
    if not frames or not series:
        print("frames/*.vtu and a .pvd were expected")
        failed += 1
    print(f"{len(frames) + len(series) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


sys.exit(main())
