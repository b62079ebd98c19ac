"""Scenarios: what is to be computed."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _riprap
from .errors import Diagnostic

if TYPE_CHECKING:
    from ._folder import RunFolder
    from ._sweep import Sweep

NAME = "<scenario>"
"""What a scenario without a file is called in messages."""


@dataclass(frozen=True)
class Report:
    """What :meth:`Scenario.check` found; ``str()`` has the warnings."""

    title: str
    model: dict[str, Any]
    """Counts and sizes of the model (the keys of ``riprap check --json``)."""
    expected: dict[str, Any]
    """Time step, its block, number of steps, expected CPU time on one thread."""
    warnings: list[Diagnostic]
    input_hash: str
    text: str
    """The scenario of this case alone, TOML."""

    def __str__(self) -> str:
        steps = self.expected.get("steps")
        head = (
            f"{self.title}: {self.expected.get('blocks')} blocks, time step {self.expected.get('time_step'):.3g} s, "
            f"{'unknown number of' if steps is None else steps} steps, {len(self.warnings)} warnings"
        )
        return "\n".join([head, *(w.text for w in self.warnings)])


class Scenario:
    """A scenario: a dictionary, a TOML text or a TOML file.

    A dictionary has the tables of the TOML language as nested dictionaries and lists; quantities are texts with units
    (``"2600 kg/m3"``). Keys whose value is None are left out; NumPy numbers and arrays stand for numbers and lists.

    Args:
        source: dictionary, path of a ``.toml`` file, or TOML text. A text with a line break is TOML; of the others
            those that end in ``.toml`` or are there as a file are paths, and the rest is TOML if it has an equals sign.
        set: keys to change, ``{"interfaces.default.friction_angle": "30 deg"}``, as ``--set`` does.
        folder: folder from which relative paths in the scenario are seen; by default that of the file, or the
            working folder.
        name: what to call the scenario in messages and in the manifest; by default the file.

    Raises:
        ScenarioError: the text is wrong; the message has file, line and what to do.
    """

    def __init__(
        self,
        source: "Mapping[str, Any] | str | PathLike[str]",
        *,
        set: Mapping[str, Any] | None = None,
        folder: str | PathLike[str] | None = None,
        name: str | None = None,
    ) -> None:
        changes = [(key, _riprap.to_value(value)) for key, value in (set or {}).items()]
        if isinstance(source, Mapping):
            text: str | None = _riprap.to_toml(dict(source))
        elif isinstance(source, str) and _is_toml(source):
            text = source
        else:
            text = None
        if text is not None:
            self._scene = _riprap.Scene.parse(text, name or NAME, Path(folder or "."), changes)
            self._file: Path | None = None
        elif folder is None and name is None:
            self._file = Path(fspath(source))  # type: ignore[arg-type]
            self._scene = _riprap.Scene.load(self._file, changes)
        else:
            raise TypeError("folder and name apply to dictionaries and texts; a file has its own")

    @classmethod
    def from_file(cls, path: str | PathLike[str], *, set: Mapping[str, Any] | None = None) -> "Scenario":
        """Reads a TOML file."""
        return cls(Path(path), set=set)

    @classmethod
    def from_text(
        cls,
        text: str,
        *,
        set: Mapping[str, Any] | None = None,
        folder: str | PathLike[str] | None = None,
        name: str | None = None,
    ) -> "Scenario":
        """Reads a TOML text."""
        changes = [(key, _riprap.to_value(value)) for key, value in (set or {}).items()]
        self = cls.__new__(cls)
        self._file = None
        self._scene = _riprap.Scene.parse(text, name or NAME, Path(folder or "."), changes)
        return self

    def __repr__(self) -> str:
        return f"Scenario({self.title!r}, {self.space}, {len(self.cases)} cases)"

    @property
    def title(self) -> str:
        """Title."""
        return self._scene.title

    @property
    def space(self) -> str:
        """``planar`` or ``spatial``."""
        return self._scene.space

    @property
    def text(self) -> str:
        """The scenario as TOML, with all changes."""
        return self._scene.text

    @property
    def cases(self) -> list[str]:
        """Names of the cases: variants and combinations of swept values."""
        return self._scene.cases

    @property
    def file(self) -> Path | None:
        """The file it was read from."""
        return self._file

    def with_set(self, set: Mapping[str, Any]) -> "Scenario":
        """The same scenario with keys changed: ``{"interfaces.default.friction_angle": "30 deg"}``."""
        return Scenario.from_text(self.text, set=set, folder=self._scene.folder, name=self._scene.name)

    def with_sweep(self, over: Mapping[str, Any]) -> "Scenario":
        """The same scenario with a sweep: ``{"interfaces.default.friction_angle": ["10 deg", "20 deg"]}``.

        Replaces the sweep of the scenario, if it has one; several keys give all combinations.
        """
        text = _riprap.with_table(self.text, "sweep", dict(over))
        return Scenario.from_text(text, folder=self._scene.folder, name=self._scene.name)

    def alone(self) -> "Scenario":
        """The scenario as it stands, without its sweep, its variants and their checks: one case."""
        return Scenario.from_text(self._scene.plain_text, folder=self._scene.folder, name=self._scene.name)

    def save(self, path: str | PathLike[str]) -> Path:
        """Writes the TOML text; ``riprap run`` takes the file as it is."""
        path = Path(path)
        path.write_text(self.text, encoding="utf-8")
        return path

    def check(self, case: str | None = None) -> Report:
        """Builds the model and tries a few steps.

        Raises:
            ScenarioError: the model cannot be built; the message has file, line and what to do.
        """
        found = self._scene.check(case)
        return Report(
            title=self.title,
            model=json.loads(found["model"]),
            expected=json.loads(found["expected"]),
            warnings=[Diagnostic(**entry) for entry in found["warnings"]],
            input_hash=found["input_hash"],
            text=found["resolved"],
        )

    def run(
        self,
        out: str | PathLike[str] | None = None,
        *,
        case: str | None = None,
        threads: int | None = None,
        progress: bool | None = None,
        callback: "Callable[[_riprap.Progress], object] | None" = None,
        existing: str = "refuse",
        strict: bool = True,
    ) -> "RunFolder":
        """Runs it; see :func:`riprap.run`."""
        from ._run import run

        return run(
            self,
            out,
            case=case,
            threads=threads,
            progress=progress,
            callback=callback,
            existing=existing,
            strict=strict,
        )

    def sweep(self, out: str | PathLike[str] | None = None, **options: Any) -> "Sweep":
        """Runs all its cases; see :func:`riprap.sweep`."""
        from ._sweep import sweep

        return sweep(self, out, **options)


def _is_toml(text: str) -> bool:
    """Whether a text is TOML and no path: folders of sweeps have equals signs in their names."""
    if "\n" in text:
        return True
    return "=" in text and not text.endswith(".toml") and not os.path.isfile(text)


def scenario(source: "Scenario | Mapping[str, Any] | str | PathLike[str]") -> Scenario:
    """A scenario of whatever stands for one."""
    return source if isinstance(source, Scenario) else Scenario(source)


def default_folder(of: Scenario, kind: str) -> Path:
    """``hill.run`` in the working folder for ``hill.toml``, or the next name that is free."""
    stem = of.file.stem if of.file is not None else "scenario"
    return _riprap.free_folder(Path(f"{stem}.{kind}"))
