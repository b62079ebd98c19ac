//! What a blast has made.

use super::bench::{Bench, FALL};

/// A charge in the middle of 27 bricks whose joints hardly hold.
const SHOT: &str = r#"
riprap = 1
title = "bricks are blown apart"

[space.spatial]
gravity = "9.81 m/s2"

[materials.rock]
density = "2000 kg/m3"
young = "1 GPa"
poisson = 0.25

[interfaces.default]
cohesion = "10 kPa"
friction_angle = "30 deg"

[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["3 m", "3 m", "3 m"], cell = "1 m", corner = ["-1.5 m", "-1.5 m", "0 m"] }

[explosives.anfo]
density = "1000 kg/m3"
detonation_velocity = "4000 m/s"
heat_of_explosion = "3688 kJ/kg"

[sources.charge.gas_cavity]
centre = ["0 m", "0 m", "1.5 m"]
mass = "5 kg"
explosive = "anfo"
coupling = "decoupled"

[[phases]]
name = "blast"
until.time = "0.1 s"

[[outputs]]
frames = { every = "50 ms" }
"#;

#[test]
fn a_muckpile_is_told_in_words_tables_and_pictures() {
    let bench = Bench::new();
    bench.file("shot.toml", SHOT);
    bench.run(&["run", "shot.toml"]).expect(0);
    bench.run(&["muckpile", "shot.run", "--moved", "10 cm", "--rock-factor", "7"]).expect(0).says(
        &["thrown: 6 blocks", "muckpile:", "flyrock:", "Kuz-Ram:", "work of the gas", "kinetic"],
    );
    let energy = bench.read("shot.muckpile/energy_partition.csv");
    let shares = |way: &str| {
        let rows = energy.lines().filter(|line| line.starts_with(way));
        rows.filter_map(|line| line.split(',').nth(3)?.parse::<f64>().ok()).sum::<f64>()
    };
    // All that was put in is somewhere.
    assert!((shares("from") - 1.0).abs() < 1e-9, "{energy}");
    assert!((shares("to") - 1.0).abs() < 1e-6, "{energy}");
    for picture in ["profile.svg", "energy_partition.svg"] {
        let drawn = bench.read(&format!("shot.muckpile/{picture}"));
        assert!(drawn.starts_with("<svg"), "{picture}");
    }
    let drawn = bench.read("shot.muckpile/energy_partition.svg");
    assert!(drawn.contains(">work of the gas<") && drawn.contains(">kinetic<"), "{drawn}");
    let again = bench.run(&["muckpile", "shot.run", "--json", "--out", "json"]).expect(0);
    let value: serde_json::Value = serde_json::from_str(again.out.trim()).expect("JSON");
    assert_eq!(value["energy"]["from"][0]["name"], "work of the gas");
    for (words, told) in [
        (&["--moved", "1 kg"][..], "is not like"),
        (&["--along", "east"], "write X,Y"),
        (&["--cell", "0 m"], "above zero"),
        (&["--rock-factor=-7"], "above zero"),
    ] {
        let all = [&["muckpile", "shot.run", "--force"], words].concat();
        bench.run(&all).expect(2).warns(&[told]);
    }
    bench.run(&["muckpile", "shot.toml"]).expect(2).warns(&["holds no run"]);
    bench.file("fall.toml", FALL);
    bench.run(&["run", "fall.toml"]).expect(0);
    bench.run(&["muckpile", "fall.run"]).expect(2).warns(&["[space.spatial]"]);
}
