"""Factors of safety and limits of other numbers."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from . import _riprap
from ._folder import RunFolder
from ._scenario import Scenario, default_folder, scenario


class Safety:
    """What a search for a factor of safety, or for the limit of a quantity, has found."""

    def __init__(self, path: Path, answer: Mapping[str, Any], csv: str, words: str) -> None:
        self.path = path
        """Its folder: ``safety.json``, ``safety.csv``, ``mechanism.run``."""
        self.quantity: str | None = answer["quantity"]
        """The key that was varied; None: the factor of safety."""
        self.unit: str = answer["unit"]
        """SI unit of the values; empty for plain numbers."""
        self.stable_at: float | None = answer["stable_at"]
        """The value nearest to the limit that is stable, SI."""
        self.fails_at: float | None = answer["fails_at"]
        """The value nearest to the limit that fails, SI."""
        self.undecided: bool = answer["undecided"]
        """Whether trials between both were undecided."""
        self.trials: list[dict[str, Any]] = answer["trials"]
        """All trials in order: value, state, moved (m), block, unbalanced, steps, seconds, note."""
        self.moving: dict[str, float] = dict(answer["moving"])
        """Blocks of the mechanism with their displacement in m, the farthest first."""
        self.mechanism: str | None = answer["mechanism"]
        """``sliding``, ``turning`` or ``both``."""
        self.csv = csv
        """The trials as CSV."""
        self.words = words

    def __repr__(self) -> str:
        return f"Safety({self.words.splitlines()[0]!r})"

    @property
    def limit(self) -> float | None:
        """The middle between the stable and the failing value, SI; None where one of them is missing."""
        if self.stable_at is None or self.fails_at is None:
            return None
        return 0.5 * (self.stable_at + self.fails_at)

    @property
    def run(self) -> RunFolder | None:
        """The run in which the mechanism moves."""
        path = self.path / "mechanism.run"
        return RunFolder(path) if path.is_dir() else None


def safety(
    source: "Scenario | Mapping[str, Any] | str | PathLike[str]",
    out: str | PathLike[str] | None = None,
    *,
    case: str | None = None,
    quantity: str | None = None,
    between: "tuple[str | float, str | float] | None" = None,
    width: "str | float | None" = None,
    interfaces: "list[str] | None" = None,
    materials: "list[str] | None" = None,
    groups: "list[str] | None" = None,
    moved: "str | float | None" = None,
    balance: float = 1e-5,
    steps: int = 100_000,
    from_start: bool = False,
    threads: int | None = None,
    existing: str = "refuse",
    progress: bool = False,
) -> Safety:
    """Searches for the factor of safety of a scenario by reduction of strengths, or for the limit of any number of it.

    The answer does not depend on the number of threads, bit for bit. It is on the disk before the mechanism is run: Ctrl-C and errors
    there leave it.

    Args:
        source: a scenario, or what makes one.
        out: the folder; by default ``NAME.safety`` in the working folder.
        case: name of a case; by default the scenario as it stands.
        quantity: a key whose limit is searched for, such as ``blocks.arch.arch.thickness``; by default the factor.
        between: values of the key between which the limit lies, ``("1 m", "1.2 m")``; either may be the one that stands.
        width: width of the answer, of a quantity with its unit; by default 0.01, or a hundredth of the range.
        interfaces: those whose strength is reduced; by default all.
        materials: only strengths between a block of one of these and any other are reduced; by default all.
        groups: the same for groups of blocks.
        moved: displacement from which on a trial may count as failing, m or with its unit; by default a thousandth of a block.
        balance: unbalanced forces over all forces at which a trial is stable.
        steps: steps after which a trial is undecided.
        from_start: run the scenario from its start with reduced strengths in every trial.
        threads: trials at a time; by default as many as there are processors.
        existing: what to do with a folder that is not empty: ``refuse``, ``replace`` or ``force``.
        progress: print a line after each trial.

    Raises:
        ScenarioError: the scenario is wrong, or cannot have a value of the range.
        RunError: the folder is not empty, or the mechanism cannot be run.
        ValueError: there is no strength to reduce, or a range or a width is none.
    """
    if (quantity is None) != (between is None):
        raise ValueError("quantity and between must be given together")
    if quantity is not None and (interfaces or materials or groups or from_start):
        raise ValueError("interfaces, materials, groups and from_start apply to the factor of safety, not to a quantity")
    what = scenario(source)
    folder = Path(out) if out is not None else default_folder(what, "safety")

    def report(trial: str) -> None:
        told = json.loads(trial)
        print(f"{told['value']:.6g} {told['state']} after {told['steps']} steps")

    options = {
        "width": None if width is None else str(width),
        "interfaces": list(interfaces or []),
        "materials": list(materials or []),
        "groups": list(groups or []),
        "moved": moved if moved is None or isinstance(moved, str) else f"{moved} m",
        "balance": balance,
        "steps": steps,
        "from_start": from_start,
        "quantity": None if between is None else (quantity, f"{between[0]}..{between[1]}"),
        "threads": threads if threads is not None else (os.cpu_count() or 1),
    }
    answer, csv, words = _riprap.safety(
        what._scene, case, folder, existing, options, report if progress else None
    )
    return Safety(folder, json.loads(answer), csv, words)
