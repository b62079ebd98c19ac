"""All cases of a scenario."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Iterator, Mapping
from concurrent.futures import Executor
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _riprap
from ._folder import RunFolder
from ._scenario import Scenario, default_folder, scenario
from .errors import RunError

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
    executor: "Executor | None" = None,
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
        executor: runs each case as a task of its own instead, such as a ``ProcessPoolExecutor``, the
            ``MPIPoolExecutor`` of mpi4py or ``Client(...).get_executor()`` of dask: any executor whose workers have riprap and
            reach ``out`` under the same path. The numbers are those of a sweep without it.
        existing: what to do with case folders that are not empty: ``refuse``, ``replace`` or ``force``.
        progress: print a line after each case.

    Raises:
        ScenarioError: a case cannot be built; nothing has been run then.
        RunError: tasks were lost by the executor. The same call again goes on: what has finished is kept.
    """
    what = scenario(source)
    if over is not None:
        what = what.alone().with_sweep(over)
    folder = Path(out) if out is not None else default_folder(what, "sweep")
    if executor is not None and jobs is not None:
        raise ValueError("jobs and executor exclude each other: an executor has its own number of workers")
    if executor is not None:
        run_on(executor, what._scene, None, folder, existing, progress)
        return Sweep(folder, _riprap.merged(what._scene, folder)[0])
    report = _Counter(len(what.cases)) if progress else None
    text = _riprap.sweep(what._scene, folder, existing, max(jobs or os.cpu_count() or 1, 1), report)
    return Sweep(folder, text)


class _Counter:
    """Prints a line after each case."""

    def __init__(self, total: int) -> None:
        self.total, self.done = total, 0

    def __call__(self, case: str, ended: str, steps: int) -> None:
        self.done += 1
        print(f"{self.done}/{self.total} {case}: {ended} after {steps} steps")


def run_on(
    executor: Executor,
    scene: "_riprap.Scene",
    samples_of: "tuple[_riprap.Scene, str | None] | None",
    folder: Path,
    existing: str,
    progress: bool,
) -> None:
    """Runs each case of ``scene`` as a task of an executor; a scene of samples is made in the worker from what it was made of."""
    source, case = samples_of if samples_of is not None else (scene, None)
    # The folder of the scene too: a worker may have another working folder.
    what = (source.text, source.name, str(source.folder.resolve()), source.changes, samples_of is not None, case)
    out = str(folder.resolve())
    tasks = [executor.submit(run_case, *what, out, existing, index) for index in range(len(scene.cases))]
    lost: list[str] = []
    first: BaseException | None = None
    for index, task in enumerate(tasks):
        try:
            task.result()
        except Exception as error:  # whatever an executor raises for a lost worker; told below with its type
            lost.append(scene.cases[index])
            first = first or error
        if progress:
            print(f"{index + 1}/{len(tasks)} {scene.cases[index]}{': lost' if lost[-1:] == [scene.cases[index]] else ''}")
    if first is not None:
        # The table says which cases there are.
        _riprap.merged(scene, folder)
        raise RunError(
            f"{len(lost)} of {len(tasks)} cases did not come back from the executor, the first is {lost[0]}: "
            f"{type(first).__name__}: {first}; the same call again keeps the cases that have finished"
        ) from first


def run_case(
    text: str,
    name: str,
    base: str,
    changes: "list[tuple[str, str]]",
    sampled: bool,
    case: "str | None",
    out: str,
    existing: str,
    index: int,
) -> None:
    """One case, in a worker of an executor. A task that is repeated goes on where the lost one stopped, or keeps its result."""
    scene = _riprap.Scene.parse(text, name, Path(base), changes)
    if sampled:
        scene = scene.sampled(case)
    _riprap.sweep(scene, Path(out), existing, 1, None, index)
