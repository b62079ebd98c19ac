"""The error of each result, and values of keys at which results are as wanted."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

from . import _riprap
from ._scenario import Scenario, default_folder, scenario


@dataclass(frozen=True)
class Trusted:
    """A named result with its error."""

    name: str
    """Name of the check, or of the history with ``at the end``."""
    unit: str
    """SI unit; empty for plain numbers."""
    as_run: float
    """The value of the scenario as it stands."""
    value: float
    """The value, extrapolated where an order was seen."""
    error: float
    """Its error."""
    causes: dict[str, float]
    """What each cause adds to the error."""
    chaotic: "dict[str, Any] | None"
    """Samples, mean, deviation, least and largest value where the result is chaotic."""
    advice: str
    """What to change to halve the error."""
    expected: "float | None"
    """What the check expects, if that is one number."""

    @property
    def interval(self) -> tuple[float, float]:
        """Ends of the interval."""
        return self.value - self.error, self.value + self.error

    @property
    def holds(self) -> "bool | None":
        """Whether what the check expects lies inside the interval."""
        return None if self.expected is None else abs(self.expected - self.value) <= self.error


class Trust(Mapping[str, Trusted]):
    """The results of a scenario with their errors, by name."""

    def __init__(self, path: Path, answer: Mapping[str, Any], words: str) -> None:
        self.path = path
        """The folder: ``trust.csv``, ``trials.csv``, ``trust.json``."""
        self.words = words
        """All results in words, with the share of each cause."""
        self.trials: list[dict[str, Any]] = answer["trials"]
        """All runs: cause, factor, values, steps, seconds, note."""
        self.left_out: dict[str, str] = dict(answer["left_out"])
        """Causes that were not varied, and why."""
        self._results = {one["name"]: _result(one) for one in answer["results"]}

    def __getitem__(self, name: str) -> Trusted:
        return self._results[name]

    def __iter__(self) -> Any:
        return iter(self._results)

    def __len__(self) -> int:
        return len(self._results)

    def __repr__(self) -> str:
        return f"Trust({', '.join(self._results)})"


def _result(one: Mapping[str, Any]) -> Trusted:
    # What has no value is null in JSON.
    number = {key: float("nan") if one[key] is None else one[key] for key in ("as_run", "value", "error")}
    causes = {part["cause"]: part["error"] for part in one["parts"]}
    same = {key: one[key] for key in ("name", "unit", "chaotic", "advice", "expected")}
    return Trusted(causes=causes, **number, **same)


def trust(
    source: "Scenario | Mapping[str, Any] | str | PathLike[str]",
    out: str | PathLike[str] | None = None,
    *,
    case: str | None = None,
    safety: bool = False,
    budget: "str | float" = "10min",
    without: "list[str] | None" = None,
    threads: int | None = None,
    existing: str = "refuse",
    progress: bool = False,
) -> Trust:
    """Gives each named result of a scenario (checks, histories at their end) its error.

    The scenario is run as it stands and with one thing changed at a time: time step, limit of equilibrium, stiffness of contacts, damping,
    size and seed of generated cells. Where an order is seen in step or size, the value is extrapolated.

    Args:
        source: a scenario, or what makes one.
        out: the folder; by default ``NAME.trust`` in the working folder.
        case: name of a case; by default the scenario as it stands.
        safety: ask for the factor of safety (one result, ``factor of safety``) instead of the checks and histories; each run is a search.
        budget: wall time for all runs, with its unit or in s; what is forecast to take longer is left out.
        without: causes that are no errors: ``step``, ``equilibrium``, ``stiffness``, ``damping``, ``size``, ``seed``.
        threads: runs at a time; by default as many as there are processors.
        existing: what to do with a folder that is not empty: ``refuse``, ``replace`` or ``force``.
        progress: print a line after each run.

    Raises:
        ScenarioError: the scenario is wrong.
        RunError: the folder is not empty, or the scenario as it stands does not come to its end.
        ValueError: there are no named results, or a cause or a budget is none.
    """
    what = scenario(source)
    folder = Path(out) if out is not None else default_folder(what, "trust")

    def report(trial: str) -> None:
        told = json.loads(trial)
        print(f"{told['cause'] or 'as it stands'} x {told['factor']:g}: {told['steps']} steps {told['note']}".rstrip())

    time = budget if isinstance(budget, str) else f"{budget} s"
    options = (time, list(without or []), threads if threads is not None else (os.cpu_count() or 1), safety)
    answer, words = _riprap.trust(what._scene, case, folder, existing, options, report if progress else None)
    return Trust(folder, json.loads(answer), words)


@dataclass(frozen=True)
class Found:
    """The value of a key at which a result is as wanted, SI."""

    key: str
    unit: str
    """SI unit of the key; empty for plain numbers."""
    at: float
    """The value: linear between the two nearest trials."""
    below: tuple[float, float]
    """Value of the key and result of the nearest trial at or below what is wanted."""
    above: tuple[float, float]
    """The same above."""
    monotone: bool
    """Whether the result rises or falls all along the trials; else other values may give it too."""
    undecided: bool
    """Whether runs inside the range had no result."""


def find(
    source: "Scenario | Mapping[str, Any] | str | PathLike[str]",
    vary: str,
    between: "tuple[str | float, str | float]",
    until: str,
    *,
    case: str | None = None,
    width: "str | None" = None,
    threads: int | None = None,
    progress: bool = False,
) -> Found:
    """Searches for the value of a key at which a named result has a value.

    Args:
        source: a scenario, or what makes one.
        vary: the key, such as ``bolts.0.pretension``.
        between: two values of it, at one of which the result is below, at the other above what is wanted.
        until: the condition: ``"safety = 1.3"``, or a check or a history, ``"slip = 5 cm"``.
        case: name of a case; by default the scenario as it stands.
        width: width of the answer, with its unit; by default a hundredth of the range.
        threads: trials at a time; by default as many as there are processors.
        progress: print a line after each trial.

    Raises:
        ScenarioError: the scenario is wrong, or cannot have a value of the range.
        ValueError: no such result, or the value does not lie between those at the ends (the message has both).
    """
    what = scenario(source)

    def report(value: float, result: "float | None") -> None:
        print(f"{value:.6g}: {'no result' if result is None else format(result, '.6g')}")

    asked = (vary, f"{between[0]}..{between[1]}", width, until)
    count = threads if threads is not None else (os.cpu_count() or 1)
    told = json.loads(_riprap.find(what._scene, case, asked, count, report if progress else None))
    below, above = tuple(told.pop("below")), tuple(told.pop("above"))
    return Found(below=below, above=above, **told)
