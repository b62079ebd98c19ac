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


# Of what a contact law is shown.
_LAW_UNITS = {
    "point": "m",
    "area": "m2",
    "displacement": "m",
    "velocity": "m/s",
    "force_on_a": "N",
}


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

    def set_interface(self, name: str, **keys: Any) -> None:
        """Changes parameters of an interface at this instant, as :meth:`change` with them under ``interfaces``::

            sim.set_interface("joint", friction_angle="20 deg", cohesion="0 MPa")

        Raises:
            ScenarioError: an interface or a key that is wrong or has no effect, at its place.
        """
        self.change({"interfaces": {name: keys}})

    def set_material(self, name: str, **keys: Any) -> None:
        """Changes a material at this instant: ``density``, in space also ``young``, ``poisson``. Weight and inertia of blocks follow (but of those whose mass
        the scene gives), tetrahedra, bonds, joints and contacts whose stiffness comes of the moduli; displacements and velocities stay, and the energy that this
        adds is booked (``energy.edit_defect``)::

            sim.set_material("rock", young="5 GPa")
            sim.set_material("fill", density="2100 kg/m3")

        Raises:
            ScenarioError: a value that is wrong, at its place.
            ValueError: a material or key that cannot change: in the plane moduli only set the stiffness of interfaces that give none.
        """
        self._sim.set_material(name, _riprap.to_toml(dict(keys)))

    def contact_law(
        self,
        name: str,
        of: "str | tuple[str, str]",
        function: "Callable[[Fields], Any]",
        *,
        memory: int = 0,
    ) -> None:
        """Puts a law of your own on contacts and joints of rigid blocks, beside the built-in response: a trial of a law, at the speed of Python.

        The function is called once a step with all contacts as NumPy arrays, a row each: ``point`` [m], ``blocks`` (numbers into :attr:`names`), ``joint``,
        ``normal`` from the first block to the second, ``area`` [m2; in the plane ``area`` is the length, m], ``displacement`` and ``velocity`` of the
        second block against the first since the law has first seen the contact [m, m/s], ``force_on_a`` of the built-in response, ``time`` [s], and
        ``memory``, which it may write. It gives the traction on the first block [Pa], a row each; the second gets the opposite at the same point::

            def damper(contacts):
                return 1e5 * contacts["velocity"]      # Pa per m/s

            sim.contact_law("damper", "stone", damper)

        The work is that of the load ``law NAME``. What it raises stops the run with a checkpoint and goes on with its traceback. The automatic time step
        does not know the stiffness of the law.

        Args:
            name: name of the law, new in the run; after :meth:`reopen` that which it had.
            of: a block or group, all of whose contacts it is for; or two, between which it acts.
            function: gives an array of shape (contacts, 3); in the plane (contacts, 2) will do.
            memory: numbers that it remembers of each contact, zeros of a new one; a checkpoint holds them.

        Raises:
            ValueError: there is no such name, a block deforms, the phase is implicit, relaxes or steps by levels.
        """

        def law(shown: dict[str, Any]) -> tuple[Any, Any]:
            remembered = shown.pop("memory").reshape(len(shown["area"]), memory)
            time = shown.pop("time")
            arrays = {}
            for key, array in shown.items():
                array.flags.writeable = False
                arrays[key] = Field(array, key, _LAW_UNITS.get(key, "-"))
            arrays |= {"memory": Field(remembered, "memory"), "time": Field(np.float64(time), "time", "s")}
            answer = np.asarray(function(Fields(arrays, "field on contacts")), dtype=float)
            count = len(shown["area"])
            if answer.ndim != 2 or answer.shape not in ((count, 3), (count, 2)):
                raise ValueError(f"contact law {name!r} gave an array of shape {answer.shape}, not {(count, 3)}")
            tractions = np.zeros((count, 3))
            tractions[:, : answer.shape[1]] = answer
            return tractions, np.ascontiguousarray(remembered, dtype=float).reshape(-1)

        self._sim.contact_law(name, [of] if isinstance(of, str) else list(of), law, memory)

    def law_costs(self) -> dict[str, dict[str, float]]:
        """What contact laws have cost in this process: ``calls`` and ``seconds`` of each by name. The share of the run is the stage ``laws of code`` of
        ``profile`` in the manifest."""
        return {name: {"calls": calls, "seconds": seconds} for name, calls, seconds in self._sim.law_costs}

    @classmethod
    def reopen(cls, folder: str | PathLike[str], *, threads: int | None = None) -> "Simulation":
        """Goes on step by step with the run of a folder that was closed or stopped before its end, from its last checkpoint.

        Contact laws are given again, by the names that they had, before it advances. Keys of :meth:`change` need a simulation that was begun here.
        """
        sim = cls.__new__(cls)
        sim.path = Path(folder)
        sim.scenario = scenario(sim.path / "scenario.resolved.toml")
        sim._sim = _riprap.Simulation.reopen(sim.path, _threads(threads))
        return sim

    def set_force(
        self,
        of: str,
        force: "Iterable[float] | np.ndarray[Any, Any]",
        moment: "float | Iterable[float]" = 0.0,
        *,
        nodes: "Iterable[int] | None" = None,
    ) -> None:
        """Sets the force [N] and the moment [N m] on each block of a name, beside the loads of the scenario, until they are set again.

        In the plane both are per metre of thickness, and the moment is a number. Their work is that of the load ``force on NAME``.

        With ``nodes`` the force acts on nodes of one deformable block, in place of all that was set on its nodes before; its work is that of
        the load ``force on nodes of NAME``::

            end = np.flatnonzero(sim.nodes("bar")["point"][:, 0] > 0.99)
            sim.set_force("bar", (1e3 / len(end), 0, 0), nodes=end)

        Args:
            of: a block or a group; with ``nodes`` a deformable block.
            force: the force, two or three components; with ``nodes`` of each of them, or a row for each.
            moment: the moment, in space three components; of rigid blocks.
            nodes: numbers of nodes, as in :meth:`nodes`; an empty list takes all forces off.

        Raises:
            ValueError: there is no such name, its blocks have been removed, there are no such nodes, or a number is none.
        """
        turning = (0.0, 0.0, float(moment)) if isinstance(moment, (int, float)) else _three(moment)
        if nodes is None:
            self._sim.set_force(of, _three(force), turning)
            return
        if turning != (0.0, 0.0, 0.0):
            raise ValueError("nodes take no moment")
        numbers = [int(node) for node in nodes]
        if min(numbers, default=0) < 0:
            raise ValueError(f"nodes have numbers from 0, not {min(numbers)}")
        each = np.broadcast_to(np.asarray(force, dtype=float), (len(numbers), 3))
        self._sim.set_node_forces(of, [(node, _three(row)) for node, row in zip(numbers, each, strict=True)])

    def nodes(self, of: str) -> "Fields":
        """Nodes of a deformable block as read-only arrays, a row each: ``point`` [m], ``displacement`` [m], ``velocity`` [m/s] and ``mass`` [kg]. Their
        order, corners first and the centroid last, stays while the block is there.

        Raises:
            ValueError: there is no such block, it is rigid or has been removed.
        """
        units = {"point": "m", "displacement": "m", "velocity": "m/s", "mass": "kg"}
        arrays = list(zip(units.items(), self._sim.nodes(of), strict=True))
        for _, array in arrays:
            array.flags.writeable = False
        return Fields({name: Field(array, name, unit) for (name, unit), array in arrays}, "field on nodes")

    def set_velocity(
        self, of: str, velocity: "Iterable[float] | None" = None, *, spin: "float | Iterable[float] | None" = None
    ) -> None:
        """Sets the velocity [m/s], the spin [rad/s; in the plane a number] or both of each block of a name at this instant; what is not given
        stays. The energy that it adds is booked as an edit.

        Raises:
            ValueError: there is no such name, its blocks have been removed, deform or are held by a support, or a number is none.
        """
        if velocity is None and spin is None:
            raise ValueError("give `velocity`, `spin` or both")
        turning = (0.0, 0.0, float(spin)) if isinstance(spin, (int, float)) else None if spin is None else _three(spin)
        self._sim.set_velocity(of, None if velocity is None else _three(velocity), turning)

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

    def install_bolt(
        self,
        head: "Iterable[str | float]",
        toe: "Iterable[str | float]",
        *,
        like: str | None = None,
        name: str | None = None,
        **keys: Any,
    ) -> None:
        """Installs a bolt that the scenario does not have, in the rock as it is at this instant.

        Steel, grout, plate and the rest are those of ``like``, a bolt of the scenario, or of its own keys as in ``[[bolts]]``, which have the say. It has no
        force but for its ``pretension``; ``events.jsonl`` says what was installed, and a checkpoint holds it::

            sim.install_bolt((2.0, 0.0, 3.1), (2.0, 0.0, 6.1), like="roof")
            sim.install_bolt((4.0, 3.1), (4.0, 6.1), name="late", steel={"diameter": "25 mm"}, grout={"stiffness": "1 GN/m2"})

        Args:
            head: where it enters the rock, in the coordinates of the scenario, with units or [m].
            toe: its end in the rock.
            like: a bolt of the scenario; of a pattern its name will do.
            name: a name that no bolt has; ``bolt by code 1``, ... without.
            keys: keys of a bolt, such as ``pretension="50 kN"``.

        Raises:
            ScenarioError: a key that is missing or wrong, at its place.
            ValueError: a name that is taken, no such bolt, a key that is none of a bolt by code.
            SimulationError: a bolt that is not in rock.
        """
        ends = {"head": head, "toe": toe}
        said = {end: [x if isinstance(x, str) else f"{float(x)!r} m" for x in at] for end, at in ends.items()}
        said |= {key: value for key, value in (("like", like), ("name", name)) if value is not None}
        self._sim.install_bolt(_riprap.to_toml(said | keys))

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
