"""Pictures of a run."""

from __future__ import annotations

import re
from os import PathLike
from pathlib import Path

from . import _riprap
from ._folder import RunFolder


class Picture:
    """Files of a picture; a notebook shows it."""

    def __init__(self, files: list[Path]) -> None:
        self.files = files
        """The picture and the numbers behind it (CSV)."""

    def __repr__(self) -> str:
        return f"Picture({', '.join(str(f) for f in self.files)})"

    def file(self, ending: str) -> Path | None:
        """The file with that ending, such as ``.svg``."""
        return next((f for f in self.files if f.suffix == ending), None)

    def _repr_svg_(self) -> str | None:
        svg = self.file(".svg")
        return None if svg is None else svg.read_text(encoding="utf-8")

    def _repr_png_(self) -> bytes | None:
        # A film is a PNG to whoever shows pictures.
        png = self.file(".png") or self.file(".apng")
        # Of both a notebook shows the sharp one.
        return None if png is None or self.file(".svg") is not None else png.read_bytes()


def plot(
    run: "RunFolder | str | PathLike[str]",
    what: str = "histories",
    *names: str,
    out: str | PathLike[str] | None = None,
    by: str = "displacement",
    times: "float | list[float] | None" = None,
    log: bool = False,
    vectors: str | None = None,
    stress: bool = False,
    cracks: bool = False,
    isolines: int = 0,
    window: "tuple[str | float, str | float, str | float, str | float] | None" = None,
    exaggerate: float | None = None,
    normal: str = "y",
    at: "str | float | None" = None,
    line: "tuple[tuple[str | float, ...], tuple[str | float, ...]] | None" = None,
    surface: bool = False,
    uplift: "str | float | None" = None,
    source: str | None = None,
    of: str | None = None,
    projection: str = "equal_area",
    against: str | None = None,
    range: "tuple[str | float, str | float] | None" = None,
    percentiles: "tuple[float, float] | None" = None,
    title: str | None = None,
    size: "str | float | None" = None,
    dpi: float | None = None,
    font: str | None = None,
    png: bool = False,
    pdf: bool = False,
) -> Picture:
    """Draws a picture of a run folder, with the numbers behind it as CSV.

    Args:
        run: the run folder.
        what: ``histories``, ``energy``, ``blocks``, ``section``, ``line``, ``ppv``, ``crater``, ``heave``, ``cavity``,
            ``spectrum``, ``stereonet``, ``rose``, ``fragments``.
        names: histories to draw (all by default); the one history of a spectrum.
        out: ``.svg``, ``.png`` or ``.pdf``, SVG and PNG without an ending; by default an SVG in ``plots/`` of the run.
        by: field that colours blocks, such as ``velocity.x``.
        times: model times of frames [s]; by default the last frame.
        log: logarithmic colours.
        vectors: arrows of ``displacement`` or ``velocity`` on blocks, or of ``flow`` through joints.
        stress: principal stresses of the blocks as crosses.
        cracks: faces that have broken, on sections.
        isolines: about so many lines of equal value over blocks, at round values.
        window: left, bottom, right and top of the picture, with units or in m.
        exaggerate: factor on displacements.
        normal: axis across a section: ``x``, ``y`` or ``z``.
        at: place of a section along its normal, ``"2 m"`` or a number [m].
        line: two places, with units or in m: the ``line`` along which a field is drawn, in the rock as it was before it moved.
        surface: only peak velocities on the surface (``ppv``).
        uplift: least uplift that counts as crater, ``"40 mm"`` or a number [m].
        source: name of the charge (``crater``, ``heave``).
        of: only blocks of this group, block or condition (``"rock and not ore"``); fragments that contain one.
        projection: of the stereonet, ``equal_area`` or ``equal_angle``.
        against: history along the x axis of histories, instead of time.
        range: values of the first and the last colour, with units or in SI: ``("0 mm", "5 mm")``.
        percentiles: percentiles of the values at which the colours begin and end: ``(2, 98)``.
        title: title in place of that of the scene.
        size: width on paper, ``"160 mm"`` or a number [m].
        dpi: pixels of PNG per inch; 192 by default.
        font: font family of SVG; PNG and PDF have outlines of DejaVu Sans.
        png: without ``out``: PNG in place of SVG.
        pdf: without ``out``: PDF in place of SVG.

    Raises:
        PlotError: the run has not what the picture needs, or an option cannot be.
        ValueError: a place, a length or a value is none, or options exclude each other.
    """
    folder = run.path if isinstance(run, RunFolder) else Path(run)
    parts = [what, *names[:1], *([by] if what in ("blocks", "section", "line") else [])]
    if of is not None:
        parts.append(of)
    name = "_".join(parts if against is None else [*parts, "against", against])
    for one, other in (("range", "percentiles"), ("png", "pdf"), ("out", "png"), ("out", "pdf")):
        given = {"range": range, "percentiles": percentiles, "out": out, "png": png or None, "pdf": pdf or None}
        if given[one] is not None and given[other] is not None:
            raise ValueError(f"{one} and {other} exclude each other")
    ending = "png" if png else "pdf" if pdf else "svg"
    target = Path(out) if out is not None else folder / "plots" / f"{re.sub(r'[^A-Za-z0-9_.-]', '_', name)}.{ending}"
    listed = [] if times is None else [times] if isinstance(times, (int, float)) else list(times)
    options = {
        "by": by,
        "times": [float(t) for t in listed],
        "names": list(names),
        "against": against,
        "log": log,
        "vectors": vectors,
        "stress": stress,
        "cracks": cracks,
        "isolines": isolines,
        "window": None if window is None else [_metres(end) for end in window],
        "exaggerate": exaggerate,
        "normal": normal,
        "at": _metres(at),
        "line": None if line is None else [[_metres(x) for x in end] for end in line],
        "surface": surface,
        "uplift": _metres(uplift),
        "source": source,
        "of": of,
        "projection": projection,
        "range": None if range is None else list(range),
        "percentiles": None if percentiles is None else list(percentiles),
        "title": title,
        "size": _metres(size),
        "dpi": dpi,
        "font": font,
    }
    return Picture(_riprap.plot(folder, what, target, options))


def shot(
    run: "RunFolder | str | PathLike[str]",
    out: str | PathLike[str] | None = None,
    *,
    by: str | None = None,
    view: "tuple[float, float] | None" = None,
    perspective: float | None = None,
    saved: str | None = None,
    views: str | PathLike[str] | None = None,
    size: "tuple[int, int] | None" = None,
    times: "float | list[float] | None" = None,
    all: bool = False,
    cut: str | None = None,
    at: "str | float | None" = None,
    log: bool = False,
    range: "tuple[str | float, str | float] | None" = None,
    percentiles: "tuple[float, float] | None" = None,
    exaggerate: float | None = None,
    bolts: bool = True,
    shadows: bool = True,
    chains: bool = False,
    contacts: "bool | str" = False,
    trails: "bool | str" = False,
    vectors: str | None = None,
    of: str | None = None,
    fps: float | None = None,
) -> Picture:
    """Draws the blocks of a run in space as they stand: PNG pictures, numbered if there are several, or a film.

    Args:
        run: the run folder.
        out: ``.png``, or ``.apng`` for a film (animated PNG); by default ``plots/shot.png`` in the run folder.
        by: field that colours the blocks; by default ``material``, of removable blocks their type, of a saved view its field.
        view: where the eye stands: degrees clockwise from north (y), and above the horizon; (215, 28) by default.
        perspective: angle of view from the lower to the upper edge [deg]; without it a parallel projection.
        saved: name of a view that was saved in ``riprap view``.
        views: file of saved views; by default ``views.json`` in the run folder.
        size: width and height of the blocks' part of the picture [pixels]; (1000, 700) by default.
        times: model times of frames [s]; by default the last frame, of a film all frames.
        all: all frames.
        cut: axis across a plane, ``x``, ``y`` or ``z``; the side nearer to the eye is cut away.
        at: place of the plane along its axis, ``"2 m"`` or a number [m].
        log: logarithmic colours.
        range: values of the first and the last colour, with units or in SI: ``("0 mm", "5 mm")``.
        percentiles: percentiles of the values at which the colours begin and end: ``(2, 98)``.
        exaggerate: factor on displacements.
        bolts: bolts as rods.
        shadows: shadows of the sun, and darker hollows.
        chains: contact forces as tubes from block to block.
        contacts: contacts as points coloured by state: ``True`` those that slide, have broken or are open, ``"all"`` all.
        trails: the ways of all blocks that moved by a quarter of a block, up to the frame: ``True`` or ``"speed"`` by mean speed, ``"block"`` by block.
        vectors: field of vectors, drawn as arrows: ``displacement``, ``velocity`` or ``force``.
        of: only blocks of this group, block or condition, and the bolts and contacts between them.
        fps: pictures of a film in a second; 10 by default.

    Raises:
        PlotError: a run in the plane, no such field or view, or an option cannot be.
        ValueError: a place or a value is none, or options exclude each other.
    """
    folder = run.path if isinstance(run, RunFolder) else Path(run)
    listed = [] if times is None else [times] if isinstance(times, (int, float)) else list(times)
    together = {"range": range, "percentiles": percentiles, "saved": saved, "view": view, "perspective": perspective}
    together |= {"times": times, "all": all or None}
    for one, other in (("range", "percentiles"), ("saved", "view"), ("saved", "perspective"), ("times", "all")):
        if together[one] is not None and together[other] is not None:
            raise ValueError(f"{one} and {other} exclude each other")
    for one, other, given in (("at", "cut", at is not None and cut is None), ("views", "saved", views is not None and saved is None)):
        if given:
            raise ValueError(f"{one} needs {other}")
    options = {
        "by": by,
        "times": [float(t) for t in listed],
        "all": all,
        "view": None if view is None else list(view),
        "perspective": perspective,
        "saved": saved,
        "views": None if views is None else Path(views),
        "size": None if size is None else list(size),
        "cut": cut,
        "at": _metres(at),
        "log": log,
        "range": None if range is None else list(range),
        "percentiles": None if percentiles is None else list(percentiles),
        "exaggerate": exaggerate,
        "bolts": bolts,
        "shadows": shadows,
        "chains": chains,
        "contacts": _chosen(contacts, "changed"),
        "trails": _chosen(trails, "speed"),
        "vectors": vectors,
        "of": of,
        "fps": fps,
    }
    target = Path(out) if out is not None else folder / "plots" / "shot.png"
    return Picture(_riprap.shot(folder, target, options))


def _chosen(given: "bool | str", usual: str) -> str | None:
    return given if isinstance(given, str) else usual if given else None


def _metres(length: "str | float | None") -> float | None:
    return _riprap.si(length, "m") if isinstance(length, str) else length
