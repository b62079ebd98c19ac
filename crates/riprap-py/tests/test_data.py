"""Arrays, tables, frames, run folders, pictures."""

import copy
import json
import pickle

import numpy as np
import pytest

import riprap


def test_fields_keep_their_unit_until_they_are_computed_with(slide):
    slip = slide.histories()["slip"]
    assert isinstance(slip, riprap.Field) and (slip.name, slip.unit, slip.label) == ("slip", "m", "slip [m]")
    assert slip[10:20].unit == "m" and slip.copy().unit == "m" and copy.deepcopy(slip).unit == "m"
    assert pickle.loads(pickle.dumps(slip)).unit == "m"
    for computed in (slip * 2, slip**2, np.sqrt(slip), slip + slip, np.cumsum(slip)):
        assert not hasattr(computed, "unit") or computed.unit != "m" or not isinstance(computed, riprap.Field)
    assert float(slip.max()) == float(np.asarray(slip).max())
    slip = slip.copy()
    slip += 1.0
    assert slip[0] == pytest.approx(1.0) and isinstance(slip, np.ndarray)


def test_tables(slide):
    table = slide.histories()
    assert list(table) == ["step", "time", "slip"] and table.units["slip"] == "m"
    with pytest.raises(KeyError, match="did you mean 'slip'"):
        table["slp"]
    energy = slide.energy()
    assert energy["kinetic"].unit == "J/m" and len(energy["kinetic"]) == len(energy.time)
    total = energy["residual"][-1] / max(abs(energy["kinetic"]))
    assert abs(total) < 1e-3


def test_series_leave_out_what_was_not_due(blast):
    """Histories of different rhythms share a table with gaps."""
    histories = blast.histories()
    time, heave = histories.series("heave")
    assert np.isnan(histories["heave"]).any() and not np.isnan(heave).any()
    assert time.shape == heave.shape and (heave.unit, time.unit) == ("m/s", "s")


def test_pandas(slide):
    pandas = pytest.importorskip("pandas")
    ours = slide.histories().to_pandas(index="time")
    theirs = pandas.read_csv(slide.path / "histories.csv").set_index("time [s]")
    pandas.testing.assert_frame_equal(ours, theirs, check_dtype=False)
    frame = slide.frame(-1).to_pandas()
    assert len(frame) == 2 and "displacement.x [m]" in frame


def test_frames_of_the_plane(slide):
    assert len(slide) == len(slide.times) == 51 and slide.times[0] == 0
    first, last = slide.frame(0), slide.frame()
    assert first.time == 0 and last.time == pytest.approx(1.0)
    assert first.n_blocks == 2 and first.points.unit == "m" and first.points.shape == (8, 3)
    moved = last.points - first.points - np.pad(np.repeat(last.blocks["displacement"], 4, 0), ((0, 0), (0, 1)))
    assert np.abs(moved[:4]).max() < 1e-12
    assert last.blocks["displacement"].shape == (2, 2)
    assert last.contacts["force_on_a"].shape == (len(last.contact_points), 2)
    assert slide.frame(time=0.5).time == pytest.approx(0.5, abs=0.011)
    assert first.corners(-1).shape == (4, 3) and len(first.faces(0)) == 1
    with pytest.raises(IndexError, match="there is no frame 99"):
        slide.frame(99)
    with pytest.raises(IndexError):
        first.corners(2)
    with pytest.raises(KeyError, match="did you mean 'displacement'"):
        last.blocks["displacment"]


def test_frames_in_space(blast):
    frame = blast.frame()
    assert frame.blocks["velocity"].shape == (frame.n_blocks, 3)
    faces, corners = frame.faces(0), frame.corners(0)
    assert len(faces) == 6 and corners.shape == (8, 3)
    assert blast.histories()["charge.pressure"].unit == "Pa"
    assert blast.histories()["charge.pressure"][-1] > 1e8


@pytest.mark.parametrize("which", ["slide", "blast"])
def test_pyvista(which, request):
    """Our grid and the file read by VTK have the same cells, sizes and fields."""
    pyvista = pytest.importorskip("pyvista")
    run = request.getfixturevalue(which)
    frame = run.frame()
    ours, theirs = frame.to_pyvista(), run.pyvista()
    assert isinstance(ours, pyvista.UnstructuredGrid) and ours.n_cells == theirs.n_cells == frame.n_blocks
    assert np.array_equal(ours.celltypes, theirs.celltypes)
    assert np.allclose(ours.points, theirs.points)
    size = "Volume" if which == "blast" else "Area"
    sizes = [g.compute_cell_sizes(length=False, vertex_count=False).cell_data[size] for g in (ours, theirs)]
    assert np.allclose(*sizes) and np.all(sizes[0] > 0)
    for name, field in frame.blocks.items():
        assert np.allclose(ours.cell_data[field.label], theirs.cell_data[field.label], equal_nan=True), name
    for grid in (ours, theirs):
        assert "velocity [m/s]" in grid.cell_data and "velocity" not in grid.cell_data
        assert "block" in grid.cell_data
        assert np.allclose(grid["principal_stress_1 [Pa]"], frame.principal_stresses()[0][:, 0])
        assert grid["principal_direction_1"].shape == (frame.n_blocks, 3)
    contacts = frame.contacts_to_pyvista()
    assert contacts.n_points == len(frame.contact_points)
    assert ("force_on_a [N]" if which == "blast" else "force_on_a [N/m]") in contacts.point_data


@pytest.mark.parametrize("which", ["slide", "blast"])
def test_principal_stresses_are_those_of_the_tensor(which, request):
    frame = request.getfixturevalue(which).frame()
    values, directions = frame.principal_stresses()
    assert values.unit == "Pa" and np.all(np.diff(values, axis=1) <= 0)
    normal, shear = np.asarray(frame.blocks["stress_normal"]), np.asarray(frame.blocks["stress_shear"])
    # The traction across each principal direction is along it.
    x, y, z = directions[..., 0], directions[..., 1], directions[..., 2]
    if which == "blast":
        n, s = normal[:, None, :], shear[:, None, :]
        rows = [
            n[..., 0] * x + s[..., 2] * y + s[..., 1] * z,
            s[..., 2] * x + n[..., 1] * y + s[..., 0] * z,
            s[..., 1] * x + s[..., 0] * y + n[..., 2] * z,
        ]
        compressed = frame.blocks["sigma1_compressive"]
        assert np.allclose(-values[:, -1], compressed, rtol=1e-6, atol=1e-6 * np.abs(normal).max())
    else:
        n, s = normal[:, None, :], shear[:, None]
        rows = [n[..., 0] * x + s * y, s * x + n[..., 1] * y, 0 * z]
    assert np.allclose(np.stack(rows, axis=-1), values[..., None] * directions, atol=1e-9 * np.abs(normal).max())
    assert np.abs(normal).max() > 0


def test_pictures(slide, blast, tmp_path):
    picture = slide.plot("histories", "slip")
    assert picture.file(".svg") and picture._repr_svg_().lstrip().startswith("<")
    over = slide.plot("histories", "slip", against="step").file(".csv")
    assert over.name == "histories_slip_against_step_data.csv" and over.read_text().splitlines()[0].strip(chr(34)).startswith("step")
    assert slide.plot("energy", out=tmp_path / "e.png")._repr_png_().startswith(b"\x89PNG")
    assert slide.plot("blocks", by="velocity.x", times=[0.0, 0.5]).file(".csv")
    assert blast.plot("section", by="velocity", at="0.1 m", vectors="velocity", stress=True).file(".svg")
    line = blast.plot("line", by="velocity", line=((0.1, 0.1, "-1 m"), (4.0, 0.1, -1.0))).file(".csv")
    assert line.name == "line_velocity_data.csv" and line.read_text().startswith('"distance, t')
    with pytest.raises(riprap.PlotError, match="meets no block"):
        blast.plot("line", line=((0, 0, 50), (1, 0, 50)))
    assert blast.plot("cavity").file(".svg")
    with pytest.raises(riprap.PlotError, match="velocity"):
        slide.plot("blocks", by="velocty")
    with pytest.raises(riprap.PlotError, match="in the plane"):
        slide.plot("ppv")
    with pytest.raises(ValueError, match="valid pictures"):
        slide.plot("nonsense")
    with pytest.raises(ValueError, match="normal"):
        blast.plot("section", normal="w")


def test_shots_of_blocks_in_space(slide, blast, tmp_path):
    one = blast.shot(tmp_path / "a.png", view=(180, 10), perspective=40, by="velocity", cut="y", at="0.1 m", size=(200, 150))
    assert one._repr_png_().startswith(b"\x89PNG")
    film = riprap.shot(blast, tmp_path / "a.apng", by="material", times=[0.0, 5.0e-4], size=(120, 90), fps=5)
    assert b"acTL" in film.files[0].read_bytes() and film._repr_png_()
    view = {"name": "south", "eye": [0, -30, 5], "target": [0, 0, 0], "up": [0, 0, 1], "angle": 30, "field": "velocity"}
    (tmp_path / "views.json").write_text(json.dumps({"views": [view]}))
    assert blast.shot(tmp_path / "b.png", saved="south", views=tmp_path / "views.json", size=(100, 80)).files
    assert blast.shot(tmp_path / "c.png", trails=True, contacts="all", size=(100, 80)).files
    with pytest.raises(ValueError, match='trails="colour"; write one of "speed", "block"'):
        blast.shot(tmp_path / "c.png", trails="colour")
    with pytest.raises(riprap.PlotError, match="valid names: south"):
        blast.shot(tmp_path / "b.png", saved="north", views=tmp_path / "views.json")
    with pytest.raises(riprap.PlotError, match="in the plane"):
        slide.shot(tmp_path / "b.png")
    with pytest.raises(riprap.PlotError, match="fps"):
        blast.shot(tmp_path / "b.png", fps=5)
    with pytest.raises(ValueError, match="exclude"):
        blast.shot(tmp_path / "b.png", saved="south", view=(0, 0))


def test_pictures_for_papers(slide, blast, tmp_path):
    pdf = slide.plot("histories", "slip", pdf=True, title="Slip of a block", size="160 mm")
    assert pdf.file(".pdf").read_bytes().startswith(b"%PDF") and pdf.file(".pdf").name == "histories_slip.pdf"
    svg = slide.plot("histories", "slip", out=tmp_path / "a.svg", title="Slip of a block", font="Georgia", size=0.16)
    text = svg.file(".svg").read_text()
    assert "Slip of a block" in text and "Georgia" in text and 'width="160.000mm"' in text
    wide = [slide.plot("energy", out=tmp_path / f"{dpi}.png", dpi=dpi).file(".png").read_bytes()[16:20] for dpi in (96, 192)]
    assert 2 * int.from_bytes(wide[0], "big") == int.from_bytes(wide[1], "big")
    data = blast.plot("section", by="velocity", range=("0 m/s", 2.0), out=tmp_path / "range.svg").file(".svg").read_text()
    assert data != blast.plot("section", by="velocity", percentiles=(5, 95), out=tmp_path / "percentiles.svg").file(".svg").read_text()
    for options, says in (
        ({"range": (0, 1), "percentiles": (2, 98)}, "exclude each other"),
        ({"pdf": True, "out": "a.svg"}, "exclude each other"),
        ({"range": ("0 mm", "much")}, "is no value"),
        ({"range": ("0 mm", "5 kg")}, "\"5 kg\" is no value of \"displacement\", which is in m"),
        ({"size": "1 km"}, "width on paper"),
        ({"dpi": 0}, "positive"),
    ):
        with pytest.raises(ValueError, match=says):
            blast.plot("section", **options)
    with pytest.raises(riprap.errors.PlotError, match="range"):
        blast.plot("section", range=(2, 1))


def test_options_that_cannot_be_are_told(blast):
    for options in ({"at": "2 s"}, {"window": ("0 s", 0, 5, 3)}):
        with pytest.raises(ValueError, match="cannot be converted to m"):
            blast.plot("section", **options)
    with pytest.raises(ValueError, match="cannot be converted to m"):
        blast.plot("crater", uplift="2 s")
    for options in ({"window": (5, 0, 0, 3)}, {"exaggerate": 0}, {"isolines": 10**6}):
        with pytest.raises(riprap.errors.PlotError, match="cannot be"):
            blast.plot("section", **options)


def test_broken_folders_are_told(slide, tmp_path):
    with pytest.raises(riprap.FolderError, match="not a run folder"):
        riprap.RunFolder(tmp_path)
    manifest = tmp_path / "manifest.json"
    for text, says in [("{", "damaged"), ("[]", "not written by"), ('{"format": "riprap-run", "format_version": 9}', "newer")]:
        manifest.write_text(text)
        with pytest.raises(riprap.FolderError, match=says):
            riprap.RunFolder(tmp_path)
    manifest.write_text((slide.path / "manifest.json").read_text())
    run = riprap.RunFolder(tmp_path)
    assert len(run.histories()) == 0 and run.times == [] and run.checks() == []
    with pytest.raises(riprap.FolderError, match="no frames"):
        run.frame()
    (tmp_path / "events.jsonl").write_text('{"event": "a"}\n{"event": "b')
    assert [e["event"] for e in run.events()] == ["a"]
    (tmp_path / "histories.csv").write_text("step,time [s]\n1,abc\n")
    with pytest.raises(riprap.FolderError, match="line 2"):
        run.histories()
    (tmp_path / "run.pvd").write_text('<VTKFile><Collection><DataSet timestep="0" file="frame.vtu"/></Collection></VTKFile>')
    (tmp_path / "frame.vtu").write_bytes(b"nonsense")
    run.refresh()
    with pytest.raises(riprap.FolderError, match="frame.vtu"):
        run.frame()


def test_stubs_name_what_there_is():
    """The stub of the compiled half lists its names, no more and no less."""
    import ast
    from pathlib import Path

    from riprap import _riprap

    stub = ast.parse((Path(riprap.__file__).parent / "_riprap.pyi").read_text())
    named = {n.name: n for n in stub.body if isinstance(n, (ast.FunctionDef, ast.ClassDef))}
    there = {n for n in dir(_riprap) if not n.startswith("__")}
    assert set(named) == there
    for name, node in named.items():
        if isinstance(node, ast.ClassDef):
            members = {m.name for m in node.body if isinstance(m, ast.FunctionDef) and not m.name.startswith("__")}
            assert members == {m for m in dir(getattr(_riprap, name)) if not m.startswith("__")}, name
    assert (Path(riprap.__file__).parent / "py.typed").exists()
