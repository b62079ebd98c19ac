//! States of contacts, from the numbers that the engines write.

use crate::Column;

/// Names of the states by their numbers. `STATES` in `viewer/src/marks.ts` is the same list.
pub const STATES: [&str; 8] = [
    "touching",
    "sliding",
    "softened",
    "broken",
    "broken in tension",
    "broken in shear",
    "broken and open",
    "open",
];
const SLIDING: u8 = 1;
const SOFTENED: u8 = 2;
const BROKEN: u8 = 3;
/// Number of that state.
pub const BROKEN_IN_TENSION: u8 = 4;
/// Number of that state.
pub const BROKEN_IN_SHEAR: u8 = 5;
const GAPING: u8 = 6;
const OPEN: u8 = 7;

/// State of each contact and the area (in the plane: length) that is in it, from the numbers that the engines write.
/// Open alone is what had nothing to break; of what broke, the mode counts before whether it is open.
#[must_use]
pub fn states(columns: &[Column], contacts: usize) -> (Vec<u8>, Vec<f64>) {
    let column = |name: &str| columns.iter().find(|c| c.name == name && c.components == 1);
    let any = |names: [&str; 2]| names.iter().find_map(|name| column(name));
    let (broken, mode) = (any(["broken_points", "broken"]), column("failure_mode"));
    let (softened, open) = (column("softened_points"), column("open_points"));
    let sliding = any(["sliding_points", "slipping"]);
    let failed_area = any(["failed_area", "broken_length"]);
    let (whole_area, softened_area) = (any(["area", "length"]), column("softened_area"));
    let of = |column: Option<&Column>, k: usize| column.map_or(0.0, |c| c.data[k]);
    let one = |k: usize| {
        if of(broken, k) > 0.0 {
            let state = match of(mode, k) {
                mode if mode > 1.5 => BROKEN_IN_SHEAR,
                mode if mode > 0.5 => BROKEN_IN_TENSION,
                _ if of(open, k) > 0.0 => GAPING,
                _ => BROKEN,
            };
            (state, of(failed_area, k))
        } else if of(open, k) > 0.0 {
            (OPEN, of(whole_area, k))
        } else if of(softened, k) > 0.0 {
            (SOFTENED, of(softened_area, k))
        } else if of(sliding, k) > 0.0 {
            (SLIDING, of(whole_area, k))
        } else {
            (0, of(whole_area, k))
        }
    };
    (0..contacts).map(one).unzip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_comes_before_open_and_softened_before_sliding() {
        let numbers = |name: &str, values: [f64; 7]| Column::scalar(name, "-", values.to_vec());
        let columns = [
            numbers("area", [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]),
            numbers("broken_points", [0.0, 3.0, 1.0, 0.0, 0.0, 4.0, 4.0]),
            numbers("open_points", [0.0, 3.0, 0.0, 1.0, 0.0, 0.0, 4.0]),
            numbers("sliding_points", [1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0]),
            numbers("failed_area", [0.0, 1.5, 0.5, 0.0, 0.0, 6.0, 7.0]),
            numbers("failure_mode", [0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 0.0]),
            numbers("softened_points", [0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0]),
            numbers("softened_area", [0.0, 0.0, 0.0, 0.0, 2.5, 0.0, 0.0]),
        ];
        let (states, areas) = states(&columns, 7);
        assert_eq!(
            states,
            [SLIDING, BROKEN_IN_TENSION, BROKEN_IN_SHEAR, OPEN, SOFTENED, BROKEN, GAPING]
        );
        assert_eq!(areas, [1.0, 1.5, 0.5, 4.0, 2.5, 6.0, 7.0]);
    }

    #[test]
    fn joints_of_the_plane_have_lengths() {
        let columns = [
            Column::scalar("length", "m", vec![2.0, 3.0]),
            Column::scalar("broken_points", "-", vec![1.0, 0.0]),
            Column::scalar("broken_length", "m", vec![0.5, 0.0]),
        ];
        assert_eq!(states(&columns, 2), (vec![BROKEN, 0], vec![0.5, 3.0]));
    }
}
