//! Overlaps where features coincide.

mod common;

use common::{DISTANCE, Model, SOURCE, general, law, points, rectangle};

#[test]
fn a_vertex_within_a_straight_side_changes_nothing() {
    // The middle of the pressed edge lies exactly below the vertex in the middle of the top side.
    let top = rectangle(-0.5, -1e-3, 0.5, 1.0);
    let plain = rectangle(-2.0, -1.0, 2.0, 0.0);
    let split = points(&[(-2.0, -1.0), (2.0, -1.0), (2.0, 0.0), (0.0, 0.0), (-2.0, 0.0)]);
    let fast = Model::pair(&top, &plain, law(DISTANCE, 1e9)).wrench();
    for normal in [DISTANCE, SOURCE] {
        let whole = Model::pair(&top, &plain, general(law(normal, 1e9))).wrench();
        let parted = Model::pair(&top, &split, general(law(normal, 1e9))).wrench();
        assert!(
            (whole.force - parted.force).length() <= 1e-12 * whole.force.length(),
            "{normal:?}: {whole:?} {parted:?}"
        );
        if normal == DISTANCE {
            assert!((whole.force - fast.force).length() <= 1e-12 * fast.force.length());
        }
    }
}
