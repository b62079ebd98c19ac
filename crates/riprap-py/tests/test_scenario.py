"""Scenarios: three ways in, errors with places, cases."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

import riprap


def test_a_dictionary_a_text_and_a_file_mean_the_same(sliding_block, tmp_path):
    from_dict = riprap.Scenario(sliding_block())
    from_text = riprap.Scenario(from_dict.text)
    from_file = riprap.Scenario(from_dict.save(tmp_path / "slide.toml"))
    hashes = {s.check().input_hash for s in (from_dict, from_text, from_file)}
    assert len(hashes) == 1
    assert from_dict.title == "A block slides" and from_dict.space == "planar"
    assert from_file.file == tmp_path / "slide.toml" and from_text.file is None


def test_errors_have_file_line_and_help(tmp_path):
    file = tmp_path / "slope.toml"
    file.write_text('riprap = 1\n[space.planar]\n[materials.rock]\ndensity = "30 deg"\n')
    with pytest.raises(riprap.ScenarioError) as caught:
        riprap.Scenario(file)
    first = next(d for d in caught.value.diagnostics if d.code == "unit.dimension")
    assert (first.file, first.line, first.severity) == (str(file), 4, "error")
    assert f"{file}:4:11" in str(caught.value) and "help" in str(caught.value)
    assert first.text in str(caught.value)
    assert isinstance(caught.value, ValueError)


def test_errors_of_a_dictionary_show_its_toml(sliding_block):
    wrong = sliding_block()
    wrong["interfaces"]["default"]["fricton_angle"] = "5 deg"
    with pytest.raises(riprap.ScenarioError, match="did you mean `friction_angle`") as caught:
        riprap.Scenario(wrong)
    assert caught.value.diagnostics[0].file == "<scenario>"
    assert "fricton_angle = \"5 deg\"" in str(caught.value)


def test_errors_of_the_model_come_from_check(sliding_block):
    wrong = sliding_block()
    wrong["blocks"][1] = {"name": "block", "material": "rock", "polygon": {"points": [["0 m", "0 m"], ["1 m", "1 m"], ["0 m", "1 m"], ["1 m", "0 m"]]}}
    scenario = riprap.Scenario(wrong)
    with pytest.raises(riprap.ScenarioError) as caught:
        scenario.check()
    assert caught.value.diagnostics[0].line is not None


@pytest.mark.parametrize(
    ("value", "error"),
    [(object(), TypeError), ([None], ValueError), (10**30, ValueError), ({1: 2}, TypeError), (b"x", TypeError)],
)
def test_values_that_are_no_toml_are_named(sliding_block, value, error):
    wrong = {**sliding_block(), "title": value}
    with pytest.raises(error, match="title"):
        riprap.Scenario(wrong)


def test_a_dictionary_that_contains_itself_is_refused():
    endless: dict = {}
    endless["a"] = endless
    with pytest.raises(ValueError, match="nested too deeply"):
        riprap.Scenario(endless)


def test_numpy_and_none(sliding_block, tmp_path):
    scene = sliding_block()
    scene["interfaces"]["default"]["damping_ratio"] = np.float32(0.25)
    scene["description"] = None
    scene["interfaces"]["default"]["normal_stiffness"] = "100 GPa/m"
    scenario = riprap.Scenario(scene)
    assert "damping_ratio = 0.25" in scenario.text and "description" not in scenario.text
    odd = riprap._riprap.to_toml({"a": np.arange(3), "b": np.int64(4), "c": Path("x.csv"), "d": (True, 'é\n"')})
    assert tomllib.loads(odd) == {"a": [0, 1, 2], "b": 4, "c": "x.csv", "d": [True, 'é\n"']}


def test_set_and_cases(slide_file):
    scenario = riprap.Scenario(slide_file, set={"interfaces.default.friction_angle": "40 deg"})
    assert 'friction_angle = "40 deg"' in scenario.text
    assert len(scenario.cases) == 3
    again = scenario.with_set({"interfaces.default.damping_ratio": 0.3})
    assert "damping_ratio = 0.3" in again.text
    with pytest.raises(riprap.ScenarioError, match="did you mean `friction_angle`"):
        riprap.Scenario(slide_file, set={"interfaces.default.friction": 1})
    with pytest.raises(ValueError, match="valid cases"):
        scenario.check("nonsense")


def test_check_says_what_to_expect(slide_file):
    report = riprap.Scenario(slide_file).check()
    assert report.model["blocks"] == 2 and report.expected["steps"] > 1000
    assert report.expected["time_step"] > 0 and "2 blocks" in str(report)


def test_a_time_step_that_is_too_long_is_told_at_its_place(tmp_path):
    """In space it is refused before anything is written."""
    scene = Path(__file__).resolve().parents[3] / "scenes/spatial/blast.toml"
    text = scene.read_text().replace('name = "blast"', 'name = "blast"\ntime_step = "1 s"')
    scenario = riprap.Scenario(text)
    ask = [scenario.check, lambda: scenario.run(tmp_path / "a.run", progress=False), lambda: riprap.Simulation(scenario)]
    for question in ask:
        with pytest.raises(riprap.ScenarioError, match="exceeds the stable step") as caught:
            question()
        assert caught.value.diagnostics[0].line == 1 + text[: text.index('"1 s"')].count("\n")
    assert not (tmp_path / "a.run").exists()


def test_missing_files_are_told(tmp_path):
    with pytest.raises(riprap.ScenarioError, match="cannot read the file"):
        riprap.Scenario(tmp_path / "nowhere.toml")
    with pytest.raises(riprap.ScenarioError, match="folder"):
        riprap.Scenario(tmp_path)


def test_words():
    assert riprap.si("16 GPa") == 16e9
    with pytest.raises(ValueError, match="16 GPx"):
        riprap.si("16 GPx")
    assert riprap.si("2 mm", "m") == 2e-3
    with pytest.raises(ValueError, match="cannot be converted to m"):
        riprap.si("2 s", "m")


def test_a_path_may_have_an_equals_sign(sliding_block, tmp_path):
    folder = tmp_path / "friction_angle=10deg"
    folder.mkdir()
    file = riprap.Scenario(sliding_block()).save(folder / "a.toml")
    riprap.Scenario(sliding_block()).save(folder / "scenario")
    assert riprap.Scenario(str(file)).file == file
    assert riprap.Scenario(str(folder / "scenario")).file == folder / "scenario"
    with pytest.raises(riprap.RiprapError, match="missing.toml"):
        riprap.Scenario(str(folder / "missing.toml"))
    with pytest.raises(riprap.ScenarioError, match="<scenario>"):
        riprap.Scenario("riprap = 1")
    names = {f.name for f in riprap.fields("planar")}
    assert "block.displacement" in names
    assert {f.name for f in riprap.fields("spatial")} != names
    with pytest.raises(ValueError, match="planar, spatial"):
        riprap.fields("flat")
    assert riprap.schema()["properties"]
    assert "friction" in riprap.explain("interfaces.default.friction_angle")
    with pytest.raises(ValueError):
        riprap.explain("nonsense.key")
