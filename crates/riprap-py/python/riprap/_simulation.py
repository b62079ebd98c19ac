"""Simulations advanced step by step."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

import numpy as np

from . import _riprap
from ._data import Field, Fields, Frame
from ._folder import RunFolder
from ._run import _threads
from ._scenario import Scenario, scenario
from .errors import UnstableError


class Value(NamedTuple):
    """A number with its unit."""

    value: float
    unit: str

    def __float__(self) -> float:
        return self.value


def _three(vector: "Iterable[float]") -> tuple[float, float, float]:
    x, y, *rest = (float(v) for v in vector)
    return (x, y, rest[0] if rest else 0.0)


class Simulation:
    """A scenario under way, advanced as far as wanted and looked at in between.

    The steps, and what is recorded, are those of :func:`riprap.run`: pauses change no bit. Use it as a context manager,
    or call :meth:`close`; with a folder a simulation that has not ended can be resumed later::

        with riprap.Simulation("slide.toml") as sim:
            while sim.advance(time=0.1):
                print(sim.time, sim.value("block.velocity", of="block"))

    Args:
        source: a scenario, or what makes one.
        out: run folder to record into; by default nothing is written.
        case: name of a case; by default the scenario as it stands.
        threads: number of threads; by default all.
        existing: what to do with a folder that is not empty: ``refuse``, ``replace`` or ``force``.
    """

    def __init__(
        self,
        source: "Scenario | Mapping[str, Any] | str | PathLike[str]",
        out: str | PathLike[str] | None = None,
        *,
        case: str | None = None,
        threads: int | None = None,
        existing: str = "refuse",
    ) -> None:
        self.scenario = scenario(source)
        self.path = None if out is None else Path(out)
        self._sim = _riprap.Simulation(self.scenario._scene, case, self.path, existing, _threads(threads))

    def __enter__(self) -> "Simulation":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        # One that is closed, or being advanced by another thread, can be shown too.
        try:
            state = f"{self._sim.state[0]}, step {self.steps}, t = {self.time:g} s"
        except (ValueError, RuntimeError) as error:
            state = str(error)
        return f"Simulation({self.scenario.title!r}, {state})"

    def advance(
        self,
        *,
        steps: int | None = None,
        time: float | None = None,
        callback: "Callable[[_riprap.Progress], object] | None" = None,
    ) -> bool:
        """Goes on by ``steps`` or by a span of model ``time`` [s], whichever is first; without either to the end.

        The time step is not changed for it: it stops at the first state that has come so far. ``callback`` as in
        :func:`riprap.run`; a simulation that it stopped can be advanced again.

        Returns:
            Whether there is more to do.

        Raises:
            UnstableError: the physics stopped it.
        """
        if steps is not None and steps < 0:
            raise ValueError(f"steps={steps}; it must be 0 or more")
        # So that what is no number is refused too.
        if time is not None and not time >= 0:
            raise ValueError(f"time={time}; it must be 0 or more")
        state, message = self._sim.advance(steps, time, callback)
        if state == "unstable":
            raise UnstableError(message, self.path)
        return state == "running"

    def steer(
        self, name: str, factor: float | None = None, *, velocity: "Iterable[float] | None" = None
    ) -> None:
        """Gives a load or a support that the scenario names another value from the present instant on.

        A servo is a loop of ``advance`` and ``steer``. The same changes at the same steps give the same bits; each is an event of the run
        (``events.jsonl``), and its work is booked as that of the load or the support::

            while sim.advance(steps=20):
                error = 0.1 - sim.value("block.speed", of="stone").value
                sim.steer("push", factor=1.0 + 5.0 * error)

        Args:
            name: name of the load or of the support.
            factor: of a load: the factor on it, in place of its ``time``.
            velocity: of a support with ``motion``: its velocity [m/s], in place of its functions of time.

        Raises:
            ValueError: there is no such name, or it does not take that value.
        """
        to = None
        if velocity is not None:
            x, y, *rest = (float(v) for v in velocity)
            to = (x, y, rest[0] if rest else 0.0)
        self._sim.steer(name, factor, to)

    def change(self, keys: "Mapping[str, Any]") -> None:
        """Changes the model at the present instant by keys of a phase.

        ``remove``, ``removal_ramp``, ``fix``, ``release`` (names of blocks and groups), ``gravity``, ``water``, ``reset``, ``interfaces``,
        ``install`` (names of bolts), and the rules ``until``, ``time_step``, ``safety``, ``damping``, ``max_residual`` of the
        present phase. The energy that it adds is booked (``energy.edit_defect``), ``events.jsonl`` says what was changed, and the same
        changes at the same steps give the same bits, also after a restart::

            sim.change({"remove": ["key"], "interfaces": {"joint": {"friction_angle": "20 deg"}}})

        Raises:
            ScenarioError: a value that is wrong, at its place.
            ValueError: a key that cannot change within a phase, a block that is not there or has been removed.
        """
        self._sim.change(_riprap.to_toml(dict(keys)))

    def set_force(self, of: str, force: "Iterable[float]", moment: "float | Iterable[float]" = 0.0) -> None:
        """Sets the force [N] and the moment [N m] on each block of a name, beside the loads of the scenario, until they are set again.

        In the plane both are per metre of thickness, and the moment is a number. Their work is that of the load ``force on NAME``.

        Args:
            of: a block or a group.
            force: the force, two or three components.
            moment: the moment, in space three components.

        Raises:
            ValueError: there is no such name, its blocks have been removed, or a number is none.
        """
        turning = (0.0, 0.0, float(moment)) if isinstance(moment, (int, float)) else _three(moment)
        self._sim.set_force(of, _three(force), turning)

    def set_velocity(self, of: str, velocity: "Iterable[float]") -> None:
        """Sets the velocity [m/s] of each block of a name at this instant; spins stay. The energy that it adds is booked as an edit.

        Raises:
            ValueError: there is no such name, its blocks have been removed, deform or are held by a support, or a number is none.
        """
        self._sim.set_velocity(of, _three(velocity))

    def charge(self, of: str, mass: "str | float", *, delay: "str | float" = 0.0) -> None:
        """Charges the hole of a source that has not gone off, to go off ``delay`` from now.

        Explosive, place and stemming are those of the scene, which gives the hole a ``delay`` beyond the end of the run where
        code decides when it is fired.

        Args:
            of: a source of the scene.
            mass: mass of the charge, ``"2 kg"`` or a number [kg].
            delay: time from now, ``"25 ms"`` or a number [s].

        Raises:
            ValueError: there is no such source, it has gone off, or a number is none.
        """
        si = [_riprap.si(x, unit) if isinstance(x, str) else float(x) for x, unit in ((mass, "kg"), (delay, "s"))]
        self._sim.charge(of, *si)

    def add_block(
        self,
        name: str,
        vertices: "Iterable[Iterable[float]]",
        faces: "Iterable[Iterable[int]]" = (),
        *,
        material: str,
        groups: "str | Iterable[str]" = (),
        velocity: "Iterable[float]" = (0.0, 0.0, 0.0),
        spin: "float | Iterable[float]" = 0.0,
    ) -> float:
        """Adds a rigid block at this instant, where it lies in no other one.

        It has no joints and meets all others by contact under the interface of the two materials. Its displacements count from where it is put; its
        energy of motion is booked (``energy.edit_defect``), ``events.jsonl`` says what was added, and a checkpoint holds it. Supports,
        loads and phases of the scenario keep the blocks that they had; ``change`` fixes and removes it by its name::

            cube = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (4, 5)]
            sim.add_block("refill.1", cube, material="ore", groups="broken")

        Args:
            name: a name that no block and no group has.
            vertices: corners [m], in space of a convex solid, in the plane of a polygon.
            faces: corners of each face in space; without them the convex hull of the corners.
            material: a material of the scenario.
            groups: groups that it joins: their fields have it from then on.
            velocity: of the centroid [m/s].
            spin: [rad/s]; in the plane a number.

        Returns:
            Its mass [kg]; in the plane [kg/m].

        Raises:
            ValueError: a name that is taken, an unknown material or group, a shape that is none, a block in its way (with its name and the depth), a model
                without contact. Nothing has changed then.
        """
        corners = [_three(corner) for corner in vertices]
        sides = [[int(corner) for corner in face] for face in faces]
        turning = (0.0, 0.0, float(spin)) if isinstance(spin, (int, float)) else _three(spin)
        joined = [groups] if isinstance(groups, str) else list(groups)
        return self._sim.add_block(name, (corners, sides), material, joined, (_three(velocity), turning))

    def run(self, callback: "Callable[[Simulation], object]", *, every: int) -> bool:
        """Goes on to the end and calls ``callback`` with this simulation every ``every`` steps.

        A callback that returns False pauses it. One that raises stops the run: it is closed with a checkpoint, from which
        :func:`riprap.resume` goes on, and the exception goes on with its traceback.

        Returns:
            Whether there is more to do.
        """
        if every < 1:
            raise ValueError(f"every={every}; it must be 1 or more")
        while self.advance(steps=every):
            try:
                if callback(self) is False:
                    return True
            except BaseException as error:
                if self._sim.state[0] == "running":
                    where = "" if self.path is None else f"; {self.path} can be resumed"
                    error.add_note(f"raised in a callback at step {self.steps}, t = {self.time:g} s{where}")
                self.close()
                raise
        return False

    def contacts(self) -> "Fields":
        """Contacts and joints as read-only arrays, a row each: ``point`` [m], ``block_a`` and ``block_b`` (numbers into :attr:`names`),
        ``force_on_a``, ``area`` or in the plane ``length``, in space ``normal``, and their state (``slipping`` or ``sliding_points``,
        ``broken_points`` ...): a snapshot, as in frames, which leave out intact joints of very large models."""
        frame = self.frame()
        return Fields({"point": frame.contact_points, **frame.contacts}, "field on contacts")

    def graph(self) -> tuple[list[tuple[str, dict[str, Any]]], list[tuple[str, str, dict[str, Any]]]]:
        """Blocks and what joins them, for a graph: nodes with their fields, and an edge a pair of blocks with the number of its contacts, the sum of
        their forces on the first block (``force_on_a``) and of their ``area`` (in the plane ``length``)::

            nodes, edges = sim.graph()
            graph = networkx.Graph()
            graph.add_nodes_from(nodes)
            graph.add_edges_from(edges)
        """
        frame, names = self.frame(), self.names
        nodes = [
            (names[int(number)], {"block": int(number), "centre": np.asarray(frame.corners(k)).mean(axis=0)})
            for k, number in enumerate(frame.blocks["block"])
        ]
        size = "area" if frame.spatial else "length"
        ends = zip(frame.contacts["block_a"], frame.contacts["block_b"], strict=True)
        forces, sizes = np.asarray(frame.contacts["force_on_a"]), np.asarray(frame.contacts[size])
        pairs: dict[tuple[int, int], dict[str, Any]] = {}
        for k, (a, b) in enumerate(ends):
            # A joint and a contact of one pair may have it either way round.
            pair, sign = ((int(a), int(b)), 1.0) if a < b else ((int(b), int(a)), -1.0)
            edge = pairs.setdefault(pair, {"contacts": 0, "force_on_a": 0.0 * forces[k], size: 0.0})
            edge["contacts"] += 1
            edge["force_on_a"] = edge["force_on_a"] + sign * forces[k]
            edge[size] += float(sizes[k])
        return nodes, [(names[a], names[b], data) for (a, b), data in pairs.items()]

    def close(self) -> RunFolder | None:
        """Closes the ledger and gives the run folder, if there is one."""
        self._sim.close()
        return None if self.path is None else RunFolder(self.path)

    @property
    def running(self) -> bool:
        """Whether there is more to do."""
        return self._sim.state[0] == "running"

    @property
    def steps(self) -> int:
        """Steps done."""
        return self._sim.now[0]

    @property
    def time(self) -> float:
        """Model time [s]."""
        return self._sim.now[1]

    @property
    def dt(self) -> float:
        """The coming time step [s]."""
        return self._sim.now[2]

    @property
    def phase(self) -> str:
        """Name of the present phase; empty at the end."""
        return self._sim.now[3]

    @property
    def state_hash(self) -> str:
        """Hash of the state: equal hashes mean equal states, bit for bit."""
        return self._sim.state_hash

    @property
    def names(self) -> list[str]:
        """Names of the blocks by their numbers (the field ``block`` of frames)."""
        return self._sim.names

    def frame(self) -> Frame:
        """A snapshot of blocks and contacts; it does not change when the simulation goes on."""
        return Frame(self._sim.frame())

    def field(self, name: str) -> Field:
        """A field on blocks, such as ``displacement``: a snapshot."""
        return self.frame().blocks[name]

    def value(
        self, name: str, of: "str | Iterable[str]" = (), *, along: "Iterable[float] | None" = None
    ) -> Value:
        """One number: a field (``model.unbalanced``, ``block.velocity.x``) of blocks or a source given by name.

        ``along`` projects a vector; a vector without component or direction gives its length. See
        :func:`riprap.fields` for what there is.
        """
        names = [of] if isinstance(of, str) else list(of)
        direction = None
        if along is not None:
            x, y, *rest = (float(c) for c in along)
            direction = (x, y, rest[0] if rest else 0.0)
        return Value(*self._sim.value(name, names, direction))

    def histories(self) -> dict[str, Value]:
        """The histories of the scenario as they are now."""
        return {name: Value(value, unit) for name, value, unit in self._sim.histories()}

    def energy(self) -> dict[str, Value]:
        """The terms of the energy ledger as they are now."""
        terms, unit = self._sim.energy()
        return {name: Value(value, unit) for name, value in terms}
