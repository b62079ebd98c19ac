"""Named results: removable blocks, run-out of rocks, strength of specimens."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from . import _riprap
from ._folder import RunFolder
from ._scenario import Scenario, scenario

INFINITE = float("inf")


@dataclass(frozen=True)
class RemovableBlock:
    """A block with a free face, SI."""

    name: str
    kind: str
    """``key``, ``potential`` (held by strength), ``safe`` (held by weight) or ``tapered``."""
    round: int
    """Round in which it was looked at."""
    volume: float
    weight: float
    centroid: tuple[float, float, float]
    free_area: float
    mode: str
    """``falling``, ``sliding`` on one plane, ``wedge`` on two, ``held`` by the resultant."""
    planes: list[dict[str, Any]]
    """Planes that it slides along: interfaces, dip and dip_direction (deg), area, pressing and strength (N)."""
    direction: tuple[float, float, float]
    driving: float
    resisting: float
    factor_of_safety: float
    support_force: float
    """Force against the motion that gives the wanted factor, N."""
    support_pressure: "float | None"
    """The same by a pressure on the free faces by which it goes out, Pa."""


@dataclass(frozen=True)
class Removable:
    """Removable and tapered blocks of a scenario."""

    phase: str
    """The phase at whose beginning."""
    blocks: list[RemovableBlock]
    inside: int
    """Blocks without a free face."""
    ground: int
    """Blocks that are fixed or go on beyond the model."""
    not_counted: list[str]
    """What the scenario has and block theory leaves out."""
    words: str
    """How many there are of each kind."""

    @property
    def key_blocks(self) -> list[RemovableBlock]:
        """Removable blocks with a factor of safety below 1."""
        return [block for block in self.blocks if block.kind == "key"]


def _block(told: dict[str, Any]) -> RemovableBlock:
    # What is infinite is null in JSON.
    told["factor_of_safety"] = INFINITE if told["factor_of_safety"] is None else told["factor_of_safety"]
    told["resisting"] = INFINITE if told["resisting"] is None else told["resisting"]
    for plane in told["planes"]:
        plane["strength"] = INFINITE if plane["strength"] is None else plane["strength"]
    for name in ("centroid", "direction"):
        told[name] = tuple(told[name])
    return RemovableBlock(**told)


def removable(
    source: "Scenario | Mapping[str, Any] | str | PathLike[str]",
    *,
    case: str | None = None,
    factor: float = 1.0,
    rounds: int = 1,
    phase: str | None = None,
) -> Removable:
    """Lists the removable blocks of a scenario in space, by block theory (Goodman & Shi 1985), without running it.

    Args:
        source: a scenario, or what makes one.
        case: name of a case; by default the scenario as it stands.
        factor: factor of safety that support is to give; blocks below it are taken out between rounds.
        rounds: most rounds.
        phase: phase at whose beginning; by default the last.

    Raises:
        ScenarioError: the scenario is wrong.
        ValueError: the scenario is in the plane, there is no such phase, or the factor is none.
    """
    told, words = _riprap.removable(scenario(source)._scene, case, factor, rounds, phase)
    answer = json.loads(told)
    blocks = [_block(block) for block in answer["blocks"]]
    same = {key: answer[key] for key in ("phase", "inside", "ground", "not_counted")}
    return Removable(blocks=blocks, words=words, **same)


def _folders(runs: "tuple[RunFolder | str | PathLike[str], ...]") -> list[Path]:
    return [Path(run.path if isinstance(run, RunFolder) else fspath(run)) for run in runs]


@dataclass(frozen=True)
class Runout:
    """Where rocks went, SI; angles in deg."""

    rocks: list[dict[str, Any]]
    """A dictionary a rock: run, name, mass, start, end, runout, drop, travel_angle, max_speed, max_height, max_energy, end_speed."""
    passages: list[dict[str, Any]]
    """First passages of lines: line, run, rock, time, at, height, speed, energy."""
    lines: dict[str, dict[str, Any]]
    """By name: passed, rocks, share and its 95 % interval; height, speed, energy as half, most (nine in ten), largest."""
    runout: dict[str, float]
    """Run-out that half of the rocks and nine in ten (``most``) have not exceeded, and the largest."""
    least_angle: float
    """Least angle of travel."""
    moving: int
    """Rocks that still move at the end."""
    words: str


def runout(
    *runs: "RunFolder | str | PathLike[str]",
    of: str | None = None,
    lines: "Mapping[str, str] | None" = None,
) -> Runout:
    """Gives the run-out of the rocks of runs, from their frames.

    Args:
        runs: run folders, or folders of a sweep or a Monte Carlo study, whose rocks count together.
        of: only the rocks of this group; by default all free blocks.
        lines: lines by name: ``{"road": "40 m", "fence": "40 m,-10 m..45 m,10 m"}``.

    Raises:
        ValueError: a folder without runs or with too few frames, an unknown group, a line that is none.
    """
    folders = _folders(runs)
    asked = [f"{name}={place}" for name, place in (lines or {}).items()]
    told, words = _riprap.runout(folders, of, asked)
    answer = json.loads(told)
    same = {key: answer[key] for key in ("rocks", "passages", "runout", "least_angle", "moving")}
    return Runout(lines={line["line"]: line for line in answer["lines"]}, words=words, **same)


@dataclass(frozen=True)
class Muckpile:
    """What a blast has made, SI. A part that the run does not have is ``None``."""

    time: float
    """Time of the last frame."""
    throw: dict[str, Any] | None
    """blocks, volume, mass, shift, along, half and most (way of half and nine tenths of the volume), farthest, largest_far, moving, left."""
    pile: dict[str, Any] | None
    """area, volume, swell, height, profile (at, surface, highest, ground, width)."""
    crater: dict[str, float] | None
    """radius, depth, area, volume."""
    behind: dict[str, float] | None
    """back_break, loose, damaged: distances behind the last row."""
    fragments: dict[str, Any] | None
    """count, x50, x80, n, largest, curve."""
    kuz_ram: dict[str, float] | None
    """x50, x80 and what they are of."""
    gas: dict[str, float] | None
    """Mass and energy of gas that may enter cracks."""
    energy: dict[str, Any] | None
    """put_in, and the parts ``from`` and ``to`` with name, energy, share, depends_on."""
    words: str


def muckpile(
    run: "RunFolder | str | PathLike[str]",
    *,
    moved: str | None = None,
    along: "tuple[float, float] | None" = None,
    cell: str | None = None,
    rock_factor: float | None = None,
    powder_factor: str | None = None,
    charge: str | None = None,
    strength: float = 100.0,
    uniformity: float | None = None,
    of: str | None = None,
) -> Muckpile:
    """Gives what the blast of a run in space has made: pile, throw, fragments, crater, gas, energy.

    Args:
        run: a run folder.
        moved: way from which on a block counts as thrown; by default half the edge of the cube of its volume.
        along: direction of the throw in the plan; by default the mean one.
        cell: cell of the grid over the plan.
        rock_factor: A of Kuz-Ram, whose curve is wanted then.
        powder_factor: for Kuz-Ram, ``"0.5 kg/m3"``; by default that of the run.
        charge: of a hole, for Kuz-Ram, ``"40 kg"``; by default the mean one of the run.
        strength: by weight relative to ANFO, %.
        uniformity: n of Kuz-Ram.
        of: group, block or condition whose blocks alone make the pile; all others are ground.

    Raises:
        ValueError: a folder without a run, a run in the plane, a number that cannot be.
    """
    (folder,) = _folders((run,))
    given = {"moved": moved, "cell": cell, "rock_factor": rock_factor, "powder_factor": powder_factor}
    given |= {"charge": charge, "strength": strength, "uniformity": uniformity, "of": of}
    given["along"] = None if along is None else f"{along[0]!r},{along[1]!r}"
    told, words = _riprap.muckpile(folder, given)
    answer = json.loads(told)
    del answer["run"]
    return Muckpile(words=words, **answer)


@dataclass(frozen=True)
class Strength:
    """Results of laboratory tests, SI; angles in deg."""

    tests: list[dict[str, Any]]
    """A dictionary a test: run, peak, strain_at_peak, modulus, fit, residual, confining, at_end."""
    cohesion: "tuple[float, float | None] | None"
    """Value and standard error; of tests with two and more confining stresses."""
    friction: "tuple[float, float | None] | None"
    """Friction angle and its standard error."""
    words: str


def strength(
    *runs: "RunFolder | str | PathLike[str]",
    load: str,
    area: float | None = None,
    strain: str | None = None,
    length: float | None = None,
    confining: str | None = None,
    disk: "tuple[float, float | None] | None" = None,
    shear: bool = False,
    between: tuple[float, float] = (0.2, 0.5),
) -> Strength:
    """Gives modulus and strength of laboratory tests, from their histories.

    Args:
        runs: run folders, or folders of a sweep.
        load: history of the load, or of the stress where there is no area.
        area: area by which the load is divided, m2; in the plane a length.
        strain: history of the strain, or of the shortening where there is a length; without it there is no modulus.
        length: length by which the shortening is divided, m.
        confining: history of the confining stress, in shear of the normal stress, or a value such as ``"5 MPa"``.
        disk: a Brazilian test: diameter and, in space, thickness, m.
        shear: the tests shear a joint.
        between: shares of the peak between which the modulus is measured.

    Raises:
        ValueError: a folder without histories, an unknown history, one without values, a size that is none.
    """
    options = {
        "load": load,
        "area": area,
        "strain": strain,
        "length": length,
        "confining": confining,
        "disk": disk,
        "shear": shear,
        "between": list(between),
    }
    told, words = _riprap.strength(_folders(runs), options)
    answer = json.loads(told)
    envelope = answer["envelope"] or {}

    def fitted(name: str) -> "tuple[float, float | None] | None":
        return (envelope[name]["value"], envelope[name]["error"]) if envelope else None

    return Strength(tests=answer["tests"], cohesion=fitted("cohesion"), friction=fitted("friction"), words=words)
