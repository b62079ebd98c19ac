"""Opens the frames of a run folder with the real VTK and checks what it sees.

usage: python check_vtk.py RUNFOLDER...      (needs: pip install vtk)

For each time of run.pvd and contacts.pvd: the file is listed once, VTK reads it without an error, TimeValue is the
time of the list, cells are polygons with positive area (VTK's own area against the shoelace formula), contacts are
vertices, every array is finite, has a value for each item and carries its unit, and ParaView's usual steps
(threshold, warp by a vector) work on it. If the folder holds expected.json (written by
`cargo run -p riprap --example record_sample`), numbers of cells, areas and ranges must agree with it. If it holds
paraview_state.py, that script must run and name arrays that are there (check_paraview.py).
Closes with `N passed, N failed, 0 skipped` (one check a file); exit code 1 if anything is wrong.
"""

import json
import math
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from check_paraview import check as check_paraview
from vtkmodules.vtkCommonCore import vtkDataArray, vtkIdList, vtkVersion
from vtkmodules.vtkCommonDataModel import VTK_POLYGON, VTK_VERTEX, vtkDataObject
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkWarpVector
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


class Wrong(Exception):
    """What VTK sees is not what the run folder promises."""


def need(condition, text):
    if not condition:
        raise Wrong(text)


def entries(pvd):
    """(time, path) of each data set of a .pvd file."""
    root = ElementTree.parse(pvd).getroot()
    need(root.get("type") == "Collection", f"{pvd}: not a collection")
    found = [(float(d.get("timestep")), pvd.parent / d.get("file")) for d in root.iter("DataSet")]
    times = [t for t, _ in found]
    need(times == sorted(times), f"{pvd}: times are not in order")
    need(len({f for _, f in found}) == len(found), f"{pvd}: a file is listed twice")
    return found


def load(path):
    errors = []
    reader = vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    need(path.is_file(), f"{path}: listed but missing")
    need(reader.CanReadFile(str(path)), f"{path}: VTK cannot read it")
    reader.SetFileName(str(path))
    reader.Update()
    need(not errors, f"{path}: VTK reports an error")
    return reader.GetOutput()


def tuples(array):
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


def arrays(data, items, path):
    """Every array of cell or point data as (tuples, unit), checked for shape, finiteness, range and names."""
    found = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        name, values = array.GetName(), tuples(array)
        need(len(values) == items, f"{path}: {name} has {len(values)} values for {items} items")
        need(all(math.isfinite(v) for t in values for v in t), f"{path}: {name} is not finite")
        key = vtkDataArray.UNITS_LABEL()
        unit = array.GetInformation().Get(key) if array.HasInformation() else None
        if array.GetNumberOfComponents() == 3:
            names = [array.GetComponentName(k) for k in range(3)]
            need(names == ["x", "y", "z"], f"{path}: components of {name} are called {names}")
            need(all(t[2] == 0 for t in values), f"{path}: {name} leaves the plane")
        elif items:
            ends = (min(values)[0], max(values)[0])
            need(array.GetRange() == ends, f"{path}: range of {name}: {array.GetRange()}, not {ends}")
        found[name] = (values, unit)
    return found


def shoelace(points):
    turned = zip(points, points[1:] + points[:1])
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in turned)


def points_of(grid):
    return [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]


def close(a, b, rel=1e-12):
    return len(a) == len(b) and all(math.isclose(x, y, rel_tol=rel, abs_tol=1e-12) for x, y in zip(a, b))


def field_data(grid, time, path):
    value = grid.GetFieldData().GetArray("TimeValue")
    need(value is not None, f"{path}: no TimeValue")
    need(value.GetValue(0) == time, f"{path}: TimeValue {value.GetValue(0)} but listed at {time}")
    need(grid.GetFieldData().GetArray("step") is not None, f"{path}: no step")
    need(grid.GetFieldData().GetAbstractArray("phase") is not None, f"{path}: no phase")


def check_blocks(time, path):
    grid = load(path)
    field_data(grid, time, path)
    cells = grid.GetNumberOfCells()
    sound = all(math.isfinite(p[0]) and math.isfinite(p[1]) and p[2] == 0 for p in points_of(grid))
    need(sound, f"{path}: points are not finite or leave the plane")
    found = arrays(grid.GetCellData(), cells, path)
    areas = []
    for i in range(cells):
        cell = grid.GetCell(i)
        need(grid.GetCellType(i) == VTK_POLYGON, f"{path}: cell {i} is no polygon")
        corners = [cell.GetPoints().GetPoint(k) for k in range(cell.GetNumberOfPoints())]
        area = shoelace(corners)
        need(area > 0, f"{path}: block {i} has area {area}")
        # The triangles that VTK draws. Not vtkCellSizeFilter: its fan counts a concave polygon's notch as area.
        ids = vtkIdList()
        need(cell.TriangulateLocalIds(0, ids), f"{path}: VTK cannot triangulate block {i}")
        corner = [corners[ids.GetId(k)] for k in range(ids.GetNumberOfIds())]
        seen = sum(abs(shoelace(corner[k : k + 3])) for k in range(0, len(corner), 3))
        need(math.isclose(seen, area, rel_tol=1e-9), f"{path}: block {i}: VTK area {seen}, shoelace {area}")
        areas.append(area)
    if cells:
        name = next(iter(found))
        threshold = vtkThreshold()
        threshold.SetInputData(grid)
        threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, name)
        threshold.Update()
        need(threshold.GetOutput().GetNumberOfCells() == cells, f"{path}: threshold by {name}")
    return cells, areas, found


def check_contacts(time, path):
    grid = load(path)
    field_data(grid, time, path)
    count = grid.GetNumberOfPoints()
    need(grid.GetNumberOfCells() == count, f"{path}: {count} points, {grid.GetNumberOfCells()} cells")
    need(all(grid.GetCellType(i) == VTK_VERTEX for i in range(count)), f"{path}: not vertices")
    found = arrays(grid.GetPointData(), count, path)
    vectors = [n for n, (v, _) in found.items() if v and len(v[0]) == 3]
    if count and vectors:
        grid.GetPointData().SetActiveVectors(vectors[0])
        warp = vtkWarpVector()
        warp.SetInputData(grid)
        warp.SetScaleFactor(2.0)
        warp.Update()
        ways = zip(points_of(warp.GetOutput()), points_of(grid), found[vectors[0]][0])
        # Warped points are single or double precision, as VTK pleases.
        right = all(close(w, [b + 2.0 * v for b, v in zip(p, t)], 1e-6) for w, p, t in ways)
        need(right, f"{path}: warp by {vectors[0]}")
    return count, found


def largest(values):
    return max((math.hypot(*v) for v in values), default=0.0)


def check_expected(e, seen, path):
    time, areas, on_blocks, count, on_contacts = seen
    need((time, len(areas), count) == (e["time"], e["cells"], e["contacts"]), f"{path}: time or counts")
    need(close(areas, e["areas"]), f"{path}: areas")
    for found, name, unit in ((on_blocks, "displacement", "m"), (on_contacts, "force", "N/m")):
        values, label = found[name]
        need(label == unit, f"{path}: unit of {name} is {label}")
        need(close([largest(values)], [e[name + "_max"]]), f"{path}: largest {name} {largest(values)}")


def check(folder):
    """Checks a folder; returns how many files passed and failed."""
    blocks, contacts = entries(folder / "run.pvd"), entries(folder / "contacts.pvd")
    need([t for t, _ in blocks] == [t for t, _ in contacts], f"{folder}: lists differ in their times")
    expected = None
    if (folder / "expected.json").is_file():
        expected = json.loads((folder / "expected.json").read_text())
        need(len(expected) == len(blocks), f"{folder}: {len(blocks)} frames, expected {len(expected)}")
    units, cells, passed, failed = set(), 0, 2, 0
    for i, ((time, b), (_, c)) in enumerate(zip(blocks, contacts)):
        try:
            cells, areas, on_blocks = check_blocks(time, b)
            count, on_contacts = check_contacts(time, c)
            units |= {f"{n} [{u or '-'}]" for n, (_, u) in (on_blocks | on_contacts).items()}
            if expected:
                check_expected(expected[i], (time, areas, on_blocks, count, on_contacts), b)
            passed += 2
        except Wrong as wrong:
            print(f"WRONG: {wrong}")
            failed += 1
    if (folder / "paraview_state.py").is_file():
        try:
            check_paraview(folder, on_blocks, on_contacts)
            passed += 1
        except AssertionError as wrong:
            print(f"WRONG: {wrong}")
            failed += 1
    what = "as expected" if expected else "read"
    print(f"{folder}: {len(blocks)} frames {what}, {cells} blocks in the last: {', '.join(sorted(units))}")
    return passed, failed


def main(folders):
    if not folders:
        print(__doc__)
        return 2
    print(f"VTK {vtkVersion.GetVTKVersion()}")
    passed = failed = 0
    for folder in folders:
        try:
            p, f = check(Path(folder))
            need(p > 2 or f, f"{folder}: no frames")
            passed, failed = passed + p, failed + f
        except (Wrong, OSError, ElementTree.ParseError) as wrong:
            print(f"WRONG: {wrong}")
            failed += 1
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
