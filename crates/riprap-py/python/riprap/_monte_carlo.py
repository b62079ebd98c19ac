"""Random samples of a scenario."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from concurrent.futures import Executor
from os import PathLike
from pathlib import Path
from typing import Any

from . import _riprap
from ._scenario import Scenario, default_folder, scenario
from ._sweep import Sweep, _Counter, run_on


class MonteCarlo(Sweep):
    """The samples of a Monte Carlo study: a sweep with a probability of failure."""

    def __init__(self, path: Path, text: str, summary: Mapping[str, Any]) -> None:
        super().__init__(path, text)
        self.summary = summary
        """Everything in ``monte_carlo.json``: spread of the random values and of the results, rank correlations, swings."""

    def __repr__(self) -> str:
        probability = self.probability
        failing = "" if probability is None else f", probability of failure {probability:.3g}"
        return f"MonteCarlo({str(self.path)!r}, {self.summary['finished']} of {len(self)} samples finished{failing})"

    @property
    def probability(self) -> float | None:
        """Share of the samples that fail; None where the scenario does not say what failure is."""
        failure = self.summary["failure"]
        return None if failure is None else failure["probability"]

    @property
    def interval(self) -> tuple[float, float] | None:
        """Interval in which the probability of failure lies with a confidence of 95 % (Clopper and Pearson)."""
        failure = self.summary["failure"]
        return None if failure is None else tuple(failure["interval"])

    def influence(self, result: str | None = None) -> dict[str, float | None]:
        """Rank correlation of each random value with a history, by its name, or with failure."""
        keys = [variable["name"] for variable in self.summary["variables"]]
        if result is None:
            if self.summary["failure"] is None:
                raise KeyError("the scenario does not say what failure is; name a history")
            return dict(zip(keys, self.summary["failure"]["influence"]))
        known = {of["spread"]["name"]: of for of in self.summary["results"]}
        found = next((of for name, of in known.items() if result in (name, name.rsplit(" [", 1)[0])), None)
        if found is None:
            raise KeyError(f"unknown history {result!r} (valid histories: {', '.join(known)})")
        return dict(zip(keys, found["influence"]))


def monte_carlo(
    source: "Scenario | Mapping[str, Any] | str | PathLike[str]",
    distributions: Mapping[str, Any] | None = None,
    n: int | None = None,
    seed: int | None = None,
    out: str | PathLike[str] | None = None,
    *,
    fails_when: Mapping[str, Any] | None = None,
    correlations: "Mapping[tuple[str, str], float] | None" = None,
    sampling: str | None = None,
    case: str | None = None,
    jobs: int | None = None,
    executor: "Executor | None" = None,
    existing: str = "refuse",
    progress: bool = False,
) -> MonteCarlo:
    """Runs random samples of a scenario side by side, each on one thread and into its own sub-folder.

    What is given here replaces what the scenario says in ``[distributions]`` and ``[monte_carlo]``.

    Args:
        source: a scenario, or what makes one.
        distributions: keys and the distributions of their values,
            ``{"interfaces.default.friction_angle": {"normal": {"mean": "35 deg", "deviation": "2 deg"}}}``.
        n: number of samples.
        seed: seed of the random numbers: the same seed gives the same samples.
        out: the folder; by default ``NAME.monte-carlo`` in the working folder.
        fails_when: what counts as failure, ``{"field": "model.max_displacement", "above": "0.1 m"}``.
        correlations: coefficients of pairs of keys, ``{("a.b", "a.c"): -0.5}``.
        sampling: ``latin_hypercube`` (the default) or ``random``.
        case: name of a case; by default the scenario as it stands.
        jobs: runs at a time; by default as many as there are processors.
        executor: runs each sample as a task of its own instead; see :func:`riprap.sweep`.
        existing: what to do with folders of samples that are not empty: ``refuse``, ``replace`` or ``force``.
        progress: print a line after each sample.

    Raises:
        ScenarioError: the scenario is wrong, or a value that was drawn is none that its key can have.
        RunError: tasks were lost by the executor. The same call again goes on: what has finished is kept.
    """
    what = scenario(source)
    pairs = [{"between": list(keys), "coefficient": value} for keys, value in (correlations or {}).items()]
    wanted = {
        "samples": n,
        "seed": seed,
        "sampling": sampling,
        "fails_when": None if fails_when is None else dict(fails_when),
        "correlations": pairs or None,
    }
    changes: dict[str, Any] = {f"monte_carlo.{key}": value for key, value in wanted.items() if value is not None}
    if distributions is not None:
        changes = {"distributions": dict(distributions)} | changes
    if changes:
        what = what.with_set(changes)
    folder = Path(out) if out is not None else default_folder(what, "monte-carlo")
    if executor is not None and jobs is not None:
        raise ValueError("jobs and executor exclude each other: an executor has its own number of workers")
    samples = what._scene.sampled(case)
    if executor is not None:
        run_on(executor, samples, (what._scene, case), folder, existing, progress)
    else:
        report = _Counter(len(samples.cases)) if progress else None
        _riprap.sweep(samples, folder, existing, max(jobs or os.cpu_count() or 1, 1), report)
    text, summary = _riprap.merged(samples, folder)
    return MonteCarlo(folder, text, json.loads(summary))
