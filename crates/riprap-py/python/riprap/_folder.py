"""Run folders: everything a run leaves behind."""

from __future__ import annotations

import bisect
import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Mapping
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _riprap
from ._data import Frame, Table
from .errors import FolderError, RunError

if TYPE_CHECKING:
    import pyvista as pv

    from ._scenario import Scenario


class RunFolder:
    """A run folder, finished or not.

    Reads nothing until asked; the manifest is read once (:meth:`refresh` reads it anew).
    """

    def __init__(self, path: str | PathLike[str]) -> None:
        self.path = Path(path)
        self.refresh()

    def refresh(self) -> "RunFolder":
        """Reads the manifest anew, for a run that is going on."""
        file = self.path / "manifest.json"
        try:
            manifest = json.loads(file.read_text(encoding="utf-8"))
        except OSError as error:
            raise FolderError(f"{self.path} is not a run folder: {error}") from None
        except ValueError as error:
            raise FolderError(f"{file} is damaged: {error}") from None
        if not isinstance(manifest, dict) or manifest.get("format") != "riprap-run":
            raise FolderError(f"{file} was not written by a riprap run")
        if manifest.get("format_version", 1) > 1:
            raise FolderError(f"{file} was written by a newer riprap ({manifest.get('riprap')}); update this version")
        self.manifest: dict[str, Any] = manifest
        """The manifest: see the page on run folders for its keys."""
        # More frames may be there by now.
        self.__dict__.pop("_frames", None)
        return self

    def __repr__(self) -> str:
        return f"RunFolder({str(self.path)!r}, {self.ended}, t = {self.manifest.get('time', 0.0):g} s)"

    def _repr_html_(self) -> str:
        from html import escape

        m = self.manifest
        rows = {
            "folder": self.path,
            "title": m.get("title", ""),
            "ended": f"{self.ended} {m.get('message', '')}",
            "steps": m.get("steps", 0),
            "time": f"{m.get('time', 0.0):g} s",
            "wall time": f"{m.get('wall_time', 0.0):.2f} s",
            "state": self.state_hash[:16],
        }
        cells = "".join(f"<tr><th>{k}</th><td>{escape(str(v))}</td></tr>" for k, v in rows.items())
        return f"<table>{cells}</table>"

    @property
    def ended(self) -> str:
        """``running``, ``finished``, ``stopped``, ``interrupted`` or ``unstable``."""
        return str(self.manifest.get("ended", "running"))

    @property
    def finished(self) -> bool:
        """Whether all phases are done."""
        return self.ended == "finished"

    @property
    def state_hash(self) -> str:
        """Hash of the final state: equal hashes mean equal states, bit for bit."""
        return str(self.manifest.get("state_hash", ""))

    @property
    def text(self) -> str:
        """The scenario as it was run, TOML."""
        return self._read("scenario.resolved.toml")

    @property
    def scenario(self) -> "Scenario":
        """The scenario as it was run."""
        from ._scenario import Scenario

        return Scenario.from_file(self.path / "scenario.resolved.toml")

    def histories(self) -> Table:
        """The histories over time; without any the table is empty."""
        file = self.path / "histories.csv"
        return Table.read(file) if file.exists() else Table({})

    def energy(self) -> Table:
        """The energy ledger over time."""
        return Table.read(self.path / "energy.csv")

    def events(self, kind: str | None = None) -> list[dict[str, Any]]:
        """What happened, in order of steps; ``kind`` picks one kind, such as ``joint_broken``."""
        events = self._lines("events.jsonl")
        return events if kind is None else [e for e in events if e.get("event") == kind]

    def checks(self) -> list[dict[str, Any]]:
        """Results of the checks of the scenario: ``check``, ``status``, ``measured``, ``expected`` and more."""
        return self._lines("checks.jsonl") if (self.path / "checks.jsonl").exists() else []

    @property
    def passed(self) -> bool:
        """Whether the run finished and no check failed."""
        return self.finished and all(c.get("status") != "failed" for c in self.checks())

    @property
    def times(self) -> list[float]:
        """Model times of the frames [s]."""
        return [time for time, _ in self._frames]

    def __len__(self) -> int:
        """Number of frames."""
        return len(self._frames)

    def __bool__(self) -> bool:
        # A run without frames is a run all the same, which its length would deny.
        return True

    def frame(self, index: int = -1, *, time: float | None = None) -> Frame:
        """A frame by its place in :attr:`times` (0 is the first, -1 the last), or the one nearest to a time [s]."""
        file = self._frame_file(index, time)
        contacts = file.with_name(file.name.replace("frame_", "contacts_"))
        return Frame(_riprap.read_frame(file, contacts if contacts.exists() else None))

    def frames(self) -> "list[Frame]":
        """All frames. Large runs: take one after the other with :meth:`frame`."""
        return [self.frame(i) for i in range(len(self))]

    def pyvista(self, index: int = -1, *, time: float | None = None) -> "pv.UnstructuredGrid":
        """A frame as a pyvista grid, read from its file by VTK; cell data as in :meth:`Frame.to_pyvista`."""
        import pyvista as pv

        grid = pv.read(self._frame_file(index, time))
        assert isinstance(grid, pv.UnstructuredGrid)
        # The file keeps units beside the names, where VTK does not look.
        frame = self.frame(index, time=time)
        for name, field in frame.blocks.items():
            if field.label != name:
                grid.rename_array(name, field.label, "cell")
        for name, values in frame._principal_arrays().items():
            grid.cell_data[name] = values
        return grid

    def resume(
        self,
        *,
        threads: int | None = None,
        progress: bool | None = None,
        callback: "Callable[[_riprap.Progress], object] | None" = None,
    ) -> "RunFolder":
        """Goes on with a run that was stopped; see :func:`riprap.resume`."""
        from ._run import resume

        return resume(self.path, threads=threads, progress=progress, callback=callback)

    def plot(self, what: str = "histories", *names: str, out: str | PathLike[str] | None = None, **options: Any) -> "Any":
        """Draws a picture; see :func:`riprap.plot`."""
        from ._plot import plot

        return plot(self, what, *names, out=out, **options)

    def shot(self, out: str | PathLike[str] | None = None, **options: Any) -> "Any":
        """Draws the blocks in space; see :func:`riprap.shot`."""
        from ._plot import shot

        return shot(self, out, **options)

    @cached_property
    def _frames(self) -> list[tuple[float, Path]]:
        file = self.path / "run.pvd"
        if not file.exists():
            return []
        try:
            root = ElementTree.parse(file).getroot()
            return [(float(d.attrib["timestep"]), self.path / d.attrib["file"]) for d in root.iter("DataSet")]
        except (ElementTree.ParseError, KeyError, ValueError) as error:
            raise FolderError(f"{file} is damaged: {error}") from None

    def _frame_file(self, index: int, time: float | None) -> Path:
        if not self._frames:
            raise FolderError(f"{self.path} has no frames; request them in the scenario: [[outputs]] with frames")
        if time is not None:
            at = bisect.bisect_left(self.times, time)
            near = range(max(at - 1, 0), min(at + 1, len(self)))
            return self._frames[min(near, key=lambda i: abs(self.times[i] - time))][1]
        try:
            return self._frames[index][1]
        except IndexError:
            raise IndexError(f"there is no frame {index}; the run has {len(self)}, from 0") from None

    def _read(self, name: str) -> str:
        try:
            return (self.path / name).read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise FolderError(f"{self.path / name} cannot be read: {error}") from None

    def _lines(self, name: str) -> list[dict[str, Any]]:
        text = self._read(name)
        # A line without its end does not count: its writer was stopped inside it.
        whole = text[: text.rfind("\n") + 1]
        entries = []
        for i, line in enumerate(whole.splitlines()):
            try:
                entries.append(json.loads(line))
            except ValueError as error:
                raise FolderError(f"{self.path / name} line {i + 1}: {error}") from None
        return entries


def ending(folder: Path, manifest: Mapping[str, Any], strict: bool) -> RunFolder:
    """The folder of a run that has just ended."""
    from .errors import UnstableError

    run = RunFolder(folder)
    if strict and manifest.get("ended") == "unstable":
        raise UnstableError(f"{manifest.get('message')}\n  results up to this point: {folder}", run)
    return run


__all__ = ["RunFolder", "RunError"]
