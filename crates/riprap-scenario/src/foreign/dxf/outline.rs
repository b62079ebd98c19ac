//! Outlines of blocks among the lines of a drawing: closed ones, nearly closed ones, and chains of lines that close.
//!
//! Two ends meet where they are nearer than [`GAP`] times the smaller of their lines. A chain is closed only if each of its
//! ends meets just one other: where three lines meet, which outline is meant is not in the drawing.

use std::collections::BTreeMap;

use super::{Drawing, Polyline, Why, extent};

/// Ends meet that are nearer than this share of the size of the smaller line.
const GAP: f64 = 5e-3;
/// Corners nearer than this share of the size of their outline are one: what programs leave where they round.
const HEALED: f64 = 1e-7;
/// Pairs of ends that are looked at for each line; a drawing with more of them is joined by nobody.
const LOOKS: usize = 1_000;
/// Direction along which ends are sorted: one along which no walls are drawn.
const SORTED: [f64; 2] = [0.764_842_187_284_488, 0.644_217_687_237_691];

/// Outlines of a drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outlines {
    /// Closed lines in the order in which they begin in the drawing.
    pub closed: Vec<Polyline>,
    /// Entities in `closed`.
    pub used: usize,
    /// Lines whose own ends nearly met.
    pub over_gaps: usize,
    /// Largest distance of ends that were taken to meet, in units of the drawing.
    pub largest_gap: f64,
    /// Outlines that chains of lines make, and lines in them.
    pub joined: [usize; 2],
    /// Short edges that became points.
    pub healed: usize,
    /// How many lines of a kind are no outline, and why.
    pub left_out: BTreeMap<(String, Why), usize>,
    /// Smallest distance of the ends of an open polyline that is no outline, in units of the drawing.
    pub smallest_open: Option<f64>,
}

/// A line of a chain, and whether it runs against it.
type Link = (usize, bool);

impl Drawing {
    /// The outlines among the lines.
    #[must_use]
    pub fn outlines(&self) -> Outlines {
        let mut out = Outlines::default();
        let mut found: Vec<(usize, Polyline)> = Vec::new();
        let mut open: Vec<usize> = Vec::new();
        for (k, line) in self.lines.iter().enumerate() {
            let gap = gap_of(line);
            if line.closed {
                found.push((k, line.clone()));
            } else if line.points.len() > 3 && gap <= GAP * extent(&line.points) {
                let mut line = line.clone();
                line.points.pop();
                line.closed = true;
                out.over_gaps += 1;
                out.largest_gap = out.largest_gap.max(gap);
                found.push((k, line));
            } else {
                open.push(k);
            }
        }
        out.used = found.len();
        let (partners, many) = self.partners(&open);
        let mut taken = vec![false; open.len()];
        for chain in chains(&partners) {
            let lines: Vec<Link> = chain.iter().map(|(k, back)| (open[*k], *back)).collect();
            let Some((line, gap)) = self.closed_chain(&lines) else {
                continue;
            };
            chain.iter().for_each(|(k, _)| taken[*k] = true);
            out.used += chain.len();
            out.joined[0] += 1;
            out.joined[1] += chain.len();
            out.largest_gap = out.largest_gap.max(gap);
            found.push((lines[0].0, line));
        }
        let left = open.iter().zip(&taken).filter(|(_, taken)| !**taken);
        for (&k, _) in left {
            out.leave_out(&self.lines[k], many);
        }
        found.sort_by_key(|(k, _)| *k);
        for (_, mut line) in found {
            out.healed += heal(&mut line.points);
            out.closed.push(line);
        }
        out
    }

    /// The other end that each end of some lines meets, if it is just one: ends are numbered 2 k and 2 k + 1. And whether there
    /// were too many pairs to look at.
    fn partners(&self, open: &[usize]) -> (Vec<Option<usize>>, bool) {
        let end = |e: usize| {
            let points = &self.lines[open[e / 2]].points;
            if e.is_multiple_of(2) { points[0] } else { points[points.len() - 1] }
        };
        let reach: Vec<f64> = open.iter().map(|k| GAP * extent(&self.lines[*k].points)).collect();
        let along = |p: [f64; 2]| p[0] * SORTED[0] + p[1] * SORTED[1];
        let mut order: Vec<(f64, usize)> =
            (0..2 * open.len()).map(|e| (along(end(e)), e)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut met: Vec<(usize, usize)> = vec![(0, 0); 2 * open.len()];
        let mut looks = LOOKS * open.len().max(LOOKS);
        for (place, &(at, e)) in order.iter().enumerate() {
            for &(there, other) in &order[place + 1..] {
                // The reach of a pair is that of its smaller line.
                if there - at > reach[e / 2] {
                    break;
                }
                if looks == 0 {
                    return (vec![None; 2 * open.len()], true);
                }
                looks -= 1;
                let (a, b) = (end(e), end(other));
                let near =
                    libm::hypot(a[0] - b[0], a[1] - b[1]) <= reach[e / 2].min(reach[other / 2]);
                let [one, two] = [e, other].map(|e| &self.lines[open[e / 2]].layer);
                if near && one == two && e / 2 != other / 2 {
                    met[e] = (met[e].0 + 1, other);
                    met[other] = (met[other].0 + 1, e);
                }
            }
        }
        let single = |(count, other): &(usize, usize)| (*count == 1).then_some(*other);
        let both = |other: &usize| met[*other].0 == 1;
        (met.iter().map(|m| single(m).filter(both)).collect(), false)
    }

    /// The outline of a closed chain of lines, and the largest distance of ends in it; none without an inside.
    fn closed_chain(&self, chain: &[Link]) -> Option<(Polyline, f64)> {
        let first = &self.lines[chain.first()?.0];
        let mut points: Vec<[f64; 2]> = Vec::new();
        let mut gap: f64 = 0.0;
        for &(k, back) in chain {
            let mut own = self.lines[k].points.clone();
            if back {
                own.reverse();
            }
            if let (Some(last), Some(next)) = (points.last(), own.first()) {
                gap = gap.max(libm::hypot(last[0] - next[0], last[1] - next[1]));
            }
            // Where two ends meet stands one corner: that of the line before.
            points.extend(own.into_iter().skip(usize::from(!points.is_empty())));
        }
        let (last, start) = (points.pop()?, points.first()?);
        gap = gap.max(libm::hypot(last[0] - start[0], last[1] - start[1]));
        if points.len() < 3 {
            return None;
        }
        let line = Polyline { closed: true, points, ..first.clone() };
        Some((line, gap))
    }
}

impl Outlines {
    fn leave_out(&mut self, line: &Polyline, many: bool) {
        let why = if many {
            "open, and too many of their ends coincide to join them"
        } else {
            "open, and their ends do not meet those of exactly one other line"
        };
        *self.left_out.entry((line.kind.to_owned(), why)).or_default() += 1;
        if line.points.len() > 2 {
            let gap = gap_of(line);
            self.smallest_open = Some(self.smallest_open.map_or(gap, |least| least.min(gap)));
        }
    }
}

/// Closed chains: lines by their place, in the order of the first line of each.
fn chains(partners: &[Option<usize>]) -> Vec<Vec<Link>> {
    let mut seen = vec![false; partners.len() / 2];
    let mut chains = Vec::new();
    for start in 0..seen.len() {
        if seen[start] {
            continue;
        }
        let (mut chain, mut enter) = (Vec::new(), 2 * start);
        loop {
            let line = enter / 2;
            if std::mem::replace(&mut seen[line], true) {
                // Back at the beginning, and through the end at which it began: closed.
                if enter == 2 * start {
                    chains.push(chain);
                }
                break;
            }
            chain.push((line, enter % 2 == 1));
            match partners[enter ^ 1] {
                Some(next) => enter = next,
                None => break,
            }
        }
    }
    chains
}

/// Distance of the ends of a line.
fn gap_of(line: &Polyline) -> f64 {
    match (line.points.first(), line.points.last()) {
        (Some(a), Some(b)) => libm::hypot(a[0] - b[0], a[1] - b[1]),
        (_, _) => 0.0,
    }
}

/// Makes one corner of corners that round-off has parted; how many edges that were.
fn heal(points: &mut Vec<[f64; 2]>) -> usize {
    let near = HEALED * extent(points);
    let before = points.len();
    let apart = |a: &[f64; 2], b: &[f64; 2]| a == b || libm::hypot(a[0] - b[0], a[1] - b[1]) > near;
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(before);
    for p in points.iter() {
        if kept.last().is_none_or(|last| apart(last, p)) {
            kept.push(*p);
        }
    }
    while kept.len() > 3 && !apart(&kept[0], &kept[kept.len() - 1]) {
        kept.pop();
    }
    if kept.len() >= 3 {
        *points = kept;
    }
    before - points.len()
}
