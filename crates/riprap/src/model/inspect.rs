//! Checks of the finished model: overlaps, slivers, whether anything can move.

use riprap_geom::Vec2;
use riprap_geom::clip::overlap_depth;
use riprap_geom::measure;
use riprap_geom::pairs::touching_boxes;
use riprap_geom::polygon::{self, Aabb};

use super::builder::Builder;
use super::summary::passing;
use crate::plan::PhaseKind;
use crate::planar::setup::Motion;
use crate::scenario::Diagnostic;
use crate::scenario::language::Space;
use crate::scenario::read::with_unit;

/// Overlap at the start that needs no reason, as a share of the smaller block.
const ACCEPTED: f64 = 1e-6;
/// Most overlap at the start that gravity or a static phase may excuse, as a share of the smaller
/// block.
const EXCUSED: f64 = 0.01;
/// Pairs and blocks named one by one.
const NAMED: usize = 10;
/// Overlapping pairs after which the search for more of them ends.
const MOST_BAD: usize = 1000;
/// Pairs of boxes for each block after which the search for overlaps ends.
const MOST_NEAR: usize = 300;
/// A block is a sliver below this share of the median width.
const SLIVER: f64 = 0.02;

pub(super) fn inspect(b: &mut Builder<'_>) {
    sizes(b);
    overlaps(b);
    slivers(b);
    motion(b);
}

fn sizes(b: &mut Builder<'_>) {
    let blocks = &b.setup.blocks;
    let areas = blocks.iter().map(|block| polygon::signed_area(&block.vertices));
    let mut size: Vec<f64> = areas.clone().map(f64::sqrt).collect();
    size.sort_by(f64::total_cmp);
    let all = blocks.iter().flat_map(|block| block.vertices.iter().copied());
    let bounds = Aabb::of(&all.collect::<Vec<Vec2>>());
    let mut shortest = (f64::INFINITY, String::new());
    for block in blocks {
        let lengths = polygon::edges(&block.vertices).map(|(p, q)| p.distance(q));
        let least = lengths.fold(f64::INFINITY, f64::min);
        if least < shortest.0 {
            shortest = (least, block.name.clone());
        }
    }
    let mut supported = vec![false; blocks.len()];
    for support in &b.setup.supports {
        support.blocks.iter().for_each(|&block| supported[block as usize] = true);
    }
    // What is held stands for the rock around.
    let held = supported.iter();
    let free = blocks.iter().zip(held).filter(|(_, held)| !**held);
    let mut free: Vec<f64> =
        free.map(|(block, _)| polygon::signed_area(&block.vertices).sqrt()).collect();
    free.sort_by(f64::total_cmp);
    let s = &mut b.summary;
    s.passing = passing(&free, 2);
    s.blocks = blocks.len();
    s.vertices = blocks.iter().map(|block| block.vertices.len()).sum();
    s.supported = supported.iter().filter(|&&held| held).count();
    s.materials = b.setup.materials.len();
    s.interfaces = b.setup.interfaces.len();
    s.phases = b.plan.phases.len();
    s.origin = b.setup.origin;
    s.bounds = [(bounds.min + b.origin).into(), (bounds.max + b.origin).into()];
    s.mass = blocks.iter().zip(areas).map(|(block, area)| block.density * area).sum();
    s.size = [size[0], size[size.len() / 2], size[size.len() - 1]];
    s.shortest_edge = shortest;
}

/// How deep a pair may overlap at the start, m.
///
/// Always `ACCEPTED`; more where the scene says so (`allow_overlap`), where the weight of the whole
/// model could press as deep (a model that starts in equilibrium), or where a static phase comes first
/// and pushes blocks apart slowly.
fn allowance(b: &Builder<'_>, i: usize, j: usize, size: f64) -> f64 {
    let said = match &b.parsed.scenario.space {
        Space::Planar(planar) => planar.allow_overlap.as_ref(),
        Space::Spatial(_) => None,
    };
    let said = said.map_or(0.0, crate::scenario::Quantity::si);
    let (a, c) = (&b.setup.blocks[i], &b.setup.blocks[j]);
    let row =
        b.setup.pair_table[a.material as usize * b.setup.materials.len() + c.material as usize];
    let stiffness = b.setup.interfaces[row as usize].contact.normal_stiffness;
    let extent = Vec2::from(b.summary.bounds[1]) - Vec2::from(b.summary.bounds[0]);
    let density = b.setup.blocks.iter().map(|block| block.density).fold(0.0, f64::max);
    let gravity = Vec2::from(b.setup.gravity).abs();
    let pressed = 2.0 * density * gravity.dot(extent) / stiffness;
    let settles = b.plan.phases.first().is_some_and(|p| p.kind == PhaseKind::Static);
    let excused = if settles { EXCUSED * size } else { pressed.min(EXCUSED * size) };
    excused.max(ACCEPTED * size).max(said)
}

fn overlaps(b: &mut Builder<'_>) {
    let boxes: Vec<Aabb> = b.setup.blocks.iter().map(|block| Aabb::of(&block.vertices)).collect();
    let Some(pairs) = touching_boxes(&boxes, MOST_NEAR * boxes.len() + 1_000_000) else {
        let message = "many blocks coincide at the start";
        let help = "check `copies.step`, and look for blocks that are given twice";
        let error = Diagnostic::error("geometry.overlap", message).at(entry_span(b, 0));
        b.found.push(error.help(help));
        return;
    };
    b.summary.near_pairs = pairs.len();
    let mut bad: Vec<(f64, usize, usize, Vec2)> = Vec::new();
    let mut deepest = (0.0, 0, 0);
    for (i, j) in pairs {
        let (i, j) = (i as usize, j as usize);
        let (p, q) = (&b.setup.blocks[i].vertices, &b.setup.blocks[j].vertices);
        let overlap = overlap_depth(p, q);
        if overlap.depth > deepest.0 {
            deepest = (overlap.depth, i, j);
        }
        let size = polygon::signed_area(p).min(polygon::signed_area(q)).sqrt();
        // Two blocks that never move against each other may overlap as they like.
        if overlap.depth > ACCEPTED * size
            && overlap.depth > allowance(b, i, j, size)
            && !(is_fixed(b, i) && is_fixed(b, j))
        {
            bad.push((overlap.depth, i, j, overlap.at));
            if bad.len() == MOST_BAD {
                break;
            }
        }
    }
    let name = |i: usize| b.setup.blocks[i].name.clone();
    if deepest.0 > 0.0 {
        b.summary.deepest_overlap = Some((deepest.0, [name(deepest.1), name(deepest.2)]));
    }
    bad.sort_by(|x, y| y.0.total_cmp(&x.0));
    for &(depth, i, j, at) in bad.iter().take(NAMED) {
        let at = at + b.origin;
        let message = format!(
            "blocks `{}` and `{}` overlap by {} at the start, near ({}, {})",
            name(i),
            name(j),
            with_unit(depth, "m"),
            with_unit(at.x, "m"),
            with_unit(at.y, "m")
        );
        let error = Diagnostic::error("geometry.overlap", message).at(entry_span(b, j)).help(
            "move one of them; or let a first phase with kind = \"static\" separate them (up to 1 % of the block size); or accept the overlap \
             with allow_overlap = \"...\" in [space.planar]",
        );
        b.found.push(error);
    }
    if bad.len() > NAMED {
        let more = bad.len() - NAMED;
        let least = if bad.len() == MOST_BAD { "at least " } else { "" };
        let message = format!("{least}{more} more pairs of blocks overlap at the start");
        b.found.push(Diagnostic::error("geometry.overlap", message));
    }
}

fn is_fixed(b: &Builder<'_>, block: usize) -> bool {
    b.setup.supports.iter().any(|support| match support.motion {
        Motion::Fixed { x, y, rotation } => {
            x && y && rotation && support.blocks.binary_search(&(block as u32)).is_ok()
        }
        Motion::Velocity { .. } | Motion::Acceleration { .. } => false,
    })
}

/// Place of the table that made a block.
fn entry_span(b: &Builder<'_>, block: usize) -> crate::scenario::Span {
    let name = b.setup.blocks[block].name.as_str();
    let exact = b.parsed.scenario.blocks.iter().find(|said| said.name.as_str() == name);
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let made = || b.parsed.scenario.blocks.iter().find(|said| said.name.as_str() == stem);
    exact.or_else(made).map_or(0..0, |said| said.name.span.clone())
}

fn slivers(b: &mut Builder<'_>) {
    let outlines: Vec<Vec<Vec2>> =
        b.setup.blocks.iter().map(|block| block.vertices.clone()).collect();
    let mut found = measure::slivers(&outlines, SLIVER);
    for report in &found {
        let name = &b.setup.blocks[report.block].name;
        if found.len() <= NAMED || report.block == found[0].block {
            let more = if found.len() > NAMED {
                format!(" (and {} more such blocks)", found.len() - 1)
            } else {
                String::new()
            };
            let message = format!(
                "block `{name}` is a sliver{more}: its shortest edge is {}, its smallest width {} % of the median width, {}",
                with_unit(report.edge, "m"),
                with_unit((report.ratio * 1e3).round() / 10.0, ""),
                b.at_text(report)
            );
            let help = "a narrow block reduces the time step of the whole model (a short edge of a \
                        wide block does not); generators merge slivers with smallest_edge";
            let note = Diagnostic::warning("geometry.sliver", message).help(help);
            b.found.push(note.at(entry_span(b, report.block)));
        }
    }
    for report in &mut found {
        report.at = (Vec2::from(report.at) + b.origin).into();
    }
    b.summary.slivers = found;
}

fn motion(b: &mut Builder<'_>) {
    let all_fixed = (0..b.setup.blocks.len()).all(|block| is_fixed(b, block));
    let released = b.plan.phases.iter().any(|p| !p.release.is_empty());
    if all_fixed && !released {
        let message = "all blocks are fixed; nothing can move";
        b.found.push(Diagnostic::warning("model.fixed", message).help("check [[supports]]"));
    }
}
