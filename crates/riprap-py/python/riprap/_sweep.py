"""All cases of a scenario."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Iterator, Mapping
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _riprap
from ._folder import RunFolder
from ._scenario import Scenario, default_folder, scenario

if TYPE_CHECKING:
    import pandas as pd


class Sweep(Mapping[str, RunFolder]):
    """The runs of a sweep by the names of their cases, and the table of what came out."""

    def __init__(self, path: Path, text: str) -> None:
        self.path = path
        self.csv = text
        """The table as CSV, also in ``sweep.csv``."""
        self.rows: list[dict[str, str]] = list(csv.DictReader(io.StringIO(text)))
        """One dictionary for each case: changed keys, how it ended, last values of the histories, checks."""

    def __getitem__(self, case: str) -> RunFolder:
        if all(row["case"] != case for row in self.rows):
            raise KeyError(f"unknown case {case!r} (valid cases: {', '.join(self)})")
        return RunFolder(self.path / case)

    def __iter__(self) -> Iterator[str]:
        return iter(row["case"] for row in self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    def __repr__(self) -> str:
        done = sum(row["ended"] == "finished" for row in self.rows)
        return f"Sweep({str(self.path)!r}, {done} of {len(self)} cases finished)"

    def numbers(self, name: str) -> dict[str, float]:
        """One number for each case that has it: the last value of a history, by its name."""
        heads = list(self.rows[0]) if self.rows else []
        # A history is known by its name alone, heads have the unit behind it.
        column = next((head for head in heads if name in (head, head.rsplit(" [", 1)[0])), None)
        if column is None:
            raise KeyError(f"unknown column {name!r} (valid columns: {', '.join(heads)})")
        return {row["case"]: float(row[column]) for row in self.rows if row[column]}

    def to_pandas(self) -> "pd.DataFrame":
        """The table in pandas."""
        import pandas as pd

        return pd.read_csv(io.StringIO(self.csv))

    def table(self) -> Any:
        """The table in pandas if that is installed, otherwise :attr:`rows`."""
        try:
            return self.to_pandas()
        except ImportError:
            return self.rows


def sweep(
    source: "Scenario | Mapping[str, Any] | str | PathLike[str]",
    out: str | PathLike[str] | None = None,
    *,
    over: Mapping[str, Any] | None = None,
    jobs: int | None = None,
    existing: str = "refuse",
    progress: bool = False,
) -> Sweep:
    """Runs all cases of a scenario side by side, each on one thread and into its own sub-folder.

    After Ctrl-C too ``sweep.csv`` has a row for each case, with what was done. Into the folder of an earlier sweep: cases that have
    finished there with the same input, by the same version of the program, are kept and not run again, and rows of other cases stay in
    ``sweep.csv``.

    Args:
        source: a scenario, or what makes one.
        out: the folder; by default ``NAME.sweep`` in the working folder.
        over: values to sweep, ``{"interfaces.default.friction_angle": ["10 deg", "20 deg"]}``, of the scenario as it
            stands; by default all cases of the scenario, its variants included.
        jobs: runs at a time; by default as many as there are processors.
        existing: what to do with case folders that are not empty: ``refuse``, ``replace`` or ``force``.
        progress: print a line after each case.

    Raises:
        ScenarioError: a case cannot be built; nothing has been run then.
    """
    what = scenario(source)
    if over is not None:
        what = what.alone().with_sweep(over)
    folder = Path(out) if out is not None else default_folder(what, "sweep")
    total = len(what.cases)
    done = 0

    def report(case: str, ended: str, steps: int) -> None:
        nonlocal done
        done += 1
        print(f"{done}/{total} {case}: {ended} after {steps} steps")

    jobs = jobs if jobs is not None else (os.cpu_count() or 1)
    text = _riprap.sweep(what._scene, folder, existing, max(jobs, 1), report if progress else None)
    return Sweep(folder, text)
