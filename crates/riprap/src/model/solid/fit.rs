//! Cells that fit a charge: the finest bricks that touch it have its volume together.
//!
//! The charge stays where it is, on a corner of the cells. Where the charge lies below the top of the
//! grid, its depth is kept exactly: the height of the cells is a whole part of it, and the other two
//! edges take up the rest. The other sides of the box move to the nearest whole cell. All this is along the axes of the grid,
//! also where it is turned afterwards.

use riprap_geom::Vec3;

use super::graded::is_graded_at;
use super::grid::{Lattice, grid_of, said_corner, said_size};
use super::turn::Turn;
use super::{global, triple};
use crate::model::builder::Builder;
use crate::scenario::Diagnostic;
use crate::scenario::Name;
use crate::scenario::language::{Around, Block, Explosive, GasCavity, GridBox, Source};
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::words::WordOr;

/// Most levels that are tried.
const MOST_LEVELS: u8 = 12;
/// Nearer than this share of a cell to a side, a charge lies on it.
const ON_SIDE: f64 = 1e-6;
/// Relative change of an edge that is worth a word about the number of levels.
const MUCH: f64 = 1.3;

/// A charge that wants cells of its size.
struct Charge<'a> {
    name: &'a Name,
    centre: Vec3,
    volume: f64,
    levels: Option<u8>,
}

impl Builder<'_> {
    /// The explosive of a charge.
    pub(super) fn explosive<'b>(&'b self, gas: &'b GasCavity) -> Option<&'b Explosive> {
        match &gas.explosive {
            WordOr::Word(name, _) => self.parsed.scenario.explosives.get(name.as_str()),
            WordOr::Table(explosive, _) => Some(explosive),
        }
    }

    /// Levels by which blocks around a source are split before the first step; `None` if nothing is
    /// split there, `Some(None)` if the number is left open.
    fn levels_around(&self, source: &Name) -> Option<Option<u8>> {
        let refine = self.parsed.scenario.refine.iter();
        let here = refine.filter(|refine| {
            refine.during.is_none()
                && matches!(&refine.octree.around, Around::Source(name) if name == source)
        });
        let levels: Vec<Option<u8>> = here.map(|refine| refine.octree.levels).collect();
        levels.iter().copied().max()
    }

    /// For each `[[blocks]]` table the grid that fits a charge in it.
    pub(super) fn fit_charges(&mut self) -> Vec<Option<Lattice>> {
        let scenario = &self.parsed.scenario;
        let mut fitted: Vec<Option<(Lattice, &Name)>> = vec![None; scenario.blocks.len()];
        for (name, source) in scenario.sources.iter() {
            let Source::GasCavity(gas) = source else {
                continue;
            };
            let (Some(centre), true) = (&gas.centre, gas.is_fitted()) else {
                continue;
            };
            if scenario.blocks.iter().any(|block| is_graded_at(block, name)) {
                continue; // those cells make room for it
            }
            let (Some(mass), Some(explosive)) = (&gas.mass, self.explosive(gas)) else {
                continue; // reported by the rules of the language
            };
            let Some(density) = explosive.charge_density() else {
                continue; // likewise
            };
            let volume = mass.si() / density;
            let Some(levels) = self.levels_around(name) else {
                let message =
                    format!("no cells can be fitted to `{name}`: no cells are refined around it");
                let help = format!(
                    "add [[refine]] with octree = {{ around = \"{name}\", levels = 5 }}, or write \
                     coupling = {{ scaled = 0.667 }}"
                );
                self.error_at("source.fitted", name, message, &help);
                continue;
            };
            let at = global(centre);
            let holders: Vec<(usize, &GridBox)> = (0..scenario.blocks.len())
                .filter_map(|k| Some((k, holding(&scenario.blocks[k], at)?)))
                .collect();
            let [(holder, grid)] = holders[..] else {
                let error = Diagnostic::error(
                    "source.fitted",
                    format!(
                        "no cells can be fitted to `{name}`: it does not lie in exactly one grid"
                    ),
                );
                let span = crate::scenario::language::span_of(centre);
                let help = "move it into a grid, or write coupling = { scaled = 0.667 }";
                self.found.push(error.at(span).help(help));
                continue;
            };
            let block = &scenario.blocks[holder];
            let charge = Charge { name, centre: unturned(block, grid, at), volume, levels };
            if let Some((lattice, first)) = &fitted[holder] {
                self.second_charge(&charge, lattice, first);
            } else {
                fitted[holder] = Some((self.fit(block, grid, &charge), name));
            }
        }
        fitted.into_iter().map(|one| one.map(|(lattice, _)| lattice)).collect()
    }

    /// A second charge in one grid must want the same cells.
    fn second_charge(&mut self, charge: &Charge<'_>, lattice: &Lattice, first: &Name) {
        let levels = charge.levels.or_else(|| self.levels_around(first).flatten());
        let finest = |l: u8| lattice.cell.element_product() / cells_below(l);
        let fits = match levels {
            Some(levels) => (8.0 * finest(levels) / charge.volume - 1.0).abs() < 1e-6,
            // The levels of the first were found, those of this one are the same.
            None => false,
        };
        if !fits {
            let message =
                format!("`{}` and `{first}` require different cell sizes in one grid", charge.name);
            let help = "give one of them coupling = { scaled = 0.667 }";
            self.error_at("source.fitted", charge.name, message, help);
        }
    }

    fn fit(&mut self, block: &Block, grid: &GridBox, charge: &Charge<'_>) -> Lattice {
        let (corner, size) = (said_corner(block, grid), said_size(grid));
        let cell = Vec3::from(grid.cell.xyz());
        let below = charge.centre - corner;
        let above = corner + size - charge.centre;
        let on_side = |k: usize| below[k].min(above[k]) <= ON_SIDE * cell[k];
        let touching = (0..3).fold(1.0, |n, k| if on_side(k) { n } else { 2.0 * n });
        // Volume of a base cell whose finest parts fill the charge.
        let wanted = |levels: u8| charge.volume / touching * cells_below(levels);
        let change = |levels: u8| libm::cbrt(wanted(levels) / cell.element_product());
        let nearest = (1..=MOST_LEVELS)
            .min_by(|a, b| libm::log(change(*a)).abs().total_cmp(&libm::log(change(*b)).abs()))
            .unwrap_or(1);
        let levels = charge.levels.unwrap_or(nearest);
        self.fitted_levels.insert(charge.name.text.clone(), levels);
        let mut new = cell * change(levels);
        // The depth below the top is kept: it decides what the charge does.
        if above.z > ON_SIDE * cell.z {
            new.z = above.z / (above.z / new.z).round().max(1.0);
            let rest = wanted(levels) / new.element_product();
            new.x *= rest.sqrt();
            new.y *= rest.sqrt();
        }
        let cells = |length: f64, edge: f64| {
            if length <= ON_SIDE * edge { 0.0 } else { (length / edge).round().max(1.0) }
        };
        let low = [0, 1, 2].map(|k: usize| cells(below[k], new[k]));
        let high = [0, 1, 2].map(|k: usize| cells(above[k], new[k]));
        let mut lattice = Lattice {
            corner: charge.centre - Vec3::from(low) * new,
            cell: new,
            count: [0, 1, 2].map(|k: usize| (low[k] + high[k]).min(f64::from(u32::MAX)) as u32),
        };
        if let Some(turn) = turn_of(block, grid).filter(|_| turns_about_itself(block)) {
            // It will be turned about its own centre, which has moved: where the charge is, a corner must come to lie.
            let own = lattice.corner + 0.5 * lattice.size();
            lattice.corner += turn.of(own) - own;
        }
        self.tell(block, charge, (corner, size, cell), &lattice, (levels, nearest));
        lattice
    }

    /// Prints what became of the grid.
    fn tell(
        &mut self,
        block: &Block,
        charge: &Charge<'_>,
        (corner, size, cell): (Vec3, Vec3, Vec3),
        lattice: &Lattice,
        (levels, nearest): (u8, u8),
    ) {
        let name = charge.name;
        let key = format!("blocks.{}.grid.box", block.name);
        let why = format!(
            "the finest cells around `{name}` ({levels} levels) match its volume {}",
            with_unit(charge.volume, "m3")
        );
        for (word, value) in
            [("cell", lattice.cell), ("corner", lattice.corner), ("size", lattice.size())]
        {
            let text = triple(value, "m");
            self.explain(format!("{key}.{word}"), text, Provenance::Derived, &why);
        }
        let message = format!(
            "the grid of `{}` is fitted to charge `{name}`: cells {} instead of {}, box {} from {} instead of {} from {}",
            block.name,
            triple(lattice.cell, "m"),
            triple(cell, "m"),
            triple(lattice.size(), "m"),
            triple(lattice.corner, "m"),
            triple(size, "m"),
            triple(corner, "m"),
        );
        let change = libm::cbrt(lattice.cell.element_product() / cell.element_product());
        let help = if !(1.0 / MUCH..=MUCH).contains(&change) && nearest != levels {
            format!("levels = {nearest} would change the cells least")
        } else {
            "no action needed; coupling = { scaled = 0.667 } keeps the given grid".to_owned()
        };
        let note = Diagnostic::warning("grid.fitted", message).help(help);
        self.found.push(note.at(block.name.span.clone()));
        self.summary.fitted.push(format!(
            "{}: cells {} for charge {name}, {levels} levels",
            block.name,
            triple(lattice.cell, "m")
        ));
    }
}

/// Finest cells in a base cell.
fn cells_below(levels: u8) -> f64 {
    libm::exp2(3.0 * f64::from(levels))
}

/// The grid of a table if a point lies in it, as it is given and turned.
fn holding(block: &Block, point: Vec3) -> Option<&GridBox> {
    grid_of(block).filter(|grid| {
        let point = unturned(block, grid, point);
        let corner = said_corner(block, grid);
        let slack = ON_SIDE * Vec3::from(grid.cell.xyz());
        let (low, high) = (corner - slack, corner + said_size(grid) + slack);
        point.cmpge(low).all() && point.cmple(high).all()
    })
}

/// Where a point of the model lies in the grid of a table before it is turned.
fn unturned(block: &Block, grid: &GridBox, point: Vec3) -> Vec3 {
    turn_of(block, grid).map_or(point, |turn| turn.back(point))
}

/// How the grid of a table, as given, is turned.
fn turn_of(block: &Block, grid: &GridBox) -> Option<Turn> {
    let rotate = block.rotate.as_ref()?;
    let shift = block.shift.as_ref().map_or(Vec3::ZERO, |s| s.xyz().into());
    let about = rotate.about.as_ref().map(|at| Vec3::from(at.xyz()) + shift);
    let about = about.unwrap_or_else(|| said_corner(block, grid) + 0.5 * said_size(grid));
    Some(Turn::new(rotate, about))
}

/// Whether a table is turned about its own centroid.
fn turns_about_itself(block: &Block) -> bool {
    block.rotate.as_ref().is_some_and(|r| r.about.is_none())
}
