"""Blocks from the files of other tools, and blocks to STL.

Each reader gives a list of dictionaries for ``blocks`` of a scenario::

    scene["blocks"] += riprap.shapes.from_tess("grains.tess", material="granite", name="grain")

The files are read as the keys ``polygons.dxf``, ``polygons.tess``, ``mesh.tess`` and ``mesh.stl`` of a scenario read
them. Files that are broken are a :class:`riprap.ShapeError` with the line or the byte.
"""

from __future__ import annotations

import struct
from collections.abc import Collection, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from . import _riprap
from ._data import Frame
from .errors import ShapeError

Block = dict[str, Any]
_Path = str | PathLike[str]


def from_dxf(
    path: _Path,
    *,
    material: str,
    name: str = "block",
    unit: str | None = "m",
    layers: Collection[str] | None = None,
    sagitta: float | None = 1e-3,
) -> list[Block]:
    """Closed polylines of a DXF drawing as polygons in the plane (x and y of the drawing).

    Reads LWPOLYLINE and POLYLINE of the model space, closed by their flag or by equal ends; open ones are left out, and
    so is what stands in blocks of the drawing (INSERT). Arcs become straight pieces.

    Args:
        path: the drawing, ASCII or binary DXF.
        material: material of the blocks.
        name: blocks are called ``name.1``, ``name.2``, ...
        unit: length of a unit of the drawing, such as ``mm``; None: what the drawing says, m if it says nothing.
        layers: names of layers to read; by default all.
        sagitta: largest distance of an arc from its pieces, in units of the drawing; None: 0.01 of its radius.
    """
    own, lines = _riprap.read_dxf(path, sagitta)
    scale = (own or 1.0) if unit is None else _scale(unit)
    outlines = [points for layer, closed, points in lines if closed and (layers is None or layer in layers)]
    if not outlines:
        where = "" if layers is None else f" on the layers {', '.join(sorted(layers))}"
        raise ShapeError(f"{path} has no closed polylines{where}")
    return [_polygon(f"{name}.{i}", material, points, scale) for i, points in enumerate(outlines, 1)]


def from_tess(path: _Path, *, material: str, name: str = "cell", unit: str = "m") -> list[Block]:
    """Cells of a Neper tessellation (``.tess``): polyhedra in space, polygons in the plane.

    Args:
        path: the file, as ``neper -T`` writes it.
        material: material of the blocks.
        name: blocks are called ``name.1``, ``name.2``, ... by their numbers in Neper.
        unit: length of a unit of the file.
    """
    scale = _scale(unit)
    return [
        _polygon(f"{name}.{number}", material, points, scale)
        if faces is None
        else _solid(f"{name}.{number}", material, points, scale, faces)
        for number, points, faces in _riprap.read_tess(path)
    ]


def from_stl(path: _Path, *, material: str, name: str = "solid", unit: str = "m") -> list[Block]:
    """Closed convex surfaces of an STL file, ASCII or binary, as polyhedra; each connected part is a block.

    Args:
        path: the file.
        material: material of the blocks.
        name: blocks are called ``name.1``, ``name.2``, ...
        unit: length of a unit of the file; STL has none of its own.
    """
    scale = _scale(unit)
    parts = enumerate(_riprap.read_stl(path), 1)
    return [_solid(f"{name}.{i}", material, points, scale, None) for i, points in parts]


# Written here: the library reads STL, but writes surfaces as VTU only.
def to_stl(frame: Frame, path: _Path, *, blocks: Sequence[int] | None = None) -> Path:
    """Writes the surfaces of blocks in space, current positions in m, as binary STL.

    Args:
        frame: a frame in space.
        path: the file.
        blocks: places of blocks in the frame; by default all.
    """
    if not frame.spatial:
        raise ShapeError("STL needs blocks in space, but this frame is in the plane")
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
    # A triangle without an area has no normal: zeros let the reader find it from the corners.
    records["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    records["corners"] = surface
    path = Path(path)
    path.write_bytes(b"blocks of riprap, m".ljust(80) + struct.pack("<I", len(records)) + records.tobytes())
    return path


_STL = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def _scale(unit: str) -> float:
    return _riprap.si(f"1 {unit}")


def _points(points: list[list[float]], scale: float) -> list[list[str]]:
    return [[f"{scale * x!r} m" for x in point] for point in points]


def _polygon(name: str, material: str, points: list[list[float]], scale: float) -> Block:
    return {"name": name, "material": material, "polygon": {"points": _points(points, scale)}}


def _solid(
    name: str, material: str, points: list[list[float]], scale: float, faces: list[list[int]] | None
) -> Block:
    solid: dict[str, Any] = {"vertices": _points(points, scale)}
    if faces is not None:
        solid["faces"] = faces
    return {"name": name, "material": material, "polyhedron": solid}
