//! The pile and the crater, seen from above on a grid.

use serde::Serialize;

use super::Piece;
use crate::Vec3;
use crate::run::runout::ground::Ground;

/// Cells of the grid at most; it is made coarser where there would be more.
const MOST_CELLS: f64 = 1e6;

/// The pile of thrown rock.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pile {
    /// Cell of the grid, m.
    pub cell: f64,
    /// Area that it covers in the plan, m2.
    pub area: f64,
    /// Volume between its surface and the ground, m3.
    pub volume: f64,
    /// This volume over that of its blocks.
    pub swell: f64,
    /// Largest height over the ground, m.
    pub height: f64,
    /// Its profile along the throw.
    pub profile: Vec<Station>,
}

/// A place of the profile: means and the largest over its width across the throw, where the pile is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Station {
    /// Coordinate along the throw, m.
    pub at: f64,
    /// Mean height of the surface, m.
    pub surface: f64,
    /// Highest point, m.
    pub highest: f64,
    /// Mean height of the ground below, m.
    pub ground: f64,
    /// Width of the pile, m.
    pub width: f64,
}

/// Where the surface is lower than at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Crater {
    /// Cell of the grid, m.
    pub cell: f64,
    /// Area in the plan, m2.
    pub area: f64,
    /// Radius of the circle of this area, m.
    pub radius: f64,
    /// Largest depth below the surface of the start, m.
    pub depth: f64,
    /// m3.
    pub volume: f64,
}

/// A grid over the plan, with one axis along a direction.
struct Grid {
    axis: [f64; 2],
    low: [f64; 2],
    counts: [usize; 2],
    cell: f64,
}

impl Grid {
    /// Over these places; cells begin at the lowest.
    fn over(places: impl Iterator<Item = Vec3> + Clone, axis: [f64; 2], cell: f64) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in places {
            let [s, t] = seen(axis, p);
            low = [low[0].min(s), low[1].min(t)];
            high = [high[0].max(s), high[1].max(t)];
        }
        let size = [0, 1].map(|k| f64::max(high[k] - low[k], 0.0));
        let cells = (size[0] / cell + 1.0) * (size[1] / cell + 1.0);
        let cell = cell * f64::max(1.0, (cells / MOST_CELLS).sqrt());
        // A size that is a whole number of cells but for round-off has no sliver of a cell more.
        let counts = size.map(|size| f64::max((size / cell - 1e-6).ceil(), 1.0) as usize);
        Self { axis, low, counts, cell }
    }

    /// Middles of its cells with the number along the axis.
    fn cells(&self) -> impl Iterator<Item = (usize, [f64; 2])> + '_ {
        let [a, b] = self.axis;
        (0..self.counts[0]).flat_map(move |i| {
            (0..self.counts[1]).map(move |j| {
                let s = self.low[0] + (i as f64 + 0.5) * self.cell;
                let t = self.low[1] + (j as f64 + 0.5) * self.cell;
                (i, [s * a - t * b, s * b + t * a])
            })
        })
    }
}

/// Coordinates of a place along and across a direction.
fn seen([a, b]: [f64; 2], p: Vec3) -> [f64; 2] {
    [p.x * a + p.y * b, p.y * a - p.x * b]
}

/// Triangles of some pieces.
fn surface<'a>(pieces: impl Iterator<Item = &'a Piece>) -> Ground {
    let mut all = Vec::new();
    for piece in pieces {
        for face in &piece.faces {
            let corner = |k: usize| piece.points[face[k] as usize];
            all.extend((2..face.len()).map(|k| [corner(0), corner(k - 1), corner(k)]));
        }
    }
    Ground::new(all)
}

/// Height of a surface at a place of the plan, looked at from `high`.
fn top(of: &Ground, [x, y]: [f64; 2], high: f64) -> Option<f64> {
    of.below(Vec3::new(x, y, high)).map(|below| high - below)
}

fn heights(points: impl Iterator<Item = Vec3>) -> [f64; 2] {
    points.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| [low.min(p.z), high.max(p.z)])
}

/// The pile of the thrown pieces on the others.
pub(super) fn pile(pieces: &[Piece], along: [f64; 2], cell: f64) -> Pile {
    let thrown = || pieces.iter().filter(|piece| piece.thrown);
    let points = || thrown().flat_map(|piece| piece.points.iter().copied());
    let grid = Grid::over(points(), along, cell);
    let (rock, ground) = (surface(thrown()), surface(pieces.iter().filter(|p| !p.thrown)));
    let [low, high] = heights(points());
    let square = grid.cell * grid.cell;
    let solid: f64 = thrown().map(|piece| piece.volume).sum();
    let (mut covered, mut volume, mut height) = (0.0, 0.0, 0.0_f64);
    let mut stations = vec![[0.0, f64::NEG_INFINITY, 0.0, 0.0]; grid.counts[0]];
    for (i, at) in grid.cells() {
        let Some(surface) = top(&rock, at, high + 1.0) else { continue };
        // Nothing below: the lowest point of the pile is the ground.
        let base = top(&ground, at, surface).unwrap_or(low);
        covered += square;
        volume += square * (surface - base);
        height = height.max(surface - base);
        let station = &mut stations[i];
        station[0] += surface;
        station[1] = station[1].max(surface);
        station[2] += base;
        station[3] += 1.0;
    }
    let profile = stations.iter().enumerate().filter(|(_, s)| s[3] > 0.0);
    let profile = profile.map(|(i, [surface, highest, base, n])| Station {
        at: grid.low[0] + (i as f64 + 0.5) * grid.cell,
        surface: surface / n,
        highest: *highest,
        ground: base / n,
        width: n * grid.cell,
    });
    Pile {
        cell: grid.cell,
        area: covered,
        volume,
        swell: volume / solid,
        height,
        profile: profile.collect(),
    }
}

/// Where the surface of all rock is lower than that of the `start`.
pub(super) fn crater(start: &[[Vec3; 3]], pieces: &[Piece], cell: f64) -> Option<Crater> {
    let thrown = pieces.iter().filter(|piece| piece.thrown);
    let reach = |piece: &Piece| {
        let edge = libm::cbrt(piece.volume);
        [-1.0, 1.0].map(|side| piece.start + side * edge * Vec3::new(1.0, 1.0, 0.0))
    };
    let places: Vec<Vec3> = thrown.flat_map(reach).collect();
    if places.is_empty() {
        return None;
    }
    let grid = Grid::over(places.iter().copied(), [1.0, 0.0], cell);
    let [low, high] = heights(start.iter().flatten().copied());
    let [_, now_high] = heights(pieces.iter().flat_map(|piece| piece.points.iter().copied()));
    let (before, after) = (Ground::new(start.to_vec()), surface(pieces.iter()));
    let square = grid.cell * grid.cell;
    let (mut area, mut depth, mut volume) = (0.0, 0.0_f64, 0.0);
    for (_, at) in grid.cells() {
        let Some(was) = top(&before, at, high + 1.0) else { continue };
        let is = top(&after, at, now_high + 1.0).unwrap_or(low);
        if was - is > 0.5 * grid.cell {
            area += square;
            depth = depth.max(was - is);
            volume += square * (was - is);
        }
    }
    let radius = (area / std::f64::consts::PI).sqrt();
    (area > 0.0).then_some(Crater { cell: grid.cell, area, radius, depth, volume })
}
