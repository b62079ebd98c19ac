"""Blocks from the files of other tools, and blocks to STL.

Each reader gives a list of dictionaries for ``blocks`` of a scenario::

    scene["blocks"] += riprap.shapes.from_tess("grains.tess", material="granite", name="grain")

Files that are broken are a :class:`riprap.ShapeError` with the line or the byte.
"""

from __future__ import annotations

import struct
from collections.abc import Collection, Iterator, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _riprap
from ._data import Frame
from .errors import ShapeError

Block = dict[str, Any]
_Path = str | PathLike[str]

LARGEST = 512 << 20
"""Largest file that is read, bytes."""


def from_dxf(
    path: _Path,
    *,
    material: str,
    name: str = "block",
    unit: str = "m",
    layers: Collection[str] | None = None,
    sagitta: float = 1e-3,
) -> list[Block]:
    """Closed polylines of a DXF drawing as polygons in the plane (x and y of the drawing).

    Needs the package ezdxf. Reads LWPOLYLINE and POLYLINE of the model space, closed by their flag or by equal ends;
    open ones are left out. Arcs become straight pieces.

    Args:
        path: the drawing, ASCII or binary DXF.
        material: material of the blocks.
        name: blocks are called ``name.1``, ``name.2``, ...
        unit: length of a unit of the drawing, such as ``mm``.
        layers: names of layers to read; by default all.
        sagitta: largest distance of an arc from its pieces, in units of the drawing.
    """
    import ezdxf
    from ezdxf.path import make_path

    path = _checked(path)
    try:
        drawing = ezdxf.readfile(path)  # type: ignore[attr-defined]
    except Exception as error:  # A damaged drawing makes the parser raise nearly anything, StopIteration included.
        said = str(error) or "it ends too early"
        raise ShapeError(f"{path} is no DXF drawing that can be read: {said}") from None
    scale = _scale(unit)
    outlines = []
    for entity in drawing.modelspace().query("LWPOLYLINE POLYLINE"):
        if layers is not None and entity.dxf.layer not in layers:
            continue
        if entity.dxftype() == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline):
            continue
        points = np.array([[p.x, p.y] for p in make_path(entity).flattening(sagitta)])
        if len(points) > 3 and np.allclose(points[0], points[-1], rtol=0, atol=1e-9 * np.ptp(points)):
            outlines.append(points[:-1])
    if not outlines:
        where = "" if layers is None else f" on the layers {', '.join(sorted(layers))}"
        raise ShapeError(f"{path} has no closed polylines{where}")
    return [_polygon(f"{name}.{i + 1}", material, scale * points) for i, points in enumerate(outlines)]


def from_tess(path: _Path, *, material: str, name: str = "cell", unit: str = "m") -> list[Block]:
    """Cells of a Neper tessellation (``.tess``): polyhedra in space, polygons in the plane.

    Args:
        path: the file, as ``neper -T`` writes it.
        material: material of the blocks.
        name: blocks are called ``name.1``, ``name.2``, ... by their numbers in Neper.
        unit: length of a unit of the file.
    """
    reader = _Tess(_checked(path))
    scale = _scale(unit)
    reader.expect("***tess")
    dimension = reader.after("**general", 2)[0]
    if dimension not in ("2", "3"):
        raise reader.wrong(f"tessellations of dimension {dimension} have no blocks")
    vertices = {}
    for row in reader.rows("**vertex", 1):
        vertices[reader.integer(row[0])] = scale * np.array([reader.number(word) for word in row[1:4]])
    list(reader.rows("**edge", 1))
    faces = {}
    for row in reader.rows("**face", 4):
        count = reader.integer(row[1])
        faces[reader.integer(row[0])] = reader.known([reader.integer(w) for w in row[2 : 2 + count]], vertices)
    if dimension == "2":
        cells = [(k, np.array([vertices[v][:2] for v in face])) for k, face in faces.items()]
        return [_polygon(f"{name}.{k}", material, points) for k, points in cells]
    blocks = []
    for row in reader.rows("**polyhedron", 1):
        count = reader.integer(row[1])
        signed = [reader.integer(word) for word in row[2 : 2 + count]]
        reader.known([abs(f) for f in signed], faces)
        rings = [faces[f] if f > 0 else faces[-f][::-1] for f in signed]
        corners = sorted({v for ring in rings for v in ring})
        place = {v: i for i, v in enumerate(corners)}
        points = np.array([vertices[v] for v in corners])
        blocks.append(_solid(f"{name}.{row[0]}", material, points, [[place[v] for v in ring] for ring in rings]))
    return blocks


def from_stl(path: _Path, *, material: str, name: str = "solid", unit: str = "m") -> list[Block]:
    """Closed convex surfaces of an STL file, ASCII or binary, as polyhedra; each connected part is a block.

    Args:
        path: the file.
        material: material of the blocks.
        name: blocks are called ``name.1``, ``name.2``, ...
        unit: length of a unit of the file; STL has none of its own.
    """
    path = _checked(path)
    triangles = _stl_triangles(path)
    if not np.isfinite(triangles).all():
        bad = int(np.argmin(np.isfinite(triangles).all(axis=(1, 2))))
        raise ShapeError(f"{path}: triangle {bad + 1} has coordinates that are no numbers")
    size = float(np.ptp(triangles)) or 1.0
    corners, index = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    index = index.reshape(-1, 3)
    blocks = []
    for i, part in enumerate(_parts(index, len(corners))):
        own = np.unique(index[part])
        points = corners[own]
        _closed(path, i, index[part])
        for a, b, c in triangles[part]:
            normal = np.cross(b - a, c - a)
            length = float(np.linalg.norm(normal))
            if length > 0 and float(((points - a) @ normal).max()) > 1e-6 * size * length:
                raise ShapeError(
                    f"{path}: part {i + 1} is not convex, or its triangles are turned inside; blocks are convex: cut it"
                )
        blocks.append(_solid(f"{name}.{i + 1}", material, _scale(unit) * points, None))
    return blocks


def to_stl(frame: Frame, path: _Path, *, blocks: Sequence[int] | None = None) -> Path:
    """Writes the surfaces of blocks in space, current positions in m, as binary STL.

    Args:
        frame: a frame in space.
        path: the file.
        blocks: places of blocks in the frame; by default all.
    """
    if not frame.spatial:
        raise ShapeError("STL is for blocks in space, but this frame lies in the plane")
    triangles = []
    for block in range(frame.n_blocks) if blocks is None else blocks:
        corners = np.asarray(frame.corners(block))
        for face in frame.faces(block):
            ring = corners[np.asarray(face)]
            triangles += [(ring[0], ring[k], ring[k + 1]) for k in range(1, len(ring) - 1)]
    surface = np.array(triangles, float).reshape(-1, 3, 3)
    normals = np.cross(surface[:, 1] - surface[:, 0], surface[:, 2] - surface[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(surface), _STL)
    records["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    records["corners"] = surface
    path = Path(path)
    path.write_bytes(b"blocks of riprap, m".ljust(80) + struct.pack("<I", len(records)) + records.tobytes())
    return path


_STL = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def _checked(path: _Path) -> Path:
    path = Path(path)
    try:
        size = path.stat().st_size
    except OSError as error:
        raise ShapeError(f"{path} cannot be read: {error}") from None
    if not path.is_file():
        raise ShapeError(f"{path} is no file")
    if size > LARGEST:
        raise ShapeError(f"{path} is larger than {LARGEST >> 20} MiB")
    return path


def _scale(unit: str) -> float:
    return _riprap.si(f"1 {unit}")


def _point(point: NDArray[Any]) -> list[str]:
    return [f"{float(x)!r} m" for x in point]


def _polygon(name: str, material: str, points: NDArray[Any]) -> Block:
    return {"name": name, "material": material, "polygon": {"points": [_point(p) for p in points]}}


def _solid(name: str, material: str, points: NDArray[Any], faces: list[list[int]] | None) -> Block:
    solid: dict[str, Any] = {"vertices": [_point(p) for p in points]}
    if faces is not None:
        solid["faces"] = faces
    return {"name": name, "material": material, "polyhedron": solid}


def _stl_triangles(path: Path) -> NDArray[np.float64]:
    """Shape (triangles, 3, 3)."""
    data = path.read_bytes()
    if len(data) >= 84:
        count = struct.unpack_from("<I", data, 80)[0]
        if len(data) == 84 + 50 * count:
            if count == 0:
                raise ShapeError(f"{path} has no triangles")
            return np.frombuffer(data, _STL, count, 84)["corners"].astype(float)
    if not data.lstrip().startswith(b"solid"):
        expected = "" if len(data) < 84 else f": {count} triangles need {84 + 50 * count} bytes"
        raise ShapeError(f"{path} is no STL file, or cut off at byte {len(data)}{expected}")
    corners: list[list[float]] = []
    for number, line in enumerate(data.decode("utf-8", "replace").splitlines(), 1):
        words = line.split()
        if not words or words[0] != "vertex":
            continue
        try:
            x, y, z = (float(word) for word in words[1:])
        except ValueError:
            raise ShapeError(f"{path} line {number}: `vertex` and three numbers are expected") from None
        corners.append([x, y, z])
    if not corners or len(corners) % 3 or b"endsolid" not in data:
        raise ShapeError(f"{path} is cut off at byte {len(data)}: {len(corners)} corners, no whole triangles or no end")
    return np.array(corners).reshape(-1, 3, 3)


def _parts(index: NDArray[Any], corners: int) -> list[NDArray[Any]]:
    """Triangles of each connected part, in the order of their first triangle."""
    root = np.arange(corners)
    while True:
        low = root[index].min(axis=1)
        new = root.copy()
        for k in range(3):
            np.minimum.at(new, index[:, k], low)
        new = new[new]
        if np.array_equal(new, root):
            break
        root = new
    labels = root[index[:, 0]]
    _, first = np.unique(labels, return_index=True)
    return [np.flatnonzero(labels == labels[f]) for f in np.sort(first)]


def _closed(path: Path, part: int, index: NDArray[Any]) -> None:
    """Each edge once in each direction."""
    edges = np.concatenate([index[:, [0, 1]], index[:, [1, 2]], index[:, [2, 0]]])
    there = {(int(a), int(b)) for a, b in edges if a != b}
    lone = sum((b, a) not in there for a, b in there)
    if lone:
        raise ShapeError(f"{path}: part {part + 1} is not closed: {lone} edges have a triangle on one side only")


class _Tess:
    """Lines of a `.tess` file by sections; messages have the line."""

    def __init__(self, path: Path) -> None:
        self._path = path
        try:
            self._lines = path.read_text(encoding="utf-8").splitlines()
        except UnicodeDecodeError as error:
            raise ShapeError(f"{path} is no text: byte {error.start}") from None
        self._at = 0

    def wrong(self, what: str) -> ShapeError:
        return ShapeError(f"{self._path} line {min(self._at, len(self._lines))}: {what}")

    def expect(self, word: str) -> None:
        if not self._lines or self._lines[0].split() != [word]:
            raise ShapeError(f"{self._path} line 1: `{word}` is expected; this is no Neper tessellation")

    def _next(self) -> list[str]:
        while self._at < len(self._lines):
            self._at += 1
            words = self._lines[self._at - 1].split()
            if words:
                return words
        raise self.wrong("the file ends here: it is cut off")

    def section(self, name: str) -> None:
        """Goes to the line after the name of a section."""
        for at, line in enumerate(self._lines):
            if line.strip() == name:
                self._at = at + 1
                return
        self._at = len(self._lines)
        raise self.wrong(f"there is no section {name}: the file is cut off, or its cells are not flat polyhedra")

    def after(self, name: str, count: int) -> list[str]:
        self.section(name)
        words = self._next()
        if len(words) < count:
            raise self.wrong(f"{count} words are expected")
        return words

    def rows(self, name: str, lines: int) -> Iterator[list[str]]:
        """The first line of each entry; entries have ``lines`` lines."""
        total = self.integer(self.after(name, 1)[0])
        if not 0 <= total <= len(self._lines):
            raise self.wrong(f"{total} entries in a file of {len(self._lines)} lines")
        for _ in range(total):
            row = self._next()
            if row[0].startswith("*"):
                raise self.wrong(f"{total} entries were announced, but the next section begins")
            yield row
            for _ in range(lines - 1):
                self._next()

    def integer(self, word: str) -> int:
        try:
            return int(word)
        except ValueError:
            raise self.wrong(f"a whole number is expected, not {word!r}") from None

    def number(self, word: str) -> float:
        try:
            value = float(word)
        except ValueError:
            raise self.wrong(f"a number is expected, not {word!r}") from None
        if not np.isfinite(value):
            raise self.wrong(f"{word} is no coordinate")
        return value

    def known(self, numbers: list[int], there: Collection[int]) -> list[int]:
        for number in numbers:
            if number not in there:
                raise self.wrong(f"there is no {number}")
        if len(numbers) < 3:
            raise self.wrong("three or more are expected")
        return numbers
