"""Arrays with units, tables and frames."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _riprap

if TYPE_CHECKING:
    import pandas as pd
    import pyvista as pv


class Field(np.ndarray):
    """Numbers with a unit.

    A NumPy array with the attributes ``name`` and ``unit`` (``-`` for none). Slices and copies keep both; anything that
    calculates gives a plain array or number, because its unit would be another one.
    """

    name: str
    unit: str

    def __new__(cls, values: NDArray[Any], name: str = "", unit: str = "-") -> "Field":
        field = np.asarray(values).view(cls)
        field.name, field.unit = name, unit
        return field

    def __array_finalize__(self, origin: Any) -> None:
        self.name = getattr(origin, "name", "")
        self.unit = getattr(origin, "unit", "-")

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, out: Any = None, **kwargs: Any) -> Any:
        plain = [np.asarray(x) if isinstance(x, Field) else x for x in inputs]
        if out is not None:
            kwargs["out"] = tuple(np.asarray(x) if isinstance(x, Field) else x for x in out)
        result = getattr(ufunc, method)(*plain, **kwargs)
        return out[0] if out is not None and len(out) == 1 else result

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        return array[()] if return_scalar else np.asarray(array)

    def __reduce__(self) -> Any:
        return (Field, (np.asarray(self), self.name, self.unit))

    @property
    def label(self) -> str:
        """``name [unit]``, for axes and column heads."""
        return f"{self.name} [{self.unit}]" if self.unit not in ("", "-") else self.name


def _missing(kind: str, name: str, known: list[str]) -> KeyError:
    close = difflib.get_close_matches(name, known, n=1)
    hint = f"; did you mean {close[0]!r}?" if close else ""
    return KeyError(f"unknown {kind} {name!r}{hint} (valid names: {', '.join(known) or 'none'})")


class Fields(Mapping[str, Field]):
    """Fields by name, in a fixed order."""

    def __init__(self, columns: Mapping[str, Field], kind: str = "field") -> None:
        self._columns, self._kind = dict(columns), kind

    def __getitem__(self, name: str) -> Field:
        try:
            return self._columns[name]
        except KeyError:
            raise _missing(self._kind, name, list(self._columns)) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(c.label for c in self._columns.values())})"

    @property
    def units(self) -> dict[str, str]:
        """Unit of each field."""
        return {name: column.unit for name, column in self._columns.items()}

    def to_pandas(self) -> "pd.DataFrame":
        """A pandas table; heads are ``name [unit]``, vectors give a column for each component."""
        import pandas as pd

        columns: dict[str, NDArray[Any]] = {}
        for name, column in self._columns.items():
            values = np.asarray(column)
            if values.ndim == 1:
                columns[column.label] = values
                continue
            for k, axis in enumerate("xyz"[: values.shape[1]]):
                columns[Field(values[:, k], f"{name}.{axis}", column.unit).label] = values[:, k]
        return pd.DataFrame(columns, copy=False)


class Table(Fields):
    """A table of a run over time: ``step``, ``time`` and one column for each quantity.

    A cell that was not due at its step is NaN.
    """

    def __init__(self, columns: Mapping[str, Field]) -> None:
        super().__init__(columns, "column")

    @classmethod
    def read(cls, path: Path) -> "Table":
        """Reads a CSV file whose heads are ``name [unit]``; a last line that was truncated does not count."""
        return cls({name: Field(values, name, unit) for name, unit, values in _riprap.read_table(path)})

    @property
    def time(self) -> Field:
        """Model time [s]."""
        return self["time"]

    def series(self, name: str) -> tuple[Field, Field]:
        """Times [s] and values of one column, without the cells that were not due."""
        values = self[name]
        due = ~np.isnan(np.asarray(values))
        return self.time[due], values[due]

    def to_pandas(self, index: str | None = None) -> "pd.DataFrame":
        """A pandas table with heads ``name [unit]``; ``index="time"`` makes a column the index."""
        frame = super().to_pandas()
        return frame if index is None else frame.set_index(self[index].label)


class Frame:
    """Blocks and contacts at one time, in current positions.

    Arrays are snapshots: they do not change when the simulation goes on, and cannot be written to.

    Attributes:
        time: model time [s].
        step: steps done.
        phase: name of the phase.
        points: corners of all blocks [m], global axes, shape (n_points, 3); z = 0 in the plane.
        offsets: block ``i`` owns ``points[offsets[i]:offsets[i + 1]]``, shape (n_blocks + 1,).
        blocks: fields on blocks, shape (n_blocks,) or (n_blocks, 2 or 3).
        contact_points: positions of contacts [m], shape (n_contacts, 3).
        contacts: fields on contacts.
    """

    def __init__(self, parts: Mapping[str, Any]) -> None:
        self.time: float = parts["time"]
        self.step: int = parts["step"]
        self.phase: str = parts["phase"]
        self.points = Field(parts["points"], "points", "m")
        self.offsets: NDArray[np.uint32] = parts["offsets"]
        self.contact_points = Field(parts["contact_points"], "contact_points", "m")
        self._solids: tuple[NDArray[np.uint32], ...] | None = parts["solids"]
        self.blocks = _fields(parts["blocks"], "field on blocks")
        self.contacts = _fields(parts["contacts"], "field on contacts")
        columns = [*self.blocks.values(), *self.contacts.values()]
        for array in (self.points, self.offsets, self.contact_points, *columns):
            # What is written into a snapshot would change no simulation: it raises.
            array.flags.writeable = False

    def __repr__(self) -> str:
        kind = "planar" if self._solids is None else "spatial"
        return f"Frame({kind}, t = {self.time:g} s, {self.n_blocks} blocks, {len(self.contact_points)} contacts)"

    @property
    def spatial(self) -> bool:
        """Whether the blocks are solids in space."""
        return self._solids is not None

    @property
    def n_blocks(self) -> int:
        """Number of blocks."""
        return max(len(self.offsets) - 1, 0)

    def corners(self, block: int) -> Field:
        """Corners of a block [m]; in the plane its outline, anticlockwise."""
        # Counts from the end too, and refuses what is not there: slices would give nothing.
        block = range(self.n_blocks)[block]
        return self.points[self.offsets[block] : self.offsets[block + 1]]

    def faces(self, block: int) -> list[NDArray[Any]]:
        """Faces of a block in space: rows of :meth:`corners`, anticlockwise seen from outside."""
        block = range(self.n_blocks)[block]
        if self._solids is None:
            return [np.arange(len(self.corners(block)))]
        faces, ends, corners = self._solids
        first, last = int(faces[block]), int(faces[block + 1])
        if first == last:
            return [np.array(face) for face in _BRICK]
        return [corners[ends[f] : ends[f + 1]] for f in range(first, last)]

    def to_pandas(self) -> "pd.DataFrame":
        """The fields on blocks as a pandas table."""
        return self.blocks.to_pandas()

    def principal_stresses(self) -> tuple[Field, NDArray[np.float64]]:
        """Principal values of the average stress of each block, and their directions.

        Returns:
            Values [Pa], tension positive, largest first, shape (n_blocks, d), where d is 2 in the plane and 3 in space;
            directions, unit vectors in space, shape (n_blocks, d, 3): ``directions[i, k]`` belongs to ``values[i, k]``.

        Raises:
            KeyError: the frame is of a version before blocks had stresses.
        """
        normal, shear = (np.asarray(self.blocks[f"stress_{part}"]) for part in ("normal", "shear"))
        dimension = normal.shape[1]
        tensor = np.zeros((len(normal), dimension, dimension))
        tensor[:, range(dimension), range(dimension)] = normal
        # In space yz, zx, xy; in the plane xy alone.
        places = [(1, 2), (2, 0), (0, 1)] if dimension == 3 else [(0, 1)]
        for (i, j), values in zip(places, shear.reshape(len(normal), -1).T, strict=True):
            tensor[:, i, j] = tensor[:, j, i] = values
        values, axes = np.linalg.eigh(tensor)
        directions = np.zeros((len(normal), dimension, 3))
        # Columns, and ascending.
        directions[:, :, :dimension] = axes.transpose(0, 2, 1)[:, ::-1]
        return Field(values[:, ::-1].copy(), "principal_stress", "Pa"), directions

    def _principal_arrays(self) -> dict[str, NDArray[Any]]:
        """Cell data of principal stresses; none where the frame has no stress."""
        if "stress_normal" not in self.blocks:
            return {}
        values, directions = self.principal_stresses()
        arrays: dict[str, NDArray[Any]] = {}
        for k in range(directions.shape[1]):
            arrays[f"principal_stress_{k + 1} [Pa]"] = np.asarray(values)[:, k].copy()
            arrays[f"principal_direction_{k + 1}"] = directions[:, k].copy()
        return arrays

    def to_pyvista(self) -> "pv.UnstructuredGrid":
        """The blocks as a pyvista grid with cell data named ``name [unit]``: polygons, hexahedra or polyhedra.

        Besides the fields it has ``principal_stress_1 [Pa]`` (largest first, tension positive) and ``principal_direction_1``
        and so on, see :meth:`principal_stresses`.
        """
        import pyvista as pv

        cells: list[int] = []
        kinds = np.empty(self.n_blocks, np.uint8)
        for i in range(self.n_blocks):
            first, last = int(self.offsets[i]), int(self.offsets[i + 1])
            solids = self._solids
            if solids is None:
                kinds[i] = pv.CellType.POLYGON
                cells += [last - first, *range(first, last)]
            elif solids[0][i] == solids[0][i + 1]:
                kinds[i] = pv.CellType.HEXAHEDRON
                cells += [8, *range(first, last)]
            else:
                kinds[i] = pv.CellType.POLYHEDRON
                faces = self.faces(i)
                stream = [len(faces)]
                for face in faces:
                    stream += [len(face), *(int(c) + first for c in face)]
                cells += [len(stream), *stream]
        grid = pv.UnstructuredGrid(np.array(cells, np.int64), kinds, np.array(self.points))
        for field in self.blocks.values():
            grid.cell_data[field.label] = _in_space(field)
        for name, values in self._principal_arrays().items():
            grid.cell_data[name] = values
        grid.field_data["TimeValue"] = [self.time]
        return grid

    def contacts_to_pyvista(self) -> "pv.PolyData":
        """The contacts as pyvista points with point data named ``name [unit]``."""
        import pyvista as pv

        cloud = pv.PolyData(np.array(self.contact_points))
        for field in self.contacts.values():
            cloud.point_data[field.label] = _in_space(field)
        return cloud


# Corners in the order of a VTK hexahedron; faces anticlockwise seen from outside.
_BRICK = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (3, 7, 6, 2), (0, 4, 7, 3), (1, 2, 6, 5))


def _fields(columns: Mapping[str, tuple[NDArray[Any], str]], kind: str) -> Fields:
    return Fields({name: Field(values, name, unit) for name, (values, unit) in columns.items()}, kind)


def _in_space(field: Field) -> NDArray[Any]:
    """A copy, as VTK wants to own it; vectors of the plane with a third component of zero, as its filters want them."""
    values = np.array(field)
    if values.ndim == 2 and values.shape[1] == 2:
        return np.column_stack([values, np.zeros(len(values))])
    return values
