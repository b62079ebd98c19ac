"""The words of scenarios and results."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

from . import _riprap


class FieldInfo(NamedTuple):
    """A field that can be recorded, checked and drawn."""

    name: str
    unit: str
    components: int
    meaning: str


def fields(space: str = "planar") -> list[FieldInfo]:
    """All fields of ``planar`` or ``spatial`` models."""
    return [FieldInfo(*entry) for entry in _riprap.fields(space)]


def schema() -> dict[str, Any]:
    """The JSON schema of the scenario language."""
    found: dict[str, Any] = json.loads(_riprap.schema())
    return found
