//! Supports, loads and the functions of time that drive them.

use std::collections::BTreeSet;

use riprap_geom::{Vec2, polygon};

use super::accounts::condition_name;
use super::builder::Builder;
use crate::accounts::Holder;
use crate::dynamics::{Formula, TimeFunction};
use crate::planar::setup::{Load, LoadKind, Motion, Support};
use crate::scenario::csv_columns::{self, Column};
use crate::scenario::foreign::at2::parse_at2;
use crate::scenario::language::{self, EdgeLoad, Point, Target};
use crate::scenario::quantity::{Kind, Length, Vector, Velocity};
use crate::scenario::read::{Given, with_unit};
use crate::scenario::time_function::{CsvFunction, OF_PLACE_AND_TIME, OF_TIME, RecordFunction};
use crate::scenario::units::Dim;
use crate::scenario::vectors::InSpace;
use crate::scenario::{self, Name, Quantity, Span, target_span};

/// A point of a load lies on a boundary if it is nearer than this, times the size of the block.
const ON_BOUNDARY: f64 = 1e-6;
/// A factor nearer than this share to that of a unit was meant to convert from it: 9.8, 9.81 and 9.80665.
const ALIKE: f64 = 0.005;

/// Whether a spin turns the blocks as one body: several, or any about a given point.
pub(super) fn as_one<L: Kind, R: Kind>(
    said: &language::MotionComponents<L, R>,
    blocks: &[u32],
) -> bool {
    said.each != Some(true) && (said.about.is_some() || blocks.len() > 1)
}

/// Whether a spin turns anything.
pub(super) fn turns(spin: &TimeFunction) -> bool {
    *spin != TimeFunction::Constant(0.0)
}

/// The function, or rest where there is none `if` what is not given is held.
pub(super) fn held_if(held: bool, f: Option<TimeFunction>) -> Option<TimeFunction> {
    f.or_else(|| held.then_some(TimeFunction::Constant(0.0)))
}

impl Builder<'_> {
    pub(super) fn supports(&mut self) {
        let mut supported = BTreeSet::new();
        for (number, support) in self.parsed.scenario.supports.iter().enumerate() {
            let Some(blocks) = self.target(&support.on) else {
                continue;
            };
            self.tell_second_support(&mut supported, &blocks, &support.on);
            let motion = match (&support.fixed, &support.motion) {
                (Some(f), _) => Some(Motion::Fixed {
                    x: f.x_or_default(),
                    y: f.y_or_default(),
                    rotation: f.rotation_or_default(),
                }),
                (None, Some(language::Motion::Velocity(m))) => {
                    let (x, y) = (self.maybe(m.x.as_ref()), self.maybe(m.y.as_ref()));
                    let spin = self.maybe(m.spin.as_ref());
                    let about =
                        (spin.as_ref().is_some_and(turns) && as_one(m, &blocks)).then(|| {
                            let given =
                                m.about.as_ref().map(|at| Vec2::from(at.xy()) - self.origin);
                            given.unwrap_or_else(|| self.centroid_of(&blocks))
                        });
                    Some(Motion::Velocity {
                        x: held_if(about.is_some(), x),
                        y: held_if(about.is_some(), y),
                        spin,
                        about,
                    })
                }
                (None, Some(language::Motion::Acceleration(m))) => {
                    let (x, y) = (self.maybe(m.x.as_ref()), self.maybe(m.y.as_ref()));
                    let spin = self.maybe(m.spin.as_ref());
                    if spin.as_ref().is_some_and(turns) && as_one(m, &blocks) {
                        self.tell_turning_each(&support.on);
                    }
                    Some(Motion::Acceleration { x, y, spin })
                }
                // Reported by the rules of the language.
                (None, None) => None,
            };
            if let Some(motion) = motion {
                let name = condition_name(support.name.as_ref(), &support.on, number);
                self.account(name, Holder::Support(self.setup.supports.len() as u16));
                self.setup.supports.push(Support { blocks, motion });
            }
        }
    }

    /// Centroid of the masses of some blocks, m (local).
    fn centroid_of(&self, blocks: &[u32]) -> Vec2 {
        let (mut sum, mut mass) = (Vec2::ZERO, 0.0);
        for &b in blocks {
            let block = &self.setup.blocks[b as usize];
            let of = polygon::mass_properties(&block.vertices);
            sum += block.density * of.area * of.centroid;
            mass += block.density * of.area;
        }
        sum / mass
    }

    /// An acceleration turns each block about its own centroid, which is reported where there are several.
    fn tell_turning_each(&mut self, on: &Target) {
        let message =
            "a prescribed angular acceleration rotates each of these blocks about its own centroid";
        let help = "prescribe the spin by a `velocity`, which rotates them as one body, or write each = true";
        self.error_at("supports.turn", target_span(on), message, help);
    }

    /// Warns of blocks that a support before this one holds or drives: the last one alone acts on them, freedoms do not add up.
    pub(super) fn tell_second_support(
        &mut self,
        supported: &mut BTreeSet<u32>,
        blocks: &[u32],
        on: &Target,
    ) {
        let twice: Vec<u32> =
            (blocks.iter().copied()).filter(|block| !supported.insert(*block)).collect();
        let Some(first) = twice.first().map(|block| self.directory.name(*block)) else {
            return;
        };
        let message = match twice.len() {
            1 => format!("block `{first}` already has a support; this one replaces it"),
            n => {
                format!("{n} blocks, first `{first}`, already have a support; this one replaces it")
            }
        };
        let help = "freedoms that the earlier support fixes or drives are released; give all conditions of a block in one support";
        self.warn_at("supports.twice", target_span(on), message, help);
    }

    pub(super) fn maybe<K: Kind>(
        &mut self,
        f: Option<&scenario::TimeFunction<K>>,
    ) -> Option<TimeFunction> {
        f.and_then(|f| self.time_function(f))
    }

    /// Velocities along x, y, z of points, over time and by place; `None` where a direction is free, or after an error.
    pub(super) fn point_velocity<R: Kind>(
        &mut self,
        said: &language::MotionComponents<Velocity, R>,
    ) -> [Option<TimeFunction>; 3] {
        [&said.x, &said.y, &said.z]
            .map(|f| (f.as_ref()).and_then(|f| self.function_of(f, &OF_PLACE_AND_TIME)))
    }

    /// A function of time in SI; `None` after an error.
    pub(super) fn time_function<K: Kind>(
        &mut self,
        f: &scenario::TimeFunction<K>,
    ) -> Option<TimeFunction> {
        self.function_of(f, &OF_TIME)
    }

    /// A function in SI whose formula uses the names `known`; `None` after an error.
    fn function_of<K: Kind>(
        &mut self,
        f: &scenario::TimeFunction<K>,
        known: &[&str],
    ) -> Option<TimeFunction> {
        use scenario::TimeFunction as Said;
        Some(match f {
            Said::Constant(value) => TimeFunction::Constant(value.si()),
            Said::Ramp(ramp) => TimeFunction::Ramp {
                from: ramp.from.si(),
                to: ramp.to.si(),
                start: ramp.start.si_or(0.0),
                end: ramp.end.si(),
            },
            Said::Sine(sine) => TimeFunction::Sine {
                amplitude: sine.amplitude.si(),
                frequency: sine.frequency.si(),
                phase: sine.phase.si_or(0.0),
                offset: sine.offset.si_or(0.0),
                start: sine.start.si_or(0.0),
                cycles: sine.cycles.as_ref().map(Quantity::si),
            },
            Said::Pulse(pulse) => TimeFunction::Pulse {
                value: pulse.value.si(),
                start: pulse.start.si_or(0.0),
                end: pulse.end.si(),
            },
            Said::Duvall(d) => TimeFunction::duvall(d.peak.si(), d.decay.si(), d.rise.si()),
            Said::Triangle(t) => TimeFunction::triangle(t.peak.si(), t.rise.si(), t.fall.si()),
            Said::Csv(csv) => {
                let (t, v) = self.csv_function(csv, self.dim_of::<K>())?;
                TimeFunction::Table { t, v }
            }
            Said::At2(record) => {
                let (t, v) = self.record_function(record, self.dim_of::<K>())?;
                TimeFunction::Table { t, v }
            }
            Said::Formula(text) => TimeFunction::Formula(self.formula(text, known)?),
        })
    }

    /// Dimension of the values of a kind in this space.
    fn dim_of<K: Kind>(&self) -> Dim {
        let other = match self.space {
            InSpace::Spatial => K::SPATIAL.map(|other| other.dim),
            InSpace::Planar => None,
        };
        other.or(K::DIM).unwrap_or(Dim::NONE)
    }

    pub(super) fn formula(&mut self, text: &Name, known: &[&str]) -> Option<Formula> {
        self.take(scenario::read_formula(text, known).map_err(|error| vec![error]))
    }

    /// Times, strictly ascending, and values of a CSV file, which are of the dimension `dim`.
    pub(super) fn csv_function(
        &mut self,
        csv: &CsvFunction,
        dim: Dim,
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        let (time, column) = ([csv.time.as_str()], [csv.column.as_str()]);
        let unit = dim.unit();
        let mut values = Column::chosen(&column, dim, &unit);
        if let Some(said) = &csv.unit {
            values.given = Some(self.unit_of_values(said, dim)?);
        }
        let columns = [Column::chosen(&time, Dim::TIME, "s"), values];
        let table = self.table(&csv.file, &columns)?;
        let (times, values) = (table.values(0), table.values(1));
        // Between two equal times nothing could be interpolated.
        if let Some(k) = times.windows(2).position(|pair| pair[1] <= pair[0]) {
            let message = format!(
                "`{}`: time does not increase from {} s to {} s (lines {} and {})",
                csv.file,
                times[k],
                times[k + 1],
                table.lines[k],
                table.lines[k + 1]
            );
            let help = "sort the lines by time and give each time once";
            self.error_at("file.csv", &csv.time, message, help);
            return None;
        }
        let scale = csv.scale.si_or(1.0);
        if let (Some(said), Some(found)) = (&csv.scale, &table.columns[1])
            && csv.unit.is_none()
            && converts(scale, found.factor)
        {
            let message = format!(
                "`scale` is {scale}, but the column `{}` has a unit and is already converted (1 becomes {})",
                found.name, found.factor
            );
            let help =
                "remove `scale`; or give `unit`, which overrides the unit in the column name";
            self.error_at("csv.scale", said.span.clone(), message, help);
            return None;
        }
        let scaled = values.iter().map(|v| v * scale).collect();
        Some((times.to_vec(), scaled))
    }

    /// Times and values of a record, which are of the dimension `dim`; `None` after an error.
    fn record_function(&mut self, said: &RecordFunction, dim: Dim) -> Option<(Vec<f64>, Vec<f64>)> {
        let help = "a PEER record has its unit in line 3, and NPTS and DT in line 4";
        let record = self.foreign_file(&said.file, parse_at2, help)?;
        if record.dim != dim {
            let message = format!("`{}` is {}", said.file, record.dim.describe());
            let help = format!("{} is expected here", dim.describe());
            self.error_at("unit.dimension", &said.file, message, &help);
            return None;
        }
        let count = record.values.len();
        let last = with_unit(record.dt * (count - 1) as f64, "s");
        self.note_import(&said.file, &format!("read {count} of {count} values, 0 to {last}"));
        let scale = said.scale.si_or(1.0);
        let times = (0..count).map(|k| k as f64 * record.dt);
        let values = record.values.into_iter().map(|v| v * scale);
        Some((times.collect(), values.collect()))
    }

    /// SI value of 1 in the unit that a scene gives the values of a file; `None` after an error.
    fn unit_of_values(&mut self, said: &Name, dim: Dim) -> Option<f64> {
        match csv_columns::unit(said.as_str(), dim) {
            Ok(factor) => Some(factor),
            Err(message) => {
                let help = format!("expected {}, for example \"{}\"", dim.describe(), dim.unit());
                let help = match dim {
                    Dim::NONE => "the values are dimensionless; write \"1\"".to_owned(),
                    _ => help,
                };
                self.error_at("unit.dimension", said, message, &help);
                None
            }
        }
    }

    pub(super) fn loads(&mut self) {
        for (number, load) in self.parsed.scenario.loads.iter().enumerate() {
            let Some(blocks) = self.target(&load.on) else {
                continue;
            };
            let time = match &load.time {
                Some(f) => match self.time_function(f) {
                    Some(time) => time,
                    None => continue,
                },
                // The size of a load stands in its kind: the function of time is a factor.
                None => TimeFunction::Constant(1.0),
            };
            let mut kinds = Vec::new();
            if let Some(point) = &load.point {
                let place = |at: &Vector<Length>| Vec2::from(at.xy()) - self.origin;
                let at = point.at.as_ref().map(place);
                if let (Some(at), Some(said)) = (at, &point.at) {
                    self.point_in_blocks(&blocks, at, &said.span);
                }
                let force = point.force.xy().into();
                kinds.push(LoadKind::Point { force, at, follows: point.follows });
            }
            if let Some(edge) = &load.edge {
                kinds.extend(self.edge_load(edge, &blocks));
            }
            if let Some(moment) = &load.moment {
                kinds.push(LoadKind::Moment { moment: moment.single().unwrap_or(0.0) });
            }
            if let Some(body) = &load.body {
                kinds.push(LoadKind::BodyForce { acceleration: body.acceleration.xy().into() });
            }
            let name = condition_name(load.name.as_ref(), &load.on, number);
            // One for all kinds: they come from one table of the scene, and it is named there.
            let account = self.account(name, Holder::Load);
            for kind in kinds {
                self.setup.loads.push(Load {
                    blocks: blocks.clone(),
                    kind,
                    time: time.clone(),
                    account,
                });
            }
        }
    }

    fn point_in_blocks(&mut self, blocks: &[u32], at: Vec2, span: &Span) {
        for &b in blocks {
            let block = &self.setup.blocks[b as usize];
            let size = polygon::Aabb::of(&block.vertices).size();
            let inside = polygon::contains(&block.vertices, at);
            if !inside && polygon::distance_to_boundary(&block.vertices, at) > ON_BOUNDARY * size {
                let message = format!("this point is outside block `{}`", block.name);
                let help = "the force still acts there, as if on a rigid arm fixed to the block";
                self.warn_at("load.outside", span.clone(), message, help);
            }
        }
    }

    fn edge_load(&mut self, edge: &EdgeLoad, blocks: &[u32]) -> Option<LoadKind> {
        let (from, to) = (self.point(&edge.from), self.point(&edge.to));
        let span = span_of(&edge.from).start..span_of(&edge.to).end;
        if from == to {
            let message = "`from` and `to` coincide";
            let help = "give two points of one edge of the block";
            self.error_at("load.edge", span, message, help);
            return None;
        }
        for &b in blocks {
            let block = &self.setup.blocks[b as usize];
            let slack = ON_BOUNDARY * polygon::Aabb::of(&block.vertices).size();
            let on = |p: Vec2, (a, b): (Vec2, Vec2)| polygon::distance_to_segment(p, a, b) <= slack;
            if !polygon::edges(&block.vertices).any(|side| on(from, side) && on(to, side)) {
                let message = format!("`from` and `to` do not lie on one edge of `{}`", block.name);
                let help =
                    "give two points of the same straight edge, in its position at the start";
                self.error_at("load.edge", span, message, help);
                return None;
            }
        }
        let pair = |q: Option<[f64; 2]>| q.unwrap_or([0.0; 2]);
        Some(LoadKind::Edge {
            from,
            to,
            traction: [pair(edge.traction.as_ref().map(|[x, y]| [x.si(), y.si()])).into(); 2],
            pressure: pair(edge.pressure.as_ref().map(|[a, b]| [a.si(), b.si()])),
        })
    }
}

/// Place of a point in the text.
pub(super) fn span_of(point: &Point) -> Span {
    point[0].span.start..point[1].span.end
}

/// Whether a factor is that of a unit other than SI: a scene from before units of columns were read.
fn converts(scale: f64, factor: f64) -> bool {
    factor != 1.0 && (scale / factor - 1.0).abs() < ALIKE
}
