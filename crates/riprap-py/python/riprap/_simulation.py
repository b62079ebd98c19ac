"""Simulations advanced step by step."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple


from . import _riprap
from ._data import Frame, Field
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
