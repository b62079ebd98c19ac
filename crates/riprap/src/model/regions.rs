//! Groups: sets of blocks by place, size, material and name, and what `and`, `or`, `not` make of them.

use riprap_geom::polyhedron::joints::{Extent, Joint};
use riprap_geom::{Vec2, Vec3, polygon};

use super::builder::Builder;
use super::solid::{Opening, has_face, volume};
use crate::numbers::counted;
use crate::scenario::language::{
    AlongSet, Cylinder, Group, HalfSpace, Near, NearFace, Prism, SizeRange, Sphere, span_of,
};
use crate::scenario::quantity::Quantity;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name, Span};
use riprap_core::condition::Condition;

/// Sine of the angle, and share of the size of a region, that round-off may make.
const PARALLEL: f64 = 1e-6;
/// Blocks that the warning of an empty region names.
const NAMED: usize = 3;

/// A region: whether a place (local, m) lies in it, the middle of it, and the word for it.
pub(super) struct Region<'a> {
    pub(super) holds: Box<dyn Fn(Vec3) -> bool + 'a>,
    pub(super) middle: Vec3,
    pub(super) word: &'static str,
    pub(super) at: Span,
}

/// Distance of a point from a straight piece, m, and the place along it, 0 to 1 within.
fn from_line(point: Vec3, [from, to]: [Vec3; 2]) -> (f64, f64) {
    let way = to - from;
    let square = way.length_squared();
    let share = if square > 0.0 { (point - from).dot(way) / square } else { 0.0 };
    ((point - from - share.clamp(0.0, 1.0) * way).length(), share)
}

/// Distance of a point from a polygon, m.
fn from_polygon(point: Vec3, face: &Joint) -> f64 {
    let Extent::Polygon(corners) = &face.extent else { return f64::INFINITY };
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let inside = |(a, b): (&Vec3, &Vec3)| (*b - *a).cross(point - *a).dot(face.normal) >= 0.0;
    if ends.clone().all(inside) {
        return face.normal.dot(point - face.at).abs();
    }
    ends.map(|(a, b)| from_line(point, [*a, *b]).0).fold(f64::INFINITY, f64::min)
}

impl Builder<'_> {
    /// Groups by place, size, material, name, and then those that others make.
    pub(super) fn groups(&mut self) {
        self.directory.materials = self.by_material();
        let said = &self.parsed.scenario.groups;
        for (name, group) in said.iter() {
            let errors = self.errors();
            let shift = self.local3([0.0; 3]).into();
            let said = group.excavation.as_ref();
            let opening = said.and_then(|said| self.opening(said, shift));
            let mut blocks = self.in_regions(name, group, opening.as_ref());
            blocks.extend(group.size.iter().flat_map(|size| self.of_size(size)));
            blocks.extend(opening.iter().flat_map(|opening| self.rounds(name, opening)));
            if let Some(set) = &group.joint_set {
                blocks.extend(match self.space {
                    InSpace::Planar => self.along_traces(name, set),
                    InSpace::Spatial => self.along_set(name, set),
                });
            }
            self.is_face(group);
            if let Some(material) = &group.material {
                match self.directory.of_material(material.as_str()) {
                    Some(of) => blocks.extend(of),
                    None => {
                        let known: Vec<&str> = self.parsed.scenario.materials.names().collect();
                        self.found.push(Diagnostic::unknown("material", material, known));
                    }
                }
            }
            let named = self.directory.all(&group.blocks);
            blocks.extend(self.take(named).unwrap_or_default());
            if self.errors() > errors {
                self.directory.failed.push(name.text.clone());
            }
            // A group that a condition makes is there when the groups in it are.
            if group.condition.is_none() || !blocks.is_empty() {
                self.directory.extend(name.as_str(), blocks);
            }
        }
        let mut waiting: Vec<(&Name, &Name)> =
            said.iter().filter_map(|(name, of)| Some((name, of.condition.as_ref()?))).collect();
        while !waiting.is_empty() {
            let names: Vec<&str> = waiting.iter().map(|(name, _)| name.as_str()).collect();
            let waits = |text: &Name| {
                let of = Condition::read(text.as_str());
                of.is_ok_and(|of| of.names.iter().any(|word| names.contains(&&word.text[..])))
            };
            let (now, later): (Vec<_>, Vec<_>) = waiting.iter().partition(|(_, text)| !waits(text));
            if now.is_empty() {
                let (name, text) = later[0];
                let message = format!(
                    "the conditions of `{name}` and of other groups refer to each other in a circle"
                );
                self.error_at(
                    "group.circle",
                    text,
                    message,
                    "write one of them without the others",
                );
                return;
            }
            for (name, text) in now {
                self.condition(name, text);
            }
            waiting = later;
        }
    }

    /// Blocks in the regions of a group; a warning for one without blocks.
    fn in_regions(&mut self, name: &Name, group: &Group, opening: Option<&Opening>) -> Vec<u32> {
        let mut all = Vec::new();
        let mut regions = self.regions_of(group, opening);
        regions.extend(self.by_surface(group));
        for region in regions {
            let places = self.directory.centroids.iter().map(|c| Vec3::from(*c));
            let inside: Vec<u32> = (0u32..)
                .zip(places)
                .filter(|(_, place)| (region.holds)(*place))
                .map(|(block, _)| block)
                .collect();
            if inside.is_empty() {
                let message = format!("no block centroid lies in the {} of `{name}`", region.word);
                let help = self.nearest(region.middle);
                let note = Diagnostic::warning("group.empty", message).help(help);
                self.found.push(note.at(region.at.clone()));
            }
            all.extend(inside);
        }
        all
    }

    /// Reports a face that is no flat convex polygon.
    fn is_face(&mut self, group: &Group) {
        let Some(said) = &group.near_face else { return };
        let corner =
            |p: &crate::scenario::language::Point3| Vec3::from(p.each_ref().map(Quantity::si));
        let corners: Vec<Vec3> = said.points.iter().map(corner).collect();
        if let Err(what) = Joint::polygon(&corners) {
            let at = said.points.first().map_or(said.distance.span.clone(), span_of);
            let help = "give the corners of a flat convex polygon in order";
            self.error_at("group.face", at, format!("the face {what}"), help);
        }
    }

    /// Blocks of an excavation; each of its parts along the line is a group too.
    fn rounds(&mut self, name: &Name, opening: &Opening) -> Vec<u32> {
        let places = (0u32..).zip(&self.directory.centroids);
        let parts = places.filter_map(|(b, c)| Some((opening.round_of(Vec3::from(*c))?, b)));
        let parts: Vec<(u32, u32)> = parts.collect();
        if opening.rounds() > 1 {
            for round in 0..opening.rounds() {
                let of = parts.iter().filter(|(r, _)| *r == round).map(|(_, b)| *b).collect();
                self.directory.extend(&format!("{name}.{}", round + 1), of);
            }
        }
        parts.into_iter().map(|(_, b)| b).collect()
    }

    /// Blocks with a face along a set of joints.
    fn along_set(&mut self, name: &Name, said: &AlongSet) -> Vec<u32> {
        let sets = self.sets.get(said.of.as_str()).map_or(&[][..], Vec::as_slice);
        let Some(joints) = sets.get(said.number as usize - 1) else {
            self.no_such_set(said, sets.len());
            return Vec::new();
        };
        let range = self.blocks_of_table(said.of.as_str());
        let along = |b: &u32| {
            let shape = &self.spatial.blocks[*b as usize].shape;
            joints.iter().any(|joint| {
                let offset = joint.normal.dot(joint.at);
                has_face(shape, joint.normal, offset) || has_face(shape, -joint.normal, -offset)
            })
        };
        let found: Vec<u32> = range.filter(along).collect();
        self.is_there(name, said, &found);
        found
    }

    /// Blocks in the plane with an edge inside the region that was cut in the direction of a set.
    fn along_traces(&mut self, name: &Name, said: &AlongSet) -> Vec<u32> {
        let block = self.parsed.scenario.blocks.iter().find(|b| b.name.text == said.of.text);
        let cut = block.and_then(|block| block.cut.as_ref());
        let sets = cut.map_or(&[][..], |cut| cut.joint_sets.as_slice());
        let Some(set) = sets.get(said.number as usize - 1) else {
            self.no_such_set(said, sets.len());
            return Vec::new();
        };
        let shift = block.and_then(|b| b.shift.as_ref());
        let shift = shift.map_or(Vec2::ZERO, |shift| Vec2::from(shift.xy()));
        let corners = cut.and_then(|cut| cut.region.as_deref()).unwrap_or_default();
        let outline: Vec<Vec2> = corners.iter().map(|p| self.point(p) + shift).collect();
        let size = polygon::Aabb::of(&outline).size();
        let on_outline = |p: Vec2| {
            let space = |v: Vec2| Vec3::new(v.x, v.y, 0.0);
            let near = |(a, b): (Vec2, Vec2)| {
                from_line(space(p), [space(a), space(b)]).0 <= PARALLEL * size
            };
            polygon::edges(&outline).any(near)
        };
        let (sin, cos) = libm::sincos(set.dip.si());
        let scatter = set.angle_scatter.as_ref().map_or(0.0, Quantity::si);
        let most = libm::sin((3.0 * scatter).min(std::f64::consts::FRAC_PI_2)).max(PARALLEL);
        let along = |(a, b): (Vec2, Vec2)| {
            let way = b - a;
            (way.x * sin - way.y * cos).abs() <= most * way.length() && !on_outline(0.5 * (a + b))
        };
        let has = |b: &u32| polygon::edges(&self.setup.blocks[*b as usize].vertices).any(along);
        let found: Vec<u32> = self.blocks_of_table(said.of.as_str()).filter(has).collect();
        self.is_there(name, said, &found);
        found
    }

    fn no_such_set(&mut self, said: &AlongSet, sets: usize) {
        let message = format!("`{}` has {}", said.of, counted(sets, "joint set"));
        let help = "give the number of a set in its `cut.joint_sets`, from 1";
        self.error_at("group.set", &said.of, message, help);
    }

    /// Numbers of the blocks of a table.
    fn blocks_of_table(&self, name: &str) -> std::ops::Range<u32> {
        let mut tables = self.directory.tables();
        tables.find(|(table, _)| *table == name).map_or(0..0, |(_, range)| range.clone())
    }

    /// A warning where no block lies along a set.
    fn is_there(&mut self, name: &Name, said: &AlongSet, found: &[u32]) {
        if found.is_empty() {
            let message = format!("no block of `{}` has a face along the set of `{name}`", said.of);
            let help = "its joints may lie outside of the blocks: check `spacing` and `origin`; the group is empty";
            self.warn_at("group.empty", &said.of, message, help);
        }
    }

    /// The blocks nearest to the middle of an empty region, in words.
    fn nearest(&self, middle: Vec3) -> String {
        let places = self.directory.centroids.iter().map(|c| Vec3::from(*c));
        let mut near: Vec<(f64, u32, Vec3)> =
            (0u32..).zip(places).map(|(b, c)| ((c - middle).length(), b, c)).collect();
        near.sort_by(|a, b| a.0.total_cmp(&b.0));
        let words = near.iter().take(NAMED).map(|(_, block, place)| {
            let [x, y, z] = self.everywhere(*place).to_array();
            let place = match self.space {
                InSpace::Planar => format!("{x:.4}, {y:.4}"),
                InSpace::Spatial => format!("{x:.4}, {y:.4}, {z:.4}"),
            };
            format!("`{}` at ({place}) m", self.directory.name(*block))
        });
        let words: Vec<String> = words.collect();
        format!(
            "check place and units; nearest to its middle: {}; the group is empty",
            words.join(", ")
        )
    }

    /// A local place in the coordinates of the scene.
    pub(super) fn everywhere(&self, place: Vec3) -> Vec3 {
        match self.space {
            InSpace::Planar => place + Vec3::new(self.origin.x, self.origin.y, 0.0),
            InSpace::Spatial => place + self.spatial.origin,
        }
    }

    /// The regions of a group.
    fn regions_of(&self, group: &Group, opening: Option<&Opening>) -> Vec<Region<'static>> {
        let mut all = Vec::new();
        let local = |place: [f64; 3]| Vec3::from(self.local3(place));
        if let Some(of) = &group.region {
            let (min, max) = (local(of.min.xyz()), local(of.max.xyz()));
            all.push(Region {
                holds: Box::new(move |c| c.cmpge(min).all() && c.cmple(max).all()),
                middle: 0.5 * (min + max),
                word: "box",
                at: of.min.span.clone(),
            });
        }
        if let Some(HalfSpace { at, normal }) = &group.half_space {
            let (place, normal) = (local(at.xyz()), Vec3::from(normal.xyz()));
            all.push(Region {
                holds: Box::new(move |c| (c - place).dot(normal) >= 0.0),
                middle: place,
                word: "half-space",
                at: at.span.clone(),
            });
        }
        if let Some(Sphere { centre, radius }) = &group.sphere {
            let (middle, radius) = (local(centre.xyz()), radius.si());
            all.push(Region {
                holds: Box::new(move |c| (c - middle).length() <= radius),
                middle,
                word: "sphere",
                at: centre.span.clone(),
            });
        }
        if let Some(Cylinder { from, to, radius }) = &group.cylinder {
            let (ends, radius, at) =
                ([from, to].map(|end| local(end.xyz())), radius.si(), &from.span);
            all.push(Region {
                holds: Box::new(move |c| {
                    let (distance, share) = from_line(c, ends);
                    (0.0..=1.0).contains(&share) && distance <= radius
                }),
                middle: 0.5 * (ends[0] + ends[1]),
                word: "cylinder",
                at: at.clone(),
            });
        }
        if let Some(Near { from, to, distance }) = &group.near {
            let (ends, most) = ([from, to].map(|end| local(end.xyz())), distance.si());
            all.push(Region {
                holds: Box::new(move |c| from_line(c, ends).0 <= most),
                middle: 0.5 * (ends[0] + ends[1]),
                word: "neighbourhood of the line",
                at: from.span.clone(),
            });
        }
        if let Some(said) = &group.excavation
            && let Some(opening) = opening.cloned()
        {
            all.push(Region {
                middle: opening.middle(),
                holds: Box::new(move |c| opening.round_of(c).is_some()),
                word: "excavation",
                at: span_of(&said.from),
            });
        }
        all.extend(group.near_face.as_ref().and_then(|face| self.near_face(face)));
        all.extend(group.prism.as_ref().and_then(|prism| self.prism(prism)));
        all
    }

    /// What is near a polygon; `None` where it is none, which [`Self::groups`] reports.
    fn near_face(&self, said: &NearFace) -> Option<Region<'static>> {
        let corner = |p: &crate::scenario::language::Point3| {
            Vec3::from(self.local3(p.each_ref().map(Quantity::si)))
        };
        let corners: Vec<Vec3> = said.points.iter().map(corner).collect();
        let face = Joint::polygon(&corners).ok()?;
        let most = said.distance.si();
        let middle = face.at;
        Some(Region {
            holds: Box::new(move |c| from_polygon(c, &face) <= most),
            middle,
            word: "neighbourhood of the face",
            at: span_of(said.points.first()?),
        })
    }

    fn prism(&self, prism: &Prism) -> Option<Region<'static>> {
        let z = |bound: &Option<Quantity<_>>, none: f64| bound.as_ref().map_or(none, Quantity::si);
        let (low, high) = (z(&prism.from, f64::NEG_INFINITY), z(&prism.to, f64::INFINITY));
        let corner = |point: &crate::scenario::language::Point| {
            let [x, y, _] = self.local3([point[0].si(), point[1].si(), 0.0]);
            [x, y]
        };
        let corners: Vec<[f64; 2]> = prism.points.iter().map(corner).collect();
        let shift = self.local3([0.0; 3])[2];
        let first = prism.points.first()?;
        let n = corners.len() as f64;
        let sum = corners.iter().fold([0.0; 2], |s, c| [s[0] + c[0], s[1] + c[1]]);
        let height = if low.is_finite() && high.is_finite() { 0.5 * (low + high) } else { 0.0 };
        Some(Region {
            holds: Box::new(move |c| {
                let height = c.z - shift;
                height >= low && height <= high && in_polygon(&corners, c.x, c.y)
            }),
            middle: Vec3::new(sum[0] / n, sum[1] / n, height + shift),
            word: "prism",
            at: first[0].span.clone(),
        })
    }

    /// Blocks of a size.
    fn of_size(&self, size: &SizeRange) -> Vec<u32> {
        let edges: Vec<f64> = match self.space {
            InSpace::Planar => {
                let area = |b: &crate::planar::setup::BlockSpec| {
                    libm::sqrt(riprap_geom::polygon::mass_properties(&b.vertices).area)
                };
                self.setup.blocks.iter().map(area).collect()
            }
            InSpace::Spatial => {
                self.spatial.blocks.iter().map(|b| libm::cbrt(volume(&b.shape))).collect()
            }
        };
        let holds = |edge: f64| {
            size.above.as_ref().is_none_or(|of| edge > of.si())
                && size.below.as_ref().is_none_or(|of| edge < of.si())
        };
        (0u32..).zip(edges).filter(|(_, edge)| holds(*edge)).map(|(b, _)| b).collect()
    }

    /// Blocks of each material.
    fn by_material(&self) -> Vec<(String, Vec<u32>)> {
        let all: Vec<u16> = match self.space {
            InSpace::Planar => self.setup.blocks.iter().map(|b| b.material).collect(),
            InSpace::Spatial => self.spatial.blocks.iter().map(|b| b.material).collect(),
        };
        let of = |number: usize| {
            let of = (0u32..).zip(&all).filter(move |(_, m)| usize::from(**m) == number);
            of.map(|(b, _)| b).collect()
        };
        let names = self.parsed.scenario.materials.names().enumerate();
        names.map(|(number, name)| (name.to_owned(), of(number))).collect()
    }

    /// Adds what a condition holds to a group.
    fn condition(&mut self, name: &Name, text: &Name) {
        match self.directory.fulfil(text) {
            Ok((blocks, counts)) => {
                if self.directory.rests_on_failed(text) {
                    self.directory.failed.push(name.text.clone());
                } else if blocks.is_empty() {
                    let message = format!("no block fulfils `where` of `{name}`");
                    let note = Diagnostic::warning("group.empty", message);
                    let note = note.help(format!("{counts}; the group is empty"));
                    self.found.push(note.at(text.span.clone()));
                }
                self.directory.extend(name.as_str(), blocks);
            }
            Err(mut wrong) => {
                wrong.message = format!("`where` of `{name}`: {}", wrong.message);
                self.found.push(*wrong);
                self.directory.failed.push(name.text.clone());
                // It exists all the same: what names it is no second error.
                self.directory.extend(name.as_str(), Vec::new());
            }
        }
    }
}

/// Whether a point lies in a polygon.
fn in_polygon(corners: &[[f64; 2]], x: f64, y: f64) -> bool {
    let mut inside = false;
    for (k, [x0, y0]) in corners.iter().enumerate() {
        let [x1, y1] = corners[(k + 1) % corners.len()];
        if (*y0 > y) != (y1 > y) && x < x0 + (y - y0) * (x1 - x0) / (y1 - y0) {
            inside = !inside;
        }
    }
    inside
}
