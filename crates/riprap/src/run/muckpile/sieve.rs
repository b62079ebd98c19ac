//! Sizes of fragments by sieve, and the curve of Kuz-Ram.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde::Serialize;

use super::{MuckpileError, Pattern, Piece, Throw};
use crate::Vec3;
use crate::plot::fits::{Passing, rosin_rammler_fit};
use crate::record::manifest::Manifest;
use crate::record::table::Table;

/// Directions in which a fragment is measured at most.
const MOST_NORMALS: usize = 1500;
/// Sieves that the fit looks at.
const SIEVES: usize = 30;
/// Strength by weight of TNT relative to ANFO, %.
const TNT: f64 = 115.0;

/// Fragments with a thrown block. The size of a fragment is the smallest edge of the boxes about it that have a side on one of its faces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fragments {
    /// Their number.
    pub count: usize,
    /// Size that half of the volume passes, m.
    pub x50: f64,
    /// Size that four fifths pass, m.
    pub x80: f64,
    /// Largest, m.
    pub largest: f64,
    /// Uniformity n of Rosin-Rammler; `None` with fewer than four sizes.
    pub n: Option<f64>,
    /// Size and share of the volume that passes, for each size.
    pub curve: Vec<[f64; 2]>,
}

/// The curve of Kuz-Ram, `P = 1 - 2^(-(x/x50)^n)`.
///
/// Source: Cunningham (1983), 1st Int. Symp. on Rock Fragmentation by Blasting, 439-453:
/// `x50 = A K^-0.8 Q^(1/6) (115/S)^(19/30)` in cm, K in kg/m3, Q in kg, S the strength by weight relative to ANFO (100).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct KuzRam {
    /// Rock factor A.
    pub rock_factor: f64,
    /// K, kg/m3.
    pub powder_factor: f64,
    /// Q, kg.
    pub charge: f64,
    /// S, %.
    pub strength: f64,
    /// m.
    pub x50: f64,
    /// m; `None` without a uniformity.
    pub x80: Option<f64>,
    /// Uniformity n, as given.
    pub n: Option<f64>,
}

/// Smallest distance of two parallel planes about the points, one of them along a face.
fn smallest_edge(points: &[Vec3], normals: &[Vec3]) -> f64 {
    let every = normals.len().div_ceil(MOST_NORMALS).max(1);
    let width = |n: &Vec3| {
        let span = points.iter().map(|p| p.dot(*n));
        let [low, high] = span
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        high - low
    };
    normals.iter().step_by(every).map(width).fold(f64::INFINITY, f64::min)
}

/// Unit normals of the faces of a piece.
fn normals(piece: &Piece) -> impl Iterator<Item = Vec3> + '_ {
    piece.faces.iter().filter_map(|face| {
        let at = |k: usize| piece.points[face[k] as usize];
        let area: Vec3 = (2..face.len()).map(|k| (at(k - 1) - at(0)).cross(at(k) - at(0))).sum();
        (area.length() > 0.0).then(|| area / area.length())
    })
}

/// The fragment of each block, by their numbers; `None` without the table.
pub(super) fn members(folder: &Path) -> Result<Option<BTreeMap<u32, u32>>, MuckpileError> {
    let path = folder.join("fragment_blocks.csv");
    if !path.exists() {
        return Ok(None);
    }
    let table = Table::read(&path)?;
    let rows = table.column("block")?.values.iter().zip(&table.column("fragment")?.values);
    Ok(Some(rows.map(|(b, f)| (*b as u32, *f as u32)).collect()))
}

/// Pieces by their fragments.
fn by_fragment<'a>(of: &BTreeMap<u32, u32>, pieces: &'a [Piece]) -> BTreeMap<u32, Vec<&'a Piece>> {
    let mut members: BTreeMap<u32, Vec<&Piece>> = BTreeMap::new();
    for piece in pieces {
        if let Some(fragment) = of.get(&piece.number) {
            members.entry(*fragment).or_default().push(piece);
        }
    }
    members
}

/// Blocks of the largest fragment that was not thrown, and all that are held or joined to what is.
pub(super) fn largest_that_stays(of: &BTreeMap<u32, u32>, pieces: &[Piece]) -> BTreeSet<u32> {
    let all = by_fragment(of, pieces);
    let holds = |of: &[&Piece]| of.iter().any(|piece| piece.held);
    let size = |of: &[&Piece]| of.iter().map(|piece| piece.volume).sum::<f64>();
    let free = all.iter().filter(|(_, of)| !holds(of) && !of.iter().any(|piece| piece.thrown));
    let largest = free.max_by(|a, b| size(a.1).total_cmp(&size(b.1))).map(|(k, _)| *k);
    let stays = all.iter().filter(|(k, of)| holds(of) || Some(**k) == largest);
    stays.flat_map(|(_, of)| of.iter().map(|piece| piece.number)).collect()
}

/// Sizes of the fragments that have a thrown block; `None` without any.
pub(super) fn fragments(of: &BTreeMap<u32, u32>, pieces: &[Piece]) -> Option<Fragments> {
    let members = by_fragment(of, pieces);
    let thrown = members.values().filter(|of| of.iter().any(|piece| piece.thrown));
    let sizes: Vec<(f64, f64)> = thrown
        .map(|of| {
            let points: Vec<Vec3> = of.iter().flat_map(|p| p.points.iter().copied()).collect();
            let normals: Vec<Vec3> = of.iter().flat_map(|piece| normals(piece)).collect();
            (smallest_edge(&points, &normals), of.iter().map(|piece| piece.volume).sum())
        })
        .collect();
    let count = sizes.len();
    let curve = Passing::of(sizes.into_iter());
    let largest = curve.size.last().copied()?;
    let sieves = curve.sieves(SIEVES);
    let passing: Vec<f64> = sieves.iter().map(|x| curve.at(*x)).collect();
    let fit = (curve.size.len() >= 4).then(|| rosin_rammler_fit(&sieves, &passing).ok()).flatten();
    Some(Fragments {
        count,
        x50: curve.quantile(0.5),
        x80: curve.quantile(0.8),
        largest,
        n: fit.map(|fit| fit.n),
        curve: curve.size.iter().zip(&curve.passing).map(|(x, p)| [*x, *p]).collect(),
    })
}

/// Kuz-Ram for the pattern of a run.
pub(super) fn kuz_ram(
    pattern: &Pattern,
    manifest: &Manifest,
    throw: Option<&Throw>,
) -> Result<KuzRam, MuckpileError> {
    let charges: Vec<f64> = manifest.sources.iter().filter_map(|source| source.mass).collect();
    let all: f64 = charges.iter().sum();
    let charge = pattern.charge.unwrap_or(all / charges.len() as f64);
    let rock = throw.map_or(0.0, |throw| throw.volume);
    let powder_factor = pattern.powder_factor.unwrap_or(all / rock);
    let sound = |what, help, value: f64| {
        let above = value > 0.0 && value.is_finite();
        if above { Ok(()) } else { Err(MuckpileError::Number { what, help }) }
    };
    sound("the charge of a hole", ": the run has no charges; give it", charge)?;
    let help = ": the run has no charges, or has thrown nothing; give it";
    sound("the powder factor", help, powder_factor)?;
    let strength = libm::pow(TNT / pattern.strength, 19.0 / 30.0);
    let centimetres = pattern.rock_factor
        * libm::pow(powder_factor, -0.8)
        * libm::pow(charge, 1.0 / 6.0)
        * strength;
    let x50 = 0.01 * centimetres;
    Ok(KuzRam {
        rock_factor: pattern.rock_factor,
        powder_factor,
        charge,
        strength: pattern.strength,
        x50,
        // 1 - 2^-y is 0.8 where y = log2 5.
        x80: pattern.uniformity.map(|n| x50 * libm::pow(libm::log2(5.0), 1.0 / n)),
        n: pattern.uniformity,
    })
}
