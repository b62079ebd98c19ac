//! What is between the blocks: places, forces and states of contacts, patches, facets and joints; cracks as surfaces.

use riprap_record::frame::SEEPAGE_FLOW;
use riprap_record::{Column, Part};
use serde_json::{Value, json};

use crate::answer::{described, extremes, flat3};
use crate::run::{Problem, Run, Touches};
use crate::shape;
use crate::wire::Wire;

/// States in the order of their numbers. `STATES` in `viewer/src/marks.ts` is the same list.
const STATES: usize = 8;
const SLIDING: u8 = 1;
const SOFTENED: u8 = 2;
const BROKEN: u8 = 3;
const IN_TENSION: u8 = 4;
const IN_SHEAR: u8 = 5;
const GAPING: u8 = 6;
const OPEN: u8 = 7;

/// State of each contact and the area (in the plane: length) that is in it, from the numbers that the engines write.
/// Open alone is what had nothing to break; of what broke, the mode counts before whether it is open.
fn states(columns: &[Column], contacts: usize) -> (Vec<u8>, Vec<f64>) {
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
                mode if mode > 1.5 => IN_SHEAR,
                mode if mode > 0.5 => IN_TENSION,
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

/// The answer `contacts`.
pub fn wire(touches: &Touches) -> Vec<u8> {
    let Touches { points, columns, ids } = touches;
    let places: Vec<f32> = points.iter().flat_map(|p| shape::single(*p)).collect();
    let places_of = Places::of(ids);
    let side = |name: &str| -> Vec<u32> {
        let column = columns.iter().find(|c| c.name == name && c.components == 1);
        column.map_or_else(Vec::new, |c| c.data.iter().map(|v| places_of.find(*v)).collect())
    };
    let (states, areas) = states(columns, points.len());
    let mut sums = [0.0; STATES];
    for (state, area) in states.iter().zip(&areas) {
        sums[usize::from(*state)] += area;
    }
    let has_area = columns.iter().any(|c| c.name == "area");
    let force = columns.iter().find(|c| c.components > 1 && c.name.contains("force"));
    let mut out = Wire::default()
        .f32("points", &places)
        .u8("states", &states)
        .u32("blockA", &side("block_a"))
        .u32("blockB", &side("block_b"));
    if let Some(force) = force {
        out = out.f32("forces", &flat3(force));
    }
    let flow = columns.iter().find(|c| c.name == SEEPAGE_FLOW);
    if let Some(flow) = flow {
        out = out.f32("flows", &flat3(flow));
    }
    let longest = |column: Option<&Column>| {
        column.and_then(|c| Some(extremes(&c.numbers(Part::Magnitude))?[1]))
    };
    out.finish(&json!({
        "fields": columns.iter().map(described).collect::<Vec<Value>>(),
        "forceUnit": force.map(|f| &f.unit),
        "longest": longest(force),
        "flowUnit": flow.map(|f| &f.unit),
        "fastest": longest(flow),
        "areas": sums,
        "areaUnit": if has_area { "m2" } else { "m" },
    }))
}

/// Places of blocks in a frame by their numbers.
pub(crate) struct Places(Vec<(u32, u32)>);

impl Places {
    pub(crate) fn of(ids: &[u32]) -> Self {
        let mut order: Vec<(u32, u32)> = ids.iter().zip(0..).map(|(id, at)| (*id, at)).collect();
        order.sort_unstable();
        Places(order)
    }

    /// `u32::MAX`: not in the frame.
    pub(crate) fn find(&self, id: f64) -> u32 {
        let found = self.0.binary_search_by_key(&(id as u32), |o| o.0);
        found.map_or(u32::MAX, |at| self.0[at].1)
    }
}

/// The answer `cracks`: triangles (fans of the outlines) less the origin, with the blocks and the mode of each.
///
/// # Errors
/// As [`Run::cracks`].
pub fn cracks(run: &Run, k: usize) -> Result<Vec<u8>, Problem> {
    let cracks = run.cracks(k)?;
    let places_of = Places::of(&cracks.ids);
    let column = |name: &str| cracks.columns.iter().find(|c| c.name == name && c.components == 1);
    let of = |name: &str, f: usize| column(name).and_then(|c| c.data.get(f)).copied();
    let (mut points, mut modes) = (Vec::new(), Vec::new());
    let (mut sides, mut start) = ([Vec::new(), Vec::new()], 0);
    for (f, end) in cracks.ends.iter().enumerate() {
        let range = start..*end as usize;
        let outline = cracks.points.get(range).unwrap_or(&[]);
        start = *end as usize;
        for pair in outline.get(1..).unwrap_or(&[]).windows(2) {
            for p in [outline[0], pair[0], pair[1]] {
                points.extend(shape::single(p));
            }
            let sheared = of("mode", f).is_some_and(|m| m > 1.5);
            modes.push(if sheared { IN_SHEAR } else { IN_TENSION });
            for (side, name) in sides.iter_mut().zip(["block_a", "block_b"]) {
                side.push(of(name, f).map_or(u32::MAX, |id| places_of.find(id)));
            }
        }
    }
    Ok(Wire::default()
        .f32("points", &points)
        .u8("states", &modes)
        .u32("blockA", &sides[0])
        .u32("blockB", &sides[1])
        .finish(&json!({})))
}

/// The answer `bolts`: both ends of each bar less the origin, its axial force and state, and the blocks that its ends are in.
///
/// # Errors
/// As [`Run::bolts`]; bars that have not two ends.
pub fn bolts(run: &Run, k: usize) -> Result<Vec<u8>, Problem> {
    let bolts = run.bolts(k)?;
    let places_of = Places::of(&bolts.ids);
    let count = bolts.ends.len();
    let column = |name: &str| {
        let found = bolts.columns.iter().find(|c| c.name == name && c.components == 1);
        found.map_or_else(|| vec![f64::NAN; count], |c| c.data.clone())
    };
    if bolts.points.len() != 2 * count {
        return Err(Problem::broken(
            format!("frame {k} has bolt bars without two ends"),
            "Run the scene again, or copy the run folder again.",
        ));
    }
    let points: Vec<f32> = bolts.points.iter().flat_map(|p| shape::single(*p)).collect();
    let forces = column("axial_force");
    let side = |name: &str| -> Vec<u32> {
        column(name).into_iter().map(|id| places_of.find(id)).collect()
    };
    let states: Vec<u8> = column("state").into_iter().map(|s| s as u8).collect();
    let end = |least: fn(f64, f64) -> f64| forces.iter().copied().reduce(least);
    let (largest, smallest) = (end(f64::max), end(f64::min));
    let single: Vec<f32> = forces.iter().map(|f| *f as f32).collect();
    Ok(Wire::default()
        .f32("points", &points)
        .f32("forces", &single)
        .u8("states", &states)
        .u32("blockA", &side("block_a"))
        .u32("blockB", &side("block_b"))
        .finish(&json!({ "largest": largest, "smallest": smallest, "unit": "N" })))
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
        assert_eq!(states, [SLIDING, IN_TENSION, IN_SHEAR, OPEN, SOFTENED, BROKEN, GAPING]);
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
