"""What can go wrong. Every exception of riprap is a :class:`RiprapError`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

__all__ = [
    "Diagnostic",
    "FolderError",
    "OutputError",
    "PlotError",
    "RiprapError",
    "RunError",
    "ScenarioError",
    "ShapeError",
    "UnstableError",
]


@dataclass(frozen=True)
class Diagnostic:
    """One remark about a scenario, with its place.

    ``line`` and ``column`` count from 1 and are None where the remark is not about a place. A scenario that was given
    as a dictionary has the places of its TOML text (``Scenario.text``).
    """

    severity: str
    """``error`` or ``warning``."""
    code: str
    """Stable name of the kind of remark, such as ``unit.dimension``."""
    message: str
    help: str | None
    label: str | None
    file: str
    line: int | None
    column: int | None
    text: str
    """The whole remark as the command line prints it, with the line and a mark under the place."""

    def __str__(self) -> str:
        return self.text


class RiprapError(Exception):
    """Any error of riprap."""


class ScenarioError(RiprapError, ValueError):
    """A scenario that cannot be used; the text is that of the command line, all remarks with their lines."""

    def __init__(self, text: str, diagnostics: Iterable[Mapping[str, Any]] = ()) -> None:
        super().__init__(text)
        self.diagnostics: list[Diagnostic] = [Diagnostic(**entry) for entry in diagnostics]
        """The remarks one by one."""


class RunError(RiprapError):
    """A run that cannot be carried out: its folder is taken, nothing to resume, no such block."""


class UnstableError(RunError, ArithmeticError):
    """The physics stopped the run; ``folder`` has its results up to there."""

    def __init__(self, text: str, folder: Any = None) -> None:
        super().__init__(text)
        self.folder = folder


class OutputError(RiprapError, OSError):
    """Results could not be written."""

    def __init__(self, text: str) -> None:
        super().__init__(text)


class FolderError(RiprapError):
    """A run folder, or a file in it, that cannot be read."""


class ShapeError(RiprapError, ValueError):
    """A file of shapes that cannot be read; the message has the line or the byte."""


class PlotError(RiprapError, ValueError):
    """A picture that cannot be drawn from this run."""
