//! Sizes of the blocks of a model before it runs: the curve of block sizes of a rock mass.

use serde::Serialize;

use super::engine::View;
use crate::plot::fits::Passing;
use crate::plot::{fits_of_sizes, passing};

/// Sizes of blocks: the edge of the cube of the volume, in the plane the side of the square of the area.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sizes {
    /// Whether areas (m2) are meant, not volumes (m3).
    pub planar: bool,
    /// Number of blocks, terrain left out.
    pub blocks: usize,
    /// Volume of all, m3, in the plane area, m2.
    pub total: f64,
    /// Smallest block, m.
    pub smallest: f64,
    /// Size below which a fifth of the volume is, m.
    pub x20: f64,
    /// Half of the volume, m.
    pub x50: f64,
    /// Four fifths, m.
    pub x80: f64,
    /// Largest block, m.
    pub largest: f64,
    /// Blocks that are held and left out.
    pub held: usize,
    /// Exponent of Rosin and Rammler; `None` with fewer than four different sizes.
    pub n: Option<f64>,
    /// Each size, m, and the share of the volume in blocks up to it.
    #[serde(serialize_with = "pairs")]
    pub curve: Passing,
}

fn pairs<S: serde::Serializer>(curve: &Passing, to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(curve.size.iter().zip(&curve.passing))
}

/// Sizes of the blocks that are there and free, of all where all are held, or of those of a group, a block or a condition of both.
///
/// # Errors
/// In words: an unknown name, a condition that is none, no block.
pub fn sizes(view: &View<'_>, of: Option<&str>) -> Result<Sizes, String> {
    let names = view.names();
    let chosen = of.map(|of| names.chosen(of)).transpose()?;
    let rock: Vec<usize> = match view {
        View::Planar(v) => v.living().collect(),
        View::Spatial(v) => v.living().filter(|b| !v.world.is_terrain(*b)).collect(),
    };
    let is_held = |b: usize| match view {
        View::Planar(v) => v.world.motion[b].is_some(),
        View::Spatial(v) => v.world.motion[b].is_some(),
    };
    // What is held is the ground, where nobody asks for it.
    let held = rock.iter().filter(|b| of.is_none() && is_held(**b)).count() % rock.len().max(1);
    let wanted = |b: &usize| match &chosen {
        Some(chosen) => chosen.has(*b as u32),
        None => held == 0 || !is_held(*b),
    };
    let those = rock.iter().copied().filter(wanted);
    let (planar, amounts): (bool, Vec<f64>) = match view {
        View::Planar(v) => {
            let area = |b: usize| v.scratch.shapes.mass[b] / v.world.setup.blocks[b].density;
            (true, those.map(area).collect())
        }
        View::Spatial(v) => (false, those.map(|b| v.world.solid_of(b).volume).collect()),
    };
    let curve = passing(&amounts, planar);
    let Some((smallest, largest)) = curve.size.first().copied().zip(curve.size.last().copied())
    else {
        let of = of.map_or(String::new(), |of| format!(" of `{of}`"));
        return Err(format!("there is no block{of} with a size"));
    };
    Ok(Sizes {
        planar,
        blocks: amounts.len(),
        held,
        total: amounts.iter().sum(),
        smallest,
        x20: curve.quantile(0.2),
        x50: curve.quantile(0.5),
        x80: curve.quantile(0.8),
        largest,
        n: fits_of_sizes(&curve).map(|(fit, _)| fit.n),
        curve,
    })
}

impl Sizes {
    /// The unit of the amounts.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        if self.planar { "m2" } else { "m3" }
    }

    /// A line that says how many blocks there are.
    #[must_use]
    pub fn head(&self) -> String {
        let count = crate::numbers::counted(self.blocks, "block");
        format!("{count}, {:.4} {}", self.total, self.unit())
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::exec::Exec;
    use crate::run::engine::Engine;
    use crate::run::scene::Scene;
    use crate::scenario::Source;

    fn found(space: &str, blocks: &str, of: Option<&str>) -> Result<Sizes, String> {
        let text = format!(
            "riprap = 1\ntitle = \"sizes\"\n[space.{space}\n[materials.rock]\ndensity = \"2500 kg/m3\"\n\
            [interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\n\
            {blocks}[[phases]]\nname = \"go\"\nuntil.steps = 1\n"
        );
        let scene = Scene::parse(Source::new("scene", text), PathBuf::from("."), &[]);
        let scene = scene.unwrap_or_else(|e| panic!("{e}"));
        let job = scene.prepare(&scene.plain()).unwrap_or_else(|e| panic!("{e}")).job();
        let engine = Engine::new(job.setup, Exec::serial()).unwrap_or_else(|e| panic!("{e}"));
        sizes(&engine.view(), of)
    }

    #[test]
    fn sizes_are_those_of_cubes_and_squares_of_the_same_volume() {
        // 48 cubes of 1 m and four of 2 m: 48 of 80 m3 pass 1 m.
        let cubes = "[[blocks]]\nname = \"small\"\nmaterial = \"rock\"\ngrid.box = { size = [\"4 m\", \"4 m\", \"3 m\"], cell = \"1 m\" }\n\
            [[blocks]]\nname = \"large\"\nmaterial = \"rock\"\ngrid.box = { size = [\"4 m\", \"4 m\", \"2 m\"], cell = \"2 m\", corner = [\"0 m\", \"0 m\", \"3 m\"] }\n";
        let space = "spatial]\ngravity = \"0 m/s2\"";
        let all = found(space, cubes, None).unwrap();
        assert_eq!((all.blocks, all.planar), (52, false));
        assert!((all.total - 80.0).abs() < 1e-9);
        assert!((all.curve.at(1.0 + 1e-9) - 0.6).abs() < 1e-6, "{:?}", all.curve);
        assert!((all.smallest - 1.0).abs() < 1e-12 && (all.largest - 2.0).abs() < 1e-12);
        let some = found(space, cubes, Some("large and not large.1")).unwrap();
        assert_eq!((some.blocks, some.smallest.round()), (3, 2.0));
        assert!(found(space, cubes, Some("larg")).unwrap_err().contains("unknown block or group"));
        let none = found(space, cubes, Some("large and small")).unwrap_err();
        assert_eq!(none, "there is no block of `large and small` with a size");
        let wall = "[[blocks]]\nname = \"wall\"\nmaterial = \"rock\"\nwall = { corner = [\"0 m\", \"0 m\"], block = [\"4 m\", \"1 m\"], courses = 2, per_course = 3, bond = \"stack\" }\n";
        let flat = found("planar]\ngravity = [\"0 m/s2\", \"0 m/s2\"]", wall, None).unwrap();
        assert_eq!((flat.blocks, flat.planar, flat.unit()), (6, true, "m2"));
        assert!((flat.x50 - 2.0).abs() < 1e-9 && (flat.total - 24.0).abs() < 1e-9);
    }
}
