//! Readers of files and of what stands in scenes.

use std::path::Path;

use riprap::dynamics::Formula;
use riprap::record::checkpoint;
use riprap::record::table::Table;
use riprap::record::vtu;
use riprap::run::recorder::KIND;
use riprap::run::simulation::{Simulation, Snapshot};
use riprap::scenario::foreign::{asc, at2, dfn, dfnworks, dxf, itasca, obj, stl, tess};
use riprap::scenario::{csv_columns, msh, units};

fn as_text(bytes: &[u8]) -> Option<&str> {
    std::str::from_utf8(bytes).ok()
}

pub fn formula(bytes: &[u8]) -> bool {
    let known = ["t", "x", "y", "z"];
    let Some(formula) = as_text(bytes).and_then(|text| Formula::new(text, &known).ok()) else {
        return false;
    };
    for value in [0.0, -1.5, 1e300, f64::NAN] {
        let value = formula.value(&known.map(|name| (name, value)));
        std::hint::black_box(value);
    }
    true
}

pub fn quantity(bytes: &[u8]) -> bool {
    let read = as_text(bytes).and_then(|text| units::parse(text).ok());
    if let Some((value, _)) = read {
        assert!(value.is_finite(), "a quantity is {value}");
    }
    read.is_some()
}

pub fn columns(bytes: &[u8]) -> bool {
    let columns = [["x"], ["y"], ["z"]];
    let columns =
        columns.each_ref().map(|name| csv_columns::Column::chosen(name, units::Dim::LENGTH, "m"));
    csv_columns::parse_table(bytes, &columns).is_ok()
}

pub fn table(bytes: &[u8]) -> bool {
    Table::parse(bytes, Path::new("table.csv")).is_ok()
}

pub fn dxf(bytes: &[u8]) -> bool {
    let [exact, coarse] = [None, Some(0.01)].map(|sagitta| {
        let drawing = dxf::parse_dxf(bytes, sagitta);
        drawing.map(|drawing| drawing.outlines()).is_ok()
    });
    exact || coarse
}

pub fn tess(bytes: &[u8]) -> bool {
    tess::parse_tess(bytes).is_ok()
}

pub fn asc(bytes: &[u8]) -> bool {
    asc::parse_asc(bytes).is_ok()
}

pub fn stl(bytes: &[u8]) -> bool {
    // Both in any case: what one refuses the other may fail on.
    let (solids, surface) = (stl::parse_stl(bytes).is_ok(), stl::parse_surface(bytes).is_ok());
    solids || surface
}

/// Networks of fractures, records and solids as text: each reader in any case, as what one refuses another may fail on.
pub fn network(bytes: &[u8]) -> bool {
    let read = [
        dfn::parse_fab(bytes).is_ok(),
        dfn::parse_polygons(bytes).is_ok(),
        itasca::parse_itasca(bytes).is_ok(),
        dfnworks::parse_rows(bytes).is_ok_and(|rows| !rows.is_empty()),
        dfnworks::parse_families(bytes).is_ok_and(|families| !families.is_empty()),
        at2::parse_at2(bytes).is_ok(),
        obj::parse_obj(bytes).is_ok_and(|obj| obj.solids().is_ok()),
    ];
    read.contains(&true)
}

pub fn msh(bytes: &[u8]) -> bool {
    msh::parse_msh(bytes).is_ok()
}

pub fn vtu(bytes: &[u8]) -> bool {
    vtu::parse(bytes, Path::new("frame.vtu")).is_ok()
}

/// A checkpoint of this program's format: of a model of two blocks.
pub fn sound_checkpoint() -> Vec<Vec<u8>> {
    let scene = include_str!("../corpus/scene/plane.toml");
    let simulation = Simulation::from_toml(scene).expect("the corpus holds scenes that are built");
    vec![checkpoint::encode(KIND, &simulation.snapshot()).expect("memory takes what is written")]
}

/// Every damaged checkpoint must be refused, its checksum says so; what has been taken is a sound one.
pub fn checkpoint(bytes: &[u8]) -> bool {
    checkpoint::decode::<Snapshot>(bytes, KIND, Path::new("a.rck")).is_ok()
}
