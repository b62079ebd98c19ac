//! Many runs of one scene, and one run by several ranks.

use super::bench::{Bench, FALL, Said};

/// A stone that falls onto the floor with a random speed.
fn random_fall(samples: usize) -> String {
    let random = format!(
        "[distributions]\n\"blocks.stone.velocity.1\" = {{ uniform = [\"-2 m/s\", \"2 m/s\"] }}\n\
         [monte_carlo]\nsamples = {samples}\nfails_when = {{ field = \"block.displacement.y\", of = \"stone\", reduce = \"min\", below = \"-0.19 m\" }}\n"
    );
    let model = FALL.split("[bisect]").next().expect("the model");
    format!("{model}{random}")
}

#[test]
fn random_samples_have_a_probability_of_failure() {
    let bench = Bench::new();
    bench.file("random.toml", random_fall(8));
    bench.run(&["monte-carlo", "random.toml", "--out", "all"]).expect(0).says(&[
        "8/8",
        "4 of 8 samples fail: probability of failure 50.0 % (95 %: 15.7 % to 84.3 %)",
        "correlation with failure",
        "blocks.stone.velocity.1 [m/s]",
        "monte_carlo.json",
    ]);
    let numbers: serde_json::Value =
        serde_json::from_str(&bench.read("all/monte_carlo.json")).unwrap();
    assert_eq!(numbers["finished"], 8);
    // The same command again runs nothing.
    bench.run(&["monte-carlo", "random.toml", "--out", "all"]).expect(0).says(&["kept"]);
    // A random value cannot be fixed, and what is wrong is told before anything runs.
    bench
        .run(&["monte-carlo", "random.toml", "--set", "blocks.stone.velocity.1=1 m/s"])
        .expect(2)
        .warns(&["fixes what the scene varies", "distributions"]);
    bench.run(&["monte-carlo", "fall.toml"]).expect(2);
    bench.file("plain.toml", FALL);
    bench.run(&["monte-carlo", "plain.toml"]).expect(2).warns(&["nothing is random", "explain"]);
    bench.run(&["run", "random.toml", "-q", "--out", "one"]).expect(0);
    assert!(!bench.read("one/scenario.resolved.toml").contains("distributions"));
}

#[cfg(unix)]
#[test]
fn parts_of_an_array_of_jobs_are_merged() {
    let bench = Bench::new();
    bench.file("slope.toml", random_fall(7));
    let page = include_str!("../../../../docs/src/how-to/many-runs.md");
    let script =
        page.split("```sh\n").find(|part| part.starts_with("#!/bin/sh")).expect("the script");
    let script = script.split("```").next().expect("its end");
    bench.file("job.sh", script);
    let merge = ["monte-carlo", "slope.toml", "--out", "slope.mc", "--merge"];
    bench.run(&merge).expect(2).warns(&["slope.mc does not exist"]);
    // As Slurm starts the jobs of an array of three: here the last one first.
    let job = |number: &str| {
        let program =
            std::path::Path::new(env!("CARGO_BIN_EXE_riprap")).parent().expect("a folder");
        let path = std::env::var("PATH").unwrap_or_default();
        let done = std::process::Command::new("sh")
            .arg("job.sh")
            .current_dir(bench.path(""))
            .env("PATH", format!("{}:{path}", program.display()))
            .env("SLURM_ARRAY_TASK_ID", number)
            .env("SLURM_ARRAY_TASK_COUNT", "3")
            .output()
            .expect("the job");
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    };
    job("3");
    job("1");
    bench.run(&merge).expect(1).warns(&["sample-2: not run"]);
    job("2");
    bench.run(&merge).expect(0).says(&["7 samples"]);
    assert!(bench.read("slope.mc/sweep.csv").lines().count() == 8);
    for part in ["0/3", "4/3", "1", "a/b"] {
        bench.run(&["sweep", "slope.toml", "--part", part]).expect(2).warns(&["3/20"]);
    }
}

/// Programs of a launcher would all write into one folder; what is one of a kind runs on.
#[test]
fn a_build_without_mpi_refuses_to_be_one_of_many() {
    let bench = Bench::with_scene();
    let under = |words: &[&str], variables: &[(&str, &str)]| {
        let mut command = bench.command(words);
        command.envs(variables.iter().copied());
        Said::from(command.output().expect("start riprap"))
    };
    let run = ["run", "fall.toml", "-q", "--out", "a.run"];
    if cfg!(not(feature = "mpi")) {
        for variables in [
            [("OMPI_COMM_WORLD_SIZE", "4"), ("OMPI_COMM_WORLD_RANK", "0")],
            [("PMI_SIZE", "2"), ("PMI_RANK", "1")],
            [("SLURM_STEP_NUM_TASKS", "2"), ("SLURM_PROCID", "0")],
        ] {
            let told = format!("{}={}", variables[0].0, variables[0].1);
            under(&run, &variables).expect(2).warns(&[&told, "same folder", "--features mpi"]);
            under(&["resume", "a.run"], &variables).expect(2).warns(&[&told]);
            assert!(!bench.path("a.run").exists());
        }
    }
    // A batch job with room for four tasks that has started none, and one of an array.
    under(&run, &[("SLURM_NTASKS", "4"), ("SLURM_PROCID", "0"), ("SLURM_JOB_ID", "7")]).expect(0);
    let sweep = bench.read("fall.toml")
        + "\n[sweep]\n\"interfaces.default.friction_angle\" = [\"20 deg\", \"30 deg\"]\n";
    bench.file("sweep.toml", sweep);
    let part = ["sweep", "sweep.toml", "-q", "--out", "many", "--part", "2/2"];
    under(&part, &[("SLURM_STEP_NUM_TASKS", "2"), ("SLURM_PROCID", "1")]).expect(0);
}

#[cfg(unix)]
#[test]
fn ranks_stop_and_go_on_together() {
    let bench = Bench::with_long_scene();
    let run = bench.start(&["run", "long.toml", "--out", "a.run", "--ranks", "3"]);
    bench.wait_for("a history", || {
        std::fs::metadata(bench.path("a.run/histories.csv")).is_ok_and(|m| m.len() > 2000)
    });
    run.signal("INT");
    run.end().expect(130).warns(&["a checkpoint is in a.run"]).says(&["ranks: 3"]);
    let before = bench.read("a.run/histories.csv").len();
    let resumed = bench.start(&["resume", "a.run", "--ranks", "2"]);
    bench.wait_for("more history", || bench.read("a.run/histories.csv").len() > before + 2000);
    resumed.signal("TERM");
    resumed.end().expect(130);
    bench
        .run(&["check", "long.toml", "--ranks", "2"])
        .expect(0)
        .says(&["ranks      2", "in the plane are not shared out"]);
}

/// `mpirun` with the program of this build, as root or not, with more ranks than cores.
#[cfg(all(unix, feature = "mpi"))]
fn mpirun(bench: &Bench, ranks: &str, words: &[&str]) -> std::process::Command {
    let mut command = std::process::Command::new("mpirun");
    command
        .args(["-n", ranks, env!("CARGO_BIN_EXE_riprap")])
        .args(words)
        .current_dir(bench.path(""));
    for (name, value) in [
        ("OMPI_ALLOW_RUN_AS_ROOT", "1"),
        ("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"),
        ("OMPI_MCA_rmaps_base_oversubscribe", "1"),
    ] {
        command.env(name, value);
    }
    command
}

#[cfg(all(unix, feature = "mpi"))]
#[test]
fn ranks_by_mpi_leave_the_bytes_of_one() {
    let bench = Bench::in_memory();
    let lattice = include_str!("../../../../scenes/bench/lattice.toml");
    let small = lattice.replace("\"22 m\"", "\"8 m\"").replace("steps = 100000", "steps = 60");
    assert!(small.contains("\"8 m\"") && small.contains("steps = 60"));
    bench.file("small.toml", small);
    bench.run(&["run", "small.toml", "-q", "-j", "1", "--out", "one.run"]).expect(0);
    let many = ["run", "small.toml", "-j", "1", "--out", "many.run"];
    let said = Said::from(mpirun(&bench, "3", &many).output().expect("start mpirun"));
    // One of them speaks.
    assert_eq!(said.out.matches("done:").count(), 1, "{}", said.out);
    said.expect(0).says(&["ranks: 3"]);
    for file in ["energy.csv", "events.jsonl", "run.pvd", "final_states.csv"] {
        let text = |run: &str| bench.read(&format!("{run}/{file}"));
        assert!(text("one.run") == text("many.run"), "{file} differs");
    }
    let hash = |run: &str| bench.run(&["hash", run]).expect(0).out;
    assert_eq!(hash("one.run"), hash("many.run"));
    // What stops rank 0 ends all, with its message and exit code.
    let again = Said::from(mpirun(&bench, "2", &many).output().expect("start mpirun"));
    again.expect(2).warns(&["already contains a run"]);
}
