//! Samples that the tests of several crates use, and an allocator that counts.

// Tests may compare with the functions of the platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

mod counting;

pub use counting::Counting;

use riprap_core::frame::{BRICK, Column, Frame, Solids};

/// Two blocks and one contact, for tests of writers and plots.
#[must_use]
pub fn sample() -> Frame {
    Frame {
        step: 120,
        time: 0.125,
        phase: "slide".to_owned(),
        offsets: vec![0, 4, 7],
        points: vec![
            [0.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [2.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [2.0, 0.0, 0.0],
            [3.0, 0.0, 0.0],
            [2.0, 1.0, 0.0],
        ],
        solids: None,
        block_columns: vec![
            Column::vector("displacement", "m", [[0.1, 0.0], [0.3, -0.4]]),
            Column::scalar("rotation", "rad", vec![-0.01, 0.02]),
        ],
        contact_points: vec![[2.0, 0.5, 0.0]],
        contact_columns: vec![Column::vector("force", "N/m", [[1e5, -2e4]])],
        cracks: None,
        bolts: None,
        tetrahedra: None,
    }
}

/// A brick and a tetrahedron.
#[must_use]
pub fn solid_sample() -> Frame {
    let mut points: Vec<[f64; 3]> = BRICK.to_vec();
    points.extend([[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0]]);
    Frame {
        step: 7,
        time: 2e-3,
        phase: "blast".to_owned(),
        offsets: vec![0, 8, 12],
        points,
        solids: Some(Solids {
            faces: vec![0, 0, 4],
            ends: vec![0, 3, 6, 9, 12],
            corners: vec![0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2],
        }),
        block_columns: vec![
            Column::vector3("velocity", "m/s", [[1.0, 2.0, 3.0], [0.0, 0.0, -1.0]]),
            Column::scalar("level", "-", vec![0.0, 3.0]),
        ],
        contact_points: vec![[1.0, 0.25, 0.25]],
        contact_columns: vec![Column::vector3("force", "N", [[1.0, 0.0, 5.0]])],
        cracks: None,
        bolts: None,
        tetrahedra: None,
    }
}
