"""Whole runs: results, progress, callbacks, interruptions, resuming, sweeps."""

import concurrent.futures
import json
import math
import multiprocessing
import os
import re
import shutil
import signal
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import riprap


def test_a_sliding_block_follows_the_formula(slide):
    """Scene slide.toml: g/2 (sin a - cos a tan phi) t^2 at 35 and 20 degrees."""
    slip = slide.histories()["slip"]
    t = np.asarray(slide.histories().time)
    a, phi = math.radians(35), math.radians(20)
    expected = 0.5 * 9.81 * (math.sin(a) - math.cos(a) * math.tan(phi)) * t**2
    assert slip.unit == "m" and slip.shape == t.shape == (201,)
    assert abs(slip[-1] / expected[-1] - 1) < 2e-3
    assert slide.finished and slide.passed and slide.ended == "finished"


@pytest.mark.parametrize("threads", [1, 2])
def test_same_bits_as_the_command_line(binary, tmp_path, threads):
    """A wall of more blocks than one chunk; the final state and the histories are the same bytes."""
    from conftest import SCENES

    scene = SCENES / "planar/slide.toml"
    command = [binary, "run", scene, "--out", tmp_path / "cli.run", "--quiet", "--threads", "1"]
    subprocess.run(command, check=True)
    run = riprap.run(scene, tmp_path / "py.run", threads=threads, progress=False)
    cli = riprap.RunFolder(tmp_path / "cli.run")
    assert run.state_hash == cli.state_hash != ""
    for name in ("histories.csv", "energy.csv", "events.jsonl", "checks.jsonl"):
        assert (run.path / name).read_bytes() == (cli.path / name).read_bytes()


def test_threads_do_not_matter(blast, tmp_path):
    again = riprap.run(blast.scenario, tmp_path / "one.run", threads=1, progress=False)
    assert again.state_hash == blast.state_hash


def test_a_callback_sees_and_stops(slide_file, tmp_path):
    seen = []

    def look(p):
        seen.append((p.step, p.time, p.phase))
        assert p.energy_unit == "J/m" and p.phases == 1 and p.fastest[0] in ("block", "plane")
        return p.step < 1

    run = riprap.run(slide_file, tmp_path / "stopped.run", threads=1, progress=False, callback=look)
    assert seen and run.ended == "interrupted" and not run.passed
    whole = riprap.resume(run, threads=1, progress=False)
    assert whole.finished
    uncut = riprap.run(slide_file, tmp_path / "uncut.run", threads=1, progress=False)
    assert whole.state_hash == uncut.state_hash
    assert (whole.path / "histories.csv").read_bytes() == (uncut.path / "histories.csv").read_bytes()
    with pytest.raises(riprap.RunError, match="already ended"):
        riprap.resume(whole)


def test_an_exception_of_a_callback_comes_out(slide_file, tmp_path):
    def look(_):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        riprap.run(slide_file, tmp_path / "a.run", progress=False, callback=look)
    assert riprap.RunFolder(tmp_path / "a.run").ended == "interrupted"


def test_the_interpreter_is_free_during_a_run(slide_file, tmp_path):
    """Another thread counts while a run goes on."""
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    worker = threading.Thread(target=count)
    worker.start()
    riprap.run(slide_file, tmp_path / "a.run", threads=1, progress=False)
    during = counted[0]
    done.set()
    worker.join()
    assert during > 5


def test_ctrl_c_stops_a_run(slide_file, tmp_path):
    """SIGINT during a run: KeyboardInterrupt, and a run folder to resume from."""
    code = f"""
        import riprap, signal
        # A shell that runs this in the background has told it to ignore the signal.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        scene = riprap.Scenario({str(slide_file)!r}, set={{"phases.0.until.time": "1000 s"}})
        print("begin", flush=True)
        try:
            scene.run({str(tmp_path / "long.run")!r}, threads=1, progress=False)
        except KeyboardInterrupt:
            print("interrupted", flush=True)
    """
    child = subprocess.Popen([sys.executable, "-c", textwrap.dedent(code)], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "begin\n"
    time.sleep(1.0)
    begun = time.monotonic()
    child.send_signal(signal.SIGINT)
    try:
        out, _ = child.communicate(timeout=60)
    finally:
        child.kill()
    assert "interrupted" in out and child.returncode == 0
    assert time.monotonic() - begun < 20
    assert riprap.RunFolder(tmp_path / "long.run").ended == "interrupted"


def test_folders_are_not_overwritten(slide, slide_file, tmp_path):
    with pytest.raises(riprap.RunError, match="already contains a run"):
        riprap.run(slide_file, slide.path, progress=False)
    other = tmp_path / "other"
    other.mkdir()
    (other / "thesis.txt").write_text("precious")
    with pytest.raises(riprap.RunError, match="not empty"):
        riprap.run(slide_file, other, existing="replace", progress=False)
    with pytest.raises(ValueError, match="existing"):
        riprap.run(slide_file, other, existing="please", progress=False)
    with pytest.raises(ValueError, match="threads"):
        riprap.run(slide_file, tmp_path / "x.run", threads=0)


def test_the_default_folder_is_free(sliding_block, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    first = riprap.run(sliding_block(time="1 ms"), progress=False)
    second = riprap.run(sliding_block(time="1 ms"), progress=False)
    assert (first.path.name, second.path.name) == ("scenario.run", "scenario-2.run")


def test_an_unwritable_folder_is_an_output_error(slide_file, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(riprap.RiprapError, match="file"):
        riprap.run(slide_file, tmp_path / "file" / "a.run", progress=False)


def test_physics_that_stops_a_run_is_raised(sliding_block, tmp_path):
    wild = sliding_block()
    wild["phases"][0]["time_step"] = "10 ms"
    with pytest.raises(riprap.UnstableError) as caught:
        riprap.run(wild, tmp_path / "wild.run", progress=False)
    assert caught.value.folder.ended == "unstable"
    calm = riprap.run(wild, tmp_path / "calm.run", progress=False, strict=False)
    assert calm.ended == "unstable"


def test_progress_in_a_log(slide_file, tmp_path, capfd):
    riprap.run(slide_file, tmp_path / "a.run", threads=1, progress=True)
    assert re.search(r"phase 1/1, step \d+", capfd.readouterr().err)
    riprap.run(slide_file, tmp_path / "b.run", threads=1)
    assert capfd.readouterr().err == ""


def test_progress_in_a_terminal(slide_file, tmp_path):
    pty = pytest.importorskip("pty")
    code = f"import riprap; riprap.run({str(slide_file)!r}, {str(tmp_path / 'a.run')!r}, threads=1)"
    host, guest = pty.openpty()
    subprocess.run([sys.executable, "-c", code], stderr=guest, check=True)
    os.close(guest)
    shown = os.read(host, 100_000).decode()
    assert "[" in shown and "steps/s" in shown


def test_a_sweep_gives_a_table(sliding_block, tmp_path, capsys):
    over = {"interfaces.default.friction_angle": ["10 deg", "20 deg", "40 deg"]}
    sweep = riprap.sweep(sliding_block(time="0.1 s"), tmp_path / "s", over=over, jobs=2, progress=True)
    assert len(sweep) == 3 and all(run.finished for run in sweep.values())
    slips = [float(row["slip [m]"]) for row in sweep.rows]
    assert slips[0] > slips[1] > 100 * abs(slips[2])
    assert (tmp_path / "s/sweep.csv").read_text() == sweep.csv
    assert "3/3" in capsys.readouterr().out
    pandas = pytest.importorskip("pandas")
    assert isinstance(sweep.table(), pandas.DataFrame)
    assert list(sweep.table()["slip [m]"]) == slips
    with pytest.raises(KeyError, match="valid cases"):
        sweep["nonsense"]


def test_a_sweep_runs_what_it_is_given(sliding_block, tmp_path):
    """Variants of the scenario are not multiplied with the values, and numbers are had by the name of the case."""
    key = "interfaces.default.friction_angle"
    block = riprap.Scenario(sliding_block(time="0.1 s") | {"variants": {"rough": {key: "60 deg"}}})
    assert len(block.cases) == 2 and block.alone().cases == ["default"]
    sweep = riprap.sweep(block, tmp_path / "s", over={key: ["10 deg", "20 deg"]}, jobs=2)
    slips = sweep.numbers("slip")
    assert list(slips) == list(sweep) == ["friction_angle=10deg", "friction_angle=20deg"]
    assert list(slips.values()) == [float(row["slip [m]"]) for row in sweep.rows]
    assert slips == sweep.numbers("slip [m]")
    with pytest.raises(KeyError, match="valid columns"):
        sweep.numbers("nonsense")


def test_a_sweep_with_a_wrong_case_runs_nothing(sliding_block, tmp_path):
    over = {"interfaces.default.friction_angle": ["10 deg", "1000 MPa"]}
    with pytest.raises(riprap.ScenarioError):
        riprap.sweep(sliding_block(), tmp_path / "s", over=over)
    assert not (tmp_path / "s").exists()


def test_what_a_sweep_has_done_is_kept_when_a_report_raises(sliding_block, tmp_path, monkeypatch):
    def broken(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("builtins.print", broken)
    over = {"interfaces.default.friction_angle": ["10 deg", "20 deg", "40 deg"]}
    with pytest.raises(KeyboardInterrupt):
        riprap.sweep(sliding_block(time="0.1 s"), tmp_path / "s", over=over, jobs=1, progress=True)
    rows = (tmp_path / "s/sweep.csv").read_text().splitlines()
    assert len(rows) == 4 and "finished" in rows[1]


def test_a_search_is_not_made_for_a_folder_that_is_taken(sliding_block, tmp_path):
    """The answer is written before the mechanism is run, and a folder that is not empty is told before the search."""
    key = "interfaces.default.friction_angle"
    search = {"quantity": key, "between": ("5 deg", "60 deg"), "width": "10 deg"}
    block = sliding_block(time="0.01 s")
    taken = tmp_path / "taken"
    taken.mkdir()
    (taken / "thesis.txt").write_text("mine")
    began = time.monotonic()
    with pytest.raises(riprap.RunError, match="not empty"):
        riprap.safety(block, taken, steps=10**9, **search)
    assert time.monotonic() - began < 5 and len(list(taken.iterdir())) == 1
    # The mechanism cannot be written: the answer is there all the same.
    (taken / "thesis.txt").unlink()
    (taken / "mechanism.run").write_text("a file")
    with pytest.raises(riprap.RunError, match="the answer is in"):
        riprap.safety(block, taken, existing="replace", **search)
    assert json.loads((taken / "safety.json").read_text())["quantity"] == key
    assert (taken / "safety.csv").read_text()


def test_a_factor_of_safety_and_the_limit_of_a_quantity(sliding_block, tmp_path, capsys):
    """A block on a slope slides at tan(friction) = tan(slope), whichever of both is searched for."""
    block = sliding_block(time="0.01 s")
    key = "interfaces.default.friction_angle"
    slope = math.radians(35)
    found = riprap.safety(block, tmp_path / "q", quantity=key, between=("5 deg", "60 deg"), threads=2, progress=True)
    assert abs(found.limit - slope) < 0.02 and found.unit == "rad" and found.mechanism == "sliding"
    assert found.run is not None and (tmp_path / "q/safety.csv").read_text() == found.csv
    assert "stable" in capsys.readouterr().out and len(found.trials) > 4
    block = sliding_block(friction="60 deg", time="0.01 s")
    found = riprap.safety(block, tmp_path / "f", width=0.05, moved="4 mm")
    assert abs(found.limit - math.tan(math.pi / 3) / math.tan(slope)) < 0.1 and found.quantity is None
    with pytest.raises(ValueError, match="write"):
        riprap.safety(block, tmp_path / "n", quantity=key, between=("5 deg", "1 m"))
    with pytest.raises(riprap.ScenarioError):
        riprap.safety(block, tmp_path / "n", quantity=key, between=("1 m", "2 m"))


def test_manifest_and_events(slide):
    assert slide.manifest["format"] == "riprap-run" and slide.manifest["riprap"] == riprap.__version__
    kinds = [e["event"] for e in slide.events()]
    assert kinds[0] == "phase_started" and slide.events("phase_ended")[0]["phase"] == "slide"
    assert json.loads((slide.path / "manifest.json").read_text()) == slide.manifest
    assert [c["status"] for c in slide.checks()] == ["passed"]


FRICTION = "interfaces.default.friction_angle"
RANDOM = {FRICTION: {"normal": {"mean": "20 deg", "deviation": "5 deg"}}}


def study(block, out, **options):
    """A block on a slope of 20 degrees with random friction."""
    return riprap.monte_carlo(
        block, RANDOM, 6, 3, out, fails_when={"field": "block.speed", "of": "block", "above": "0.27 m/s"}, **options
    )


def test_a_monte_carlo_study_has_a_probability(sliding_block, tmp_path):
    found = study(sliding_block(time="0.1 s"), tmp_path / "m", jobs=2)
    assert len(found) == 6 and 0 < found.probability < 1
    assert found.interval[0] < found.probability < found.interval[1]
    assert found.influence()[FRICTION] < -0.5
    assert found.influence("slip")[FRICTION] < -0.9
    assert json.loads((tmp_path / "m/monte_carlo.json").read_text()) == found.summary
    with pytest.raises(KeyError, match="valid histories"):
        found.influence("nonsense")
    with pytest.raises(riprap.ScenarioError, match="nothing is random"):
        riprap.monte_carlo(sliding_block(), out=tmp_path / "n")
    with pytest.raises(riprap.ScenarioError, match="from 2 to 10000"):
        riprap.monte_carlo(sliding_block(), RANDOM, 0, out=tmp_path / "n")


def test_executors_give_the_numbers_of_a_serial_study(sliding_block, tmp_path):
    block = sliding_block(time="0.1 s")
    serial = study(block, tmp_path / "serial", jobs=1)
    spawn = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(max_workers=2, mp_context=spawn) as pool:
        parallel = study(block, tmp_path / "pool", executor=pool)
        assert parallel.summary == serial.summary and parallel.rows == serial.rows
        sweep = riprap.sweep(block, tmp_path / "s", over={FRICTION: ["10 deg", "40 deg"]}, executor=pool)
        assert list(sweep) == ["friction_angle=10deg", "friction_angle=40deg"]
        with pytest.raises(ValueError, match="exclude each other"):
            riprap.sweep(block, tmp_path / "s", executor=pool, jobs=2)


def test_dask_runs_the_samples(sliding_block, tmp_path):
    distributed = pytest.importorskip("distributed")
    block = sliding_block(time="0.1 s")
    serial = study(block, tmp_path / "serial", jobs=1)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            assert study(block, tmp_path / "dask", executor=client.get_executor()).summary == serial.summary


def test_mpi_runs_the_samples(sliding_block, tmp_path):
    """Three ranks: one hands out the samples, two run them."""
    pytest.importorskip("mpi4py")
    mpiexec = shutil.which("mpiexec", path=str(Path(sys.executable).parent)) or shutil.which("mpiexec")
    if mpiexec is None:
        pytest.skip("there is no mpiexec")
    block = sliding_block(time="0.1 s")
    serial = study(block, tmp_path / "serial", jobs=1)
    riprap.Scenario(block).save(tmp_path / "block.toml")
    (tmp_path / "study.py").write_text(
        textwrap.dedent(
            f"""
            import riprap
            from mpi4py.futures import MPIPoolExecutor

            if __name__ == "__main__":
                with MPIPoolExecutor() as pool:
                    riprap.monte_carlo(
                        "block.toml", {RANDOM!r}, 6, 3, "mpi", executor=pool,
                        fails_when={{"field": "block.speed", "of": "block", "above": "0.27 m/s"}},
                    )
            """
        )
    )
    done = subprocess.run(
        [mpiexec, "-n", "3", sys.executable, "-m", "mpi4py.futures", "study.py"],
        cwd=tmp_path, capture_output=True, text=True, timeout=120,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert json.loads((tmp_path / "mpi/monte_carlo.json").read_text()) == serial.summary


def lost(*_):
    os._exit(9)


class Losing(concurrent.futures.ProcessPoolExecutor):
    """Loses the worker of its third task."""

    submitted = 0

    def submit(self, task, *args):
        self.submitted += 1
        return super().submit(lost if self.submitted == 3 else task, *args)


def test_a_lost_worker_is_reported_and_the_study_goes_on(sliding_block, tmp_path):
    block = sliding_block(time="0.1 s")
    serial = study(block, tmp_path / "serial", jobs=1)
    with Losing(max_workers=1, mp_context=multiprocessing.get_context("spawn")) as pool:
        with pytest.raises(riprap.RunError, match="did not come back.*BrokenProcessPool"):
            study(block, tmp_path / "lost", executor=pool)
    rows = (tmp_path / "lost/sweep.csv").read_text()
    assert "not run" in rows and rows.count("finished") == 2
    again = study(block, tmp_path / "lost", jobs=2)
    assert again.summary == serial.summary
