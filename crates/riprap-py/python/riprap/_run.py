"""Whole runs."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from . import _riprap
from ._folder import RunFolder, ending
from ._progress import Display
from ._scenario import Scenario, default_folder, scenario


def run(
    source: "Scenario | Mapping[str, Any] | str | PathLike[str]",
    out: str | PathLike[str] | None = None,
    *,
    case: str | None = None,
    threads: int | None = None,
    progress: bool | None = None,
    callback: "Callable[[_riprap.Progress], object] | None" = None,
    existing: str = "refuse",
    strict: bool = True,
) -> RunFolder:
    """Runs a scenario into a run folder.

    Other Python threads go on meanwhile. Ctrl-C stops the run with a checkpoint and raises ``KeyboardInterrupt``;
    :func:`resume` goes on from there. Results do not depend on the number of threads, bit for bit.

    Args:
        source: a :class:`Scenario`, or what makes one: dictionary, TOML text, path.
        out: the run folder; by default ``NAME.run`` in the working folder, with a number if that is taken.
        case: name of a case (variant, swept values); by default the scenario as it stands.
        threads: number of threads; by default all.
        progress: whether to show progress; by default in terminals and notebooks.
        callback: called about ten times a second with a :class:`Progress`; returning False stops the run with a
            checkpoint, an exception stops it and is raised.
        existing: what to do with a folder that is not empty: ``refuse``, ``replace`` an earlier run, or ``force``.
        strict: raise :class:`UnstableError` when the physics stops the run.

    Raises:
        ScenarioError: the scenario is wrong.
        RunError: the folder is taken.
        UnstableError: the physics stopped the run.
        OutputError: results could not be written.
    """
    what = scenario(source)
    folder = Path(out) if out is not None else default_folder(what, "run")
    with Display(progress, what.title, callback) as display:
        manifest = _riprap.run(what._scene, case, folder, existing, _threads(threads), display.look)
    return ending(folder, json.loads(manifest), strict)


def resume(
    folder: "RunFolder | str | PathLike[str]",
    *,
    threads: int | None = None,
    progress: bool | None = None,
    callback: "Callable[[_riprap.Progress], object] | None" = None,
    strict: bool = True,
) -> RunFolder:
    """Goes on with a run that was stopped, from its last checkpoint; the results are those of a run without a stop.

    Raises:
        RunError: the run has ended, or has no sound checkpoint.
    """
    path = folder.path if isinstance(folder, RunFolder) else Path(folder)
    with Display(progress, str(path), callback) as display:
        manifest = _riprap.resume(path, _threads(threads), display.look)
    return ending(path, json.loads(manifest), strict)


def _threads(threads: int | None) -> int:
    if threads is None:
        return os.cpu_count() or 1
    if threads < 1:
        raise ValueError(f"threads={threads}; at least 1 is needed")
    return threads
