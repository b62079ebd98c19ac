//! Stress at the start in the plane: which joints carry it, and the stress of the rock outside on the sides of the model.

use riprap_geom::{Vec2, Vec3, polygon};

use crate::accounts::Holder;
use crate::dynamics::TimeFunction;
use crate::model::builder::Builder;
use crate::model::solid::boundary_name;
use crate::planar::setup::{Load, LoadKind};
use crate::scenario::language::Side;
use crate::scenario::words::WordOr;

/// A face lies on a side of the model if it is nearer than this share of the model.
const ON_SIDE: f64 = 1e-9;

/// A side of the model in the plane.
#[derive(Clone, Copy)]
pub(super) struct Line {
    /// Axis of the outward normal.
    pub(super) axis: usize,
    /// Its sign.
    pub(super) sign: f64,
}

impl Line {
    /// Outward normal.
    fn normal(self) -> Vec2 {
        self.sign * [Vec2::X, Vec2::Y][self.axis]
    }
}

impl Builder<'_> {
    /// Joints carry the stress: every pair of materials needs them.
    pub(super) fn carriers(&mut self) {
        let Some(said) = &self.parsed.scenario.in_situ else {
            return;
        };
        let setup = &self.setup;
        let used: Vec<usize> = (0..setup.materials.len())
            .filter(|m| setup.blocks.iter().any(|b| usize::from(b.material) == *m))
            .collect();
        let row = |a: &usize, b: &usize| {
            let row = setup.pair_table[a * setup.materials.len() + b];
            setup.interfaces.get(usize::from(row))
        };
        let mut rows = used.iter().flat_map(|a| used.iter().filter_map(|b| row(a, b)));
        let Some(bare) = rows.find(|row| row.bond.is_none()) else {
            return;
        };
        let name = &bare.name;
        let message = format!("interfaces.{name} has no joints to carry the in-situ stress");
        let help = format!(
            "give it [interfaces.{name}.bond], with tension = \"0 Pa\" for jointed rock; or leave out [in_situ] and bring the model to equilibrium \
             in a first phase with kind = \"static\""
        );
        self.error_at("in_situ.joints", super::place(said), message, help);
    }

    /// Sides on which the stress acts from outside, with the number and the name of their boundary.
    pub(super) fn open_sides(&self) -> Vec<(Line, u16, String)> {
        let boundaries = self.parsed.scenario.boundaries.iter().enumerate();
        let words = boundaries.filter_map(|(number, said)| match &said.on.plane {
            Some(WordOr::Word(word, _)) if said.in_situ == Some(true) => {
                Some((line(*word)?, number as u16, boundary_name(said, number)))
            }
            Some(WordOr::Word(..) | WordOr::Table(..)) | None => None,
        });
        words.collect()
    }

    /// Puts the stress on the sides: faces keep what they carry, wherever their blocks go.
    pub(super) fn sides(&mut self) {
        let Some(in_situ) = self.setup.in_situ else {
            return;
        };
        let (min, max) = self.extent();
        let slack = ON_SIDE * (max - min).max_element();
        let mut loads = Vec::new();
        for (side, number, name) in self.open_sides() {
            let account = self.account(name, Holder::Boundary(number));
            let (axis, n) = (side.axis, side.normal());
            let end = if side.sign > 0.0 { max[axis] } else { min[axis] };
            let traction = |p: Vec2| {
                let t = in_situ.traction(p.y, Vec3::new(n.x, n.y, 0.0));
                Vec2::new(t.x, t.y)
            };
            for (number, block) in (0..).zip(&self.setup.blocks) {
                for (from, to) in polygon::edges(&block.vertices) {
                    if [from, to].iter().all(|p| (p[axis] - end).abs() <= slack) {
                        loads.push(Load {
                            blocks: vec![number],
                            kind: LoadKind::Edge {
                                from,
                                to,
                                traction: [traction(from), traction(to)],
                                pressure: [0.0; 2],
                            },
                            time: TimeFunction::Constant(1.0),
                            account,
                        });
                    }
                }
            }
        }
        self.setup.loads.extend(loads);
    }
}

/// The side of a word; none for those of space.
fn line(word: Side) -> Option<Line> {
    let (axis, sign) = match word {
        Side::XMin => (0, -1.0),
        Side::XMax => (0, 1.0),
        Side::YMin => (1, -1.0),
        Side::YMax => (1, 1.0),
        Side::ZMin | Side::ZMax => return None,
    };
    Some(Line { axis, sign })
}
