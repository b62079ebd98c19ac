"""Errors of results, and values of keys at which results are as wanted."""

import pytest

import riprap


def test_each_result_has_an_error(sliding_block, tmp_path):
    trust = riprap.trust(sliding_block(), tmp_path / "a.trust", threads=2)
    slip = trust["slip at the end"]
    low, high = slip.interval
    # g (sin 35 - cos 35 tan 20) t^2/2
    assert low < 0.5 * 9.81 * 0.27540 * 0.2**2 * 1.002 and high > 0.5 * 9.81 * 0.27540 * 0.2**2 * 0.998
    assert slip.unit == "m" and slip.error < 0.01 * slip.value and slip.holds is None
    assert slip.causes["step"] >= 0 and "stiffness" in slip.causes
    assert "equilibrium" in trust.left_out and len(trust.trials) > 5
    assert {"trust.csv", "trials.csv", "trust.json"} <= {path.name for path in trust.path.iterdir()}
    with pytest.raises(riprap.RunError, match="not empty"):
        riprap.trust(sliding_block(), tmp_path / "a.trust")
    with pytest.raises(ValueError, match="valid names: step"):
        riprap.trust(sliding_block(), tmp_path / "b.trust", without=["steps"])
    with pytest.raises(ValueError, match="write a time"):
        riprap.trust(sliding_block(), tmp_path / "b.trust", budget="10 m")


def test_a_value_for_a_wanted_result(sliding_block):
    key, between = "interfaces.default.friction_angle", ("5 deg", "30 deg")
    found = riprap.find(sliding_block(), key, between, "slip = 4 cm", threads=2)
    # tan phi = tan 35 - 2 s/(g t^2 cos 35)
    assert found.at == pytest.approx(0.42395, abs=0.003) and found.monotone and found.unit == "rad"
    with pytest.raises(ValueError, match="does not lie between them"):
        riprap.find(sliding_block(), key, between, "slip = 4 m")
    with pytest.raises(ValueError, match="unknown result"):
        riprap.find(sliding_block(), key, between, "slop = 4 cm")


def test_the_factor_of_safety_has_its_error(sliding_block, tmp_path):
    trust = riprap.trust(sliding_block(), tmp_path / "f.trust", safety=True, threads=2)
    factor = trust["factor of safety"]
    assert len(trust) == 1 and 0.0 < factor.error < 0.1 and "search" in factor.causes
