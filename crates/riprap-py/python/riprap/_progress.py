"""Progress of a run in a terminal, in a notebook, or in a log."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from html import escape
from types import TracebackType
from typing import Any

from . import _riprap

WIDTH = 30
"""Length of the bar."""
LINES_EVERY = 3.0
"""Seconds between two lines in a log."""


class Display:
    """Shows progress and passes it on to the callback of the user."""

    def __init__(
        self, wanted: bool | None, title: str, callback: "Callable[[_riprap.Progress], object] | None"
    ) -> None:
        self._title, self._callback = title, callback
        self._form = "none"
        self._handle: Any = None
        self._last = 0.0
        if wanted is not False:
            if _in_notebook():
                self._form = "notebook"
            # Programs without a console have no stderr at all.
            elif sys.stderr is not None and sys.stderr.isatty():
                self._form = "bar"
            elif wanted:
                self._form = "lines"

    def __enter__(self) -> "Display":
        if self._form == "notebook":
            from IPython.display import HTML, display

            self._handle = display(HTML(_html(self._title, 0.0, "")), display_id=True)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._form == "bar":
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

    @property
    def look(self) -> "Callable[[_riprap.Progress], object] | None":
        """What the run calls; None if nobody wants to hear of it."""
        return self._look if self._form != "none" else self._callback

    def _look(self, progress: "_riprap.Progress") -> object:
        self._show(progress)
        return None if self._callback is None else self._callback(progress)

    def _show(self, p: "_riprap.Progress") -> None:
        if self._form == "lines":
            now = time.monotonic()
            if now - self._last < LINES_EVERY:
                return
            self._last = now
            print(f"{self._title}: {describe(p)}", file=sys.stderr)
        elif self._form == "bar":
            full = int(WIDTH * (p.share or 0.0))
            sys.stderr.write(f"\r\x1b[K[{'=' * full}{' ' * (WIDTH - full)}] {describe(p)}")
            sys.stderr.flush()
        elif self._handle is not None:
            from IPython.display import HTML

            self._handle.update(HTML(_html(self._title, p.share or 0.0, describe(p))))


def describe(p: "_riprap.Progress") -> str:
    """One line: share, phase, step, time, speed, remaining time."""
    share = "  ? %" if p.share is None else f"{100 * min(p.share, 1):3.0f} %"
    left = "" if p.remaining is None else f", {p.remaining:.0f} s left"
    return (
        f"{share} phase {min(p.phase_number, p.phases)}/{p.phases}, step {p.step}, t = {p.time:.4g} s, "
        f"{p.steps_per_second:.0f} steps/s, unbalanced {p.unbalanced:.1e}{left}"
    )


def _html(title: str, share: float, text: str) -> str:
    return (
        f"<div><progress value='{share:.4f}' max='1' style='width: 20em'></progress> "
        f"{escape(title)}<br><code>{escape(text)}</code></div>"
    )


def _in_notebook() -> bool:
    # Not imported: who runs in a notebook has it already, and others need not have it.
    shell = sys.modules.get("IPython")
    if shell is None:
        return False
    now = shell.get_ipython()
    return now is not None and type(now).__name__ == "ZMQInteractiveShell"
