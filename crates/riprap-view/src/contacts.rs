//! What is between the blocks: places, forces and states of contacts, patches, facets and joints; cracks as surfaces.

use riprap_record::contacts::{BROKEN_IN_SHEAR, BROKEN_IN_TENSION, STATES, states};
use riprap_record::frame::SEEPAGE_FLOW;
use riprap_record::{Column, Part};
use serde_json::{Value, json};

use crate::answer::{described, extremes, flat3};
use crate::run::{Problem, Run, Touches};
use crate::shape;
use crate::wire::Wire;

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
    let mut sums = [0.0; STATES.len()];
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
            modes.push(if sheared { BROKEN_IN_SHEAR } else { BROKEN_IN_TENSION });
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
