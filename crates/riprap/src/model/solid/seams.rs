//! Several terrains that are one ground: tiles of one survey are joined, other gaps and ground that is there twice are reported.
//!
//! The heights of a raster stand at the centres of its cells, so that two tiles that abut leave a cell without ground between them. Tiles of one
//! grid are joined: each takes the first heights of its eastern and northern neighbours.

use std::collections::BTreeMap;

use riprap_geom::height_field::{Bins, HeightField};
use riprap_geom::{Vec2, Vec3};

use crate::model::builder::Builder;
use crate::scenario::Diagnostic;
use crate::scenario::read::with_unit;
use crate::spatial::setup::{Shape, Surface};

/// Lines of a grid are at one distance, and of two grids in line, within this share of it.
const LINED_UP: f64 = 1e-3;
/// Rims that are nearer to each other than this many typical edges of their triangles belong together.
const BESIDE: f64 = 1.5;
/// Rims nearer than this share of an edge touch.
const TOUCHING: f64 = 1e-3;
/// Surfaces one above the other by less than this share of an edge are the same ground.
const SAME: f64 = 0.05;

/// A terrain whose corners lie on a square grid.
struct Tile {
    block: u32,
    /// Lowest lines, m.
    low: Vec2,
    /// Distance of the lines, m.
    step: f64,
    counts: [i64; 2],
    /// By column and row.
    heights: BTreeMap<[i64; 2], f64>,
}

impl Tile {
    /// `None` where the corners lie on no square grid.
    fn of(block: u32, surface: &Surface) -> Option<Self> {
        let lines = |of: fn(&Vec3) -> f64| {
            let mut lines: Vec<f64> = surface.points.iter().map(of).collect();
            lines.sort_by(f64::total_cmp);
            lines.dedup();
            lines
        };
        let (x, y) = (lines(|p| p.x), lines(|p| p.y));
        let step = x.get(1)? - x[0];
        let even = |lines: &[f64]| {
            let mut steps = lines.windows(2).map(|two| two[1] - two[0]);
            steps.all(|s| (s - step).abs() <= LINED_UP * step)
        };
        if y.len() < 2 || !even(&x) || !even(&y) {
            return None;
        }
        let mut tile = Self {
            block,
            low: Vec2::new(x[0], y[0]),
            step,
            counts: [x.len() as i64, y.len() as i64],
            heights: BTreeMap::new(),
        };
        for p in &surface.points {
            let at = tile.number(p.truncate())?;
            tile.heights.insert(at, p.z);
        }
        Some(tile)
    }

    /// Column and row of a place; `None` off the lines.
    fn number(&self, at: Vec2) -> Option<[i64; 2]> {
        let lines = (at - self.low) / self.step;
        let nearest = lines.round();
        let off = (lines - nearest).abs().max_element();
        (off <= 10.0 * LINED_UP).then_some([nearest.x as i64, nearest.y as i64])
    }

    fn place(&self, [i, j]: [i64; 2]) -> Vec2 {
        self.low + self.step * Vec2::new(i as f64, j as f64)
    }

    fn height(&self, at: Vec2) -> Option<f64> {
        self.heights.get(&self.number(at)?).copied()
    }
}

impl Builder<'_> {
    /// Joins tiles of one grid, and says where terrains leave a gap or lie in each other.
    pub(super) fn join_terrain(&mut self) {
        let blocks = (0_u32..).zip(&self.spatial.blocks);
        let grounds: Vec<u32> =
            blocks.filter(|(_, b)| b.shape.is_terrain()).map(|(b, _)| b).collect();
        if grounds.len() < 2 {
            return;
        }
        let surface = |b: &u32| match &self.spatial.blocks[*b as usize].shape {
            Shape::Terrain(surface) => Some(surface),
            Shape::Brick { .. } | Shape::Polyhedron(_) | Shape::Glued(_) => None,
        };
        let tiles = grounds.iter().filter_map(|b| Tile::of(*b, surface(b)?));
        let tiles: Vec<Tile> = tiles.collect();
        for k in 0..tiles.len() {
            if let Some((field, others)) = joined(&tiles, k) {
                let b = tiles[k].block;
                let names: Vec<String> = others.iter().map(|o| self.directory.name(*o)).collect();
                self.summary.terrain.push(format!(
                    "{}: joined to {} across the cell between them; {} triangles in total",
                    self.directory.name(b),
                    names.join(", "),
                    field.triangles.len(),
                ));
                self.spatial.blocks[b as usize].shape = Shape::Terrain(Box::new(Surface {
                    points: field.points,
                    triangles: field.triangles,
                }));
            }
        }
        self.seams(&grounds);
    }

    fn seams(&mut self, grounds: &[u32]) {
        let grounds: Vec<Ground> = grounds
            .iter()
            .filter_map(|b| match &self.spatial.blocks[*b as usize].shape {
                Shape::Terrain(surface) => Some(Ground::new(*b, surface.field())),
                Shape::Brick { .. } | Shape::Polyhedron(_) | Shape::Glued(_) => None,
            })
            .collect();
        for (k, a) in grounds.iter().enumerate() {
            for b in &grounds[k + 1..] {
                let names = [a, b].map(|g| self.directory.name(g.block));
                let origin = self.spatial.origin;
                let near = |at: Vec2| {
                    let at = at + origin.truncate();
                    format!("near ({}, {}) m", at.x, at.y)
                };
                let [first, second] = &names;
                let note = if let Some(at) = a.twice(b).or_else(|| b.twice(a)) {
                    let message = format!(
                        "terrains `{first}` and `{second}` cover the same ground {}: a block there touches both, with twice the stiffness",
                        near(at)
                    );
                    Diagnostic::warning("terrain.seam", message)
                        .help("trim one of them to the rim of the other")
                } else if let Some((width, at)) = a.gap(b) {
                    let message = format!(
                        "terrains `{first}` and `{second}` leave a gap of {} between their rims {}: blocks fall into it",
                        with_unit(width, "m"),
                        near(at)
                    );
                    Diagnostic::warning("terrain.seam", message).help(
                        "merge them into one terrain, or give both the same corners along the seam (rasters with aligned cells of equal size are \
                         joined automatically)",
                    )
                } else {
                    continue;
                };
                self.found.push(note.at(self.table_span(a.block)));
            }
        }
    }
}

/// A tile with the first heights of its neighbours to the east and to the north, and the blocks of these; `None` where it has none.
fn joined(tiles: &[Tile], k: usize) -> Option<(HeightField, Vec<u32>)> {
    let tile = &tiles[k];
    let [columns, rows] = tile.counts;
    let others = || tiles.iter().enumerate().filter(|(other, _)| *other != k);
    let others = || {
        others()
            .map(|(_, other)| other)
            .filter(|other| (other.step - tile.step).abs() <= LINED_UP * tile.step)
    };
    let mut added: BTreeMap<[i64; 2], f64> = BTreeMap::new();
    let mut from = Vec::new();
    let east = (0..=rows).map(|j| ([columns, j], [columns - 1, j.min(rows - 1)]));
    let north = (0..columns).map(|i| ([i, rows], [i, rows - 1]));
    for (new, own) in east.chain(north) {
        // Ground that reaches up to the tile leaves no cell to fill.
        if others().any(|other| other.height(tile.place(own)).is_some()) {
            continue;
        }
        let there = others().find_map(|o| Some((o.block, o.height(tile.place(new))?)));
        if let Some((block, z)) = there {
            added.insert(new, z);
            from.push(block);
        }
    }
    from.sort_unstable();
    from.dedup();
    if from.is_empty() {
        return None;
    }
    let line = |count: i64, low: f64| -> Vec<f64> {
        (0..=count).map(|n| low + tile.step * n as f64).collect()
    };
    let (x, y) = (line(columns, tile.low.x), line(rows, tile.low.y));
    let height = |i: usize, j: usize| {
        let at = [i as i64, j as i64];
        tile.heights.get(&at).or_else(|| added.get(&at)).copied()
    };
    // What cannot be joined stays as it is, and its gap is reported.
    HeightField::grid(&x, &y, height).ok().map(|field| (field, from))
}

/// A terrain with its rim.
struct Ground {
    block: u32,
    bins: Bins,
    /// A typical edge, m.
    edge: f64,
    low: Vec2,
    high: Vec2,
    rim: Vec<[Vec2; 2]>,
    field: HeightField,
}

impl Ground {
    fn new(block: u32, field: HeightField) -> Self {
        let (low, high) = field.bounds();
        let extent = (high - low).truncate();
        let at = |k: u32| field.points[k as usize].truncate();
        Self {
            block,
            bins: Bins::new(&field),
            edge: (2.0 * extent.x * extent.y / field.triangles.len() as f64).sqrt(),
            low: low.truncate(),
            high: high.truncate(),
            rim: field.rim().iter().map(|(a, b)| [at(*a), at(*b)]).collect(),
            field,
        }
    }

    fn is_near(&self, at: Vec2, reach: f64) -> bool {
        (at - self.low).min_element() > -reach && (self.high - at).min_element() > -reach
    }

    /// Where this is ground that another terrain has as well.
    fn twice(&self, other: &Self) -> Option<Vec2> {
        let slack = SAME * self.edge.max(other.edge);
        let middles = (0..self.field.triangles.len()).map(|t| {
            let [a, b, c] = self.field.corners(t);
            (a + b + c) / 3.0
        });
        let mut near = middles.filter(|at| other.is_near(at.truncate(), 0.0));
        near.find(|at| {
            let height = other.field.height(&other.bins, at.x, at.y);
            height.is_some_and(|z| (z - at.z).abs() <= slack)
        })
        .map(Vec3::truncate)
    }

    /// Width and place of the widest gap between rims that belong together, m.
    fn gap(&self, other: &Self) -> Option<(f64, Vec2)> {
        let edge = self.edge.max(other.edge);
        let reach = BESIDE * edge;
        let near = |ground: &Self, at: Vec2| ground.is_near(at, reach);
        let own = self.rim.iter().map(|e| e[0]).filter(|at| near(other, *at));
        let rims: Vec<[Vec2; 2]> =
            other.rim.iter().filter(|[a, b]| near(self, *a) || near(self, *b)).copied().collect();
        let mut widest: Option<(f64, Vec2)> = None;
        for at in own {
            if other.field.height(&other.bins, at.x, at.y).is_some() {
                continue;
            }
            let ways = rims.iter().map(|e| foot(e, at) - at);
            let Some(way) = ways.min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))
            else {
                continue;
            };
            let width = way.length();
            let middle = at + 0.5 * way;
            let bridged = self.field.height(&self.bins, middle.x, middle.y).is_some();
            if width > TOUCHING * edge && width < reach && !bridged {
                widest = widest.filter(|w| w.0 >= width).or(Some((width, middle)));
            }
        }
        widest
    }
}

/// The place on an edge that is nearest to another.
fn foot([a, b]: &[Vec2; 2], at: Vec2) -> Vec2 {
    let along = *b - *a;
    let share = (at - *a).dot(along) / along.length_squared();
    *a + share.clamp(0.0, 1.0) * along
}
