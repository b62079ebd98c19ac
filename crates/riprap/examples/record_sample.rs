//! Writes a run folder of made-up numbers: `cargo run -p riprap --example record_sample -- FOLDER [PLOTS]`.
//!
//! A row of blocks topples along a circle, with a triangle and an L-shaped block beside it. The checks of the
//! VTK files (`tests/python/check_vtk.py`) and of the plots use it, since it needs no engine. `expected.json`
//! holds what a reader of the frames must find. With a second folder, plots of each kind are drawn into it.

#![allow(clippy::disallowed_methods, reason = "no result of a model: inputs of a timing")]

use riprap::exec::Exec;
use riprap::plot::{self, BlockOptions, Labels, Line, Which};
use riprap::record::table::Table;
use riprap::record::{Column, Ended, Existing, Frame, Manifest, RunFolder};
use std::error::Error;
use std::path::Path;

fn outline(kind: usize, centre: [f64; 2], angle: f64) -> Vec<[f64; 2]> {
    let local: &[[f64; 2]] = match kind % 3 {
        0 => &[[-0.2, -0.5], [0.2, -0.5], [0.2, 0.5], [-0.2, 0.5]],
        1 => &[[-0.25, -0.5], [0.25, -0.5], [0.0, 0.4]],
        _ => &[[-0.2, -0.5], [0.3, -0.5], [0.3, -0.2], [0.0, -0.2], [0.0, 0.5], [-0.2, 0.5]],
    };
    let (sin, cos) = angle.sin_cos();
    local
        .iter()
        .map(|p| [centre[0] + cos * p[0] - sin * p[1], centre[1] + sin * p[0] + cos * p[1]])
        .collect()
}

fn area(outline: &[[f64; 3]]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>() / 2.0
}

fn frame(step: u64, time: f64, blocks: usize) -> Frame {
    let mut frame = Frame { step, time, phase: "topple & slide".to_owned(), ..Frame::default() };
    frame.offsets.push(0);
    let (mut moves, mut speeds, mut turns) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..blocks {
        let share = i as f64 / blocks as f64;
        let angle = -time * time * (0.2 + share);
        let moved = [0.8 * time * time * share, -0.1 * time * time * (1.0 - share)];
        let centre = [0.7 * i as f64 + moved[0], 0.5 + moved[1]];
        frame.points.extend(outline(i, centre, angle).iter().map(|p| [p[0], p[1], 0.0]));
        frame.offsets.push(u32::try_from(frame.points.len()).unwrap_or(u32::MAX));
        moves.push(moved);
        speeds.push([2.0 * moved[0], 2.0 * moved[1]]);
        turns.push(angle);
        if i > 0 && i % 4 != 0 {
            frame.contact_points.push([centre[0] - 0.35, 0.3, 0.0]);
        }
    }
    let force: Vec<[f64; 2]> =
        frame.contact_points.iter().map(|p| [1e4 * (1.0 + p[0]), -2e3 * time]).collect();
    frame.block_columns = vec![
        Column::vector("displacement", "m", moves),
        Column::vector("velocity", "m/s", speeds),
        Column::scalar("rotation", "rad", turns),
    ];
    frame.contact_columns = vec![Column::vector("force", "N/m", force)];
    frame
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: record_sample FOLDER [PLOTS]")?;
    let mut manifest =
        Manifest { title: "made-up numbers".to_owned(), dt: 1e-3, ..Manifest::default() };
    let mut run = RunFolder::create(Path::new(&folder), Existing::ReplaceRun, &manifest)?;
    run.write_scenario("riprap = 1\ntitle = \"made-up numbers\"\n")?;
    run.begin_histories(&[("slip", "m"), ("crest.velocity", "m/s"), ("unbalanced", "-")])?;
    run.begin_energy(&[
        ("kinetic", "J/m"),
        ("gravity", "J/m"),
        ("friction", "J/m"),
        ("residual", "J/m"),
        ("residual_relative", "-"),
    ])?;
    let mut expected = Vec::new();
    for step in 0..=1500u64 {
        let t = step as f64 * 1e-3;
        let slow = (step % 10 == 0).then(|| 0.5 * (-6.0 * t).exp() + 1e-6);
        run.history_row(
            step,
            t,
            &[Some(2.36 * t * t), Some(4.72 * t + 0.3 * (40.0 * t).sin()), slow],
        )?;
        if step % 5 == 0 {
            let (kinetic, friction) = (11.1e3 * t * t, 4.1e3 * t * t);
            let gravity = -(kinetic + friction) + 0.02 * (30.0 * t).sin();
            let residual = kinetic + friction + gravity;
            run.energy_row(step, t, &[kinetic, gravity, friction, residual, residual / 15.2e3])?;
        }
        if step % 500 == 0 {
            let f = frame(step, t, 13);
            run.frame(&f, &Exec::serial())?;
            let areas: Vec<f64> = (0..f.blocks()).map(|i| area(f.outline(i))).collect();
            let largest =
                |c: &Column| c.numbers(riprap::record::Part::Whole).into_iter().fold(0.0, f64::max);
            expected.push(serde_json::json!({
                "time": f.time, "cells": f.blocks(), "contacts": f.contact_points.len(), "areas": areas,
                "displacement_max": largest(&f.block_columns[0]),
                "force_max": largest(&f.contact_columns[0]),
            }));
        }
    }
    run.event(
        &serde_json::json!({"step": 700, "time": 0.7, "event": "bond_broken", "pair": ["a", "b"]}),
    )?;
    run.checkpoint("sample", 1500, &run.marks(1500))?;
    run.write_file("expected.json", serde_json::to_string_pretty(&expected)?.as_bytes())?;
    (manifest.ended, manifest.steps, manifest.time) = (Ended::Finished, 1500, 1.5);
    run.write_manifest(&manifest)?;
    if let Some(plots) = std::env::args().nth(2) {
        draw(Path::new(&folder), Path::new(&plots))?;
    }
    Ok(())
}

fn draw(folder: &Path, plots: &Path) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(plots)?;
    let contacts = BlockOptions { contacts: true, ..BlockOptions::default() };
    let mut files = plot::histories(folder, &[], None, &plots.join("histories"))?;
    files.extend(plot::histories(folder, &["slip".to_owned()], None, &plots.join("slip"))?);
    files.extend(plot::energy(folder, &plots.join("energy"))?);
    files.extend(plot::blocks(folder, Which::Last, "velocity", contacts, &plots.join("blocks"))?);
    let all: Vec<Which> = (1..=4).map(Which::Index).collect();
    files.extend(plot::strip(folder, &all, "block.rotation", contacts, &plots.join("strip"))?);
    let table = Table::read(&folder.join("histories.csv"))?;
    let time = table.column("time")?.values.clone();
    let exact = time.iter().map(|t| 0.5 * 4.7 * t * t).collect();
    let reference = Line { name: "formula".to_owned(), x: time.clone(), y: exact };
    let computed =
        Line { name: "computed".to_owned(), x: time, y: table.column("slip")?.values.clone() };
    let word = |name: &str, unit: &str| (name.to_owned(), unit.to_owned());
    let labels = Labels { title: "slip".to_owned(), x: word("time", "s"), y: word("slip", "m") };
    files.extend(plot::compare(&computed, &reference, &labels, &plots.join("compare"))?);
    for file in files {
        println!("{}", file.display());
    }
    Ok(())
}
