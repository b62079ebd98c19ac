//! Overlaps where features coincide.

use crate::common::{DISTANCE, Model, SOURCE, general, law, points, rectangle};

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

#[test]
fn vertices_within_sides_change_nothing_wherever_the_ends_are() {
    // One and two corners of the upper block inside; vertices in both faces, in their overlap and beside it.
    for shift in [0.0, 0.4, 0.6, 1.0, 1.7, 2.2] {
        let (left, right) = (shift - 0.5, shift + 0.5);
        let top = rectangle(left, -1e-3, right, 1.0);
        let plain = rectangle(-2.0, -1.0, 2.0, 0.0);
        let whole = Model::pair(&top, &plain, general(law(SOURCE, 1e9))).wrench();
        let middle = (shift - 0.1, -1e-3);
        let split_top = points(&[(left, -1e-3), middle, (right, -1e-3), (right, 1.0), (left, 1.0)]);
        let corners = [(-2.0, -1.0), (2.0, -1.0), (2.0, 0.0)];
        let within = [(1.9, 0.0), (0.6, 0.0), (0.1, 0.0), (-0.2, 0.0)];
        let split = points(&[corners.as_slice(), &within, &[(-2.0, 0.0)]].concat());
        // The list of corners begins within the face.
        let turned = points(&[&within[2..], &[(-2.0, 0.0)], &corners, &within[..2]].concat());
        for (upper, lower) in
            [(&top, &split), (&split_top, &plain), (&split_top, &split), (&split_top, &turned)]
        {
            let parted = Model::pair(upper, lower, general(law(SOURCE, 1e9))).wrench();
            let off = (whole.force - parted.force).length();
            assert!(off <= 1e-9 * whole.force.length(), "{shift}: {whole:?} {parted:?}");
        }
    }
}
