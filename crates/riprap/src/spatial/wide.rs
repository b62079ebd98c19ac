//! Forces of eight patches at a time, where all their points are certainly elastic.
//!
//! For a patch normal to an axis the four springs together are `F = k D` and `M = kr (th_j - th_i)` component
//! by component in space, with `kr` the second moments of the points: no frames, no points. A packet is eight
//! patches of one axis; mostly they are neighbours of one class, whose blocks lie side by side in the lists.

use super::forces::Shared;
use super::lanes::{LANES, Lanes, Vectors, cross, minus, plus, times};
use super::sums::Part;
use super::tiles::Packet;
use super::world::PatchClass;

/// What the wide kernel needs of a class.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wide {
    /// Arms of i and j (x, y, z), m.
    arms: [[f64; 3]; 2],
    /// Area times stiffness along x, y, z, N/m.
    stiffness: [f64; 3],
    /// Stiffness against relative rotation about x, y, z, N m.
    turning: [f64; 3],
    /// Area, m².
    area: f64,
    /// Moment of the in-situ stress about the centre, N m.
    moment: [f64; 3],
    /// Dashpot over spring, s.
    beta: f64,
    /// Normal and shear stiffness, Pa/m.
    springs: [f64; 2],
    /// Distances of the points along b and c, m.
    reach: [f64; 2],
    /// Most that the in-situ stress of a point differs from that of the centre (n, b, c), Pa.
    spread: [f64; 3],
    /// Cohesion, tension and tan(phi); infinite strength when elastic.
    strength: [f64; 3],
}

impl Wide {
    /// Constants of a class; meaningless for one that is not normal to an axis.
    #[must_use]
    pub fn new(class: &PatchClass, strength: Option<&super::setup::Strength>) -> Self {
        let axis = usize::from(class.axis % 3);
        let along = [0, 1, 2].map(|k| (k + 3 - axis) % 3);
        let [kn, ks] = class.stiffness;
        let [b2, c2] = class.reach.map(|r| r * r);
        let local = [kn, ks, ks];
        let turn = [ks * (b2 + c2), kn * c2, kn * b2];
        let [sb, sc] = class.slope;
        let moment = [b2 * sb[2] - c2 * sc[1], c2 * sc[0], -b2 * sb[0]];
        let [rb, rc] = class.reach;
        Self {
            arms: class.arms.map(|a| a.to_array()),
            stiffness: along.map(|k| class.area * local[k]),
            turning: along.map(|k| class.area * turn[k]),
            area: class.area,
            moment: along.map(|k| class.area * moment[k]),
            beta: class.beta,
            springs: class.stiffness,
            reach: class.reach,
            spread: [0, 1, 2].map(|k| rb * sb[k].abs() + rc * sc[k].abs()),
            strength: strength.map_or([f64::INFINITY, f64::INFINITY, 0.0], |s| {
                [s.cohesion, s.tension, s.friction]
            }),
        }
    }
}

/// Where the lanes of a packet find their blocks.
enum Places {
    /// From these on, side by side.
    Runs([usize; 2]),
    /// One by one; lanes beyond the count repeat the first.
    Each([[usize; LANES]; 2]),
}

/// Sums that packets add to.
pub struct Targets<'a, 'b> {
    /// Sums of the tile's blocks: elastic, dashpots.
    pub net: &'b mut [Part<'a>; 2],
    /// Slots of its crossing patches.
    pub slots: &'b mut [Part<'a>; 2],
    /// First block of the tile.
    pub base: usize,
    /// Slot of the packet's first patch, if its patches end in another tile.
    pub slot: Option<usize>,
}

/// Forces of one packet; lanes in the result's bits are left out: their points may fail, or have failed.
#[inline(always)]
pub fn packet(
    shared: &Shared,
    wide: &[Wide],
    packet: &Packet,
    mut skip: u8,
    to: &mut Targets,
) -> u8 {
    let first = packet.first as usize;
    let count = usize::from(packet.count);
    let ends = &shared.ends[first..first + count];
    let places = if packet.runs {
        Places::Runs(ends[0].map(|b| b as usize))
    } else {
        let of = |side: usize| {
            std::array::from_fn(|k| ends[if k < count { k } else { 0 }][side] as usize)
        };
        Places::Each([of(0), of(1)])
    };
    let class = Class::load(shared, wide, packet);
    let bodies = shared.poses.bodies;
    let (d, w) = relative(&bodies.pose, &places, &class.arms);
    let mut force = times(&class.stiffness, &d);
    let mut moment = times(&class.turning, &w);
    let mut start = [Lanes::default(); 3];
    if !shared.prestress.is_empty() {
        for (k, lanes) in start.iter_mut().enumerate() {
            for lane in 0..count {
                lanes.0[lane] = shared.prestress[first + lane][k];
            }
        }
        let load = start.map(|s| class.area * s);
        force = plus(&force, &load);
        moment = plus(&moment, &class.moment);
    }
    if shared.strong {
        skip |= class.doubtful(usize::from(packet.axis), &start, &d, &w);
    }
    if count < LANES {
        skip |= u8::MAX << count;
    }
    let keep = Lanes(std::array::from_fn(|k| {
        if skip & (1 << k) == 0 { 1.0 } else { 0.0 }
    }));
    let whole = skip == 0;
    if !whole {
        force = force.map(|f| f * keep);
        moment = moment.map(|m| m * keep);
    }
    add(to, 0, &places, count, &class.arms, &force, &moment);
    if shared.damped {
        let (v, spin) = relative(&bodies.rate, &places, &class.arms);
        let beta = (class.beta + Lanes::all(shared.stiffness_damping)) * keep;
        let force = times(&class.stiffness, &v).map(|f| beta * f);
        let moment = times(&class.turning, &spin).map(|m| beta * m);
        add(to, 1, &places, count, &class.arms, &force, &moment);
    }
    if count < LANES {
        skip & !(u8::MAX << count)
    } else {
        skip
    }
}

/// Constants of the classes, lane by lane.
struct Class {
    arms: [Vectors; 2],
    stiffness: Vectors,
    turning: Vectors,
    area: Lanes,
    moment: Vectors,
    beta: Lanes,
    springs: [Lanes; 2],
    reach: [Lanes; 2],
    spread: Vectors,
    strength: Vectors,
}

impl Class {
    #[inline(always)]
    fn load(shared: &Shared, wide: &[Wide], packet: &Packet) -> Self {
        let first = packet.first as usize;
        let count = usize::from(packet.count);
        if packet.one_class {
            let k = &wide[shared.class[first] as usize];
            return Self {
                arms: k.arms.map(|a| a.map(Lanes::all)),
                stiffness: k.stiffness.map(Lanes::all),
                turning: k.turning.map(Lanes::all),
                area: Lanes::all(k.area),
                moment: k.moment.map(Lanes::all),
                beta: Lanes::all(k.beta),
                springs: k.springs.map(Lanes::all),
                reach: k.reach.map(Lanes::all),
                spread: k.spread.map(Lanes::all),
                strength: k.strength.map(Lanes::all),
            };
        }
        let index: [usize; LANES] =
            std::array::from_fn(|k| shared.class[first + if k < count { k } else { 0 }] as usize);
        let of = |f: &dyn Fn(&Wide) -> f64| Lanes(index.map(|k| f(&wide[k])));
        Self {
            arms: [0, 1].map(|s| [0, 1, 2].map(|k| of(&|w| w.arms[s][k]))),
            stiffness: [0, 1, 2].map(|k| of(&|w| w.stiffness[k])),
            turning: [0, 1, 2].map(|k| of(&|w| w.turning[k])),
            area: of(&|w| w.area),
            moment: [0, 1, 2].map(|k| of(&|w| w.moment[k])),
            beta: of(&|w| w.beta),
            springs: [0, 1].map(|k| of(&|w| w.springs[k])),
            reach: [0, 1].map(|k| of(&|w| w.reach[k])),
            spread: [0, 1, 2].map(|k| of(&|w| w.spread[k])),
            strength: [0, 1, 2].map(|k| of(&|w| w.strength[k])),
        }
    }

    /// Bits of the lanes in which a point may be beyond its strength: by bounds over the four points.
    #[inline(always)]
    fn doubtful(&self, axis: usize, start: &Vectors, d: &Vectors, w: &Vectors) -> u8 {
        let [n, b, c] = [axis, (axis + 1) % 3, (axis + 2) % 3];
        let [kn, ks] = self.springs;
        let [rb, rc] = self.reach;
        let tension = start[n] + kn * (d[n] + (w[b].abs() * rc + w[c].abs() * rb)) + self.spread[0];
        let shear_b = (start[b] + ks * d[b]).abs() + ks * (w[n].abs() * rc) + self.spread[1];
        let shear_c = (start[c] + ks * d[c]).abs() + ks * (w[n].abs() * rb) + self.spread[2];
        let [cohesion, cut, friction] = self.strength;
        let limit = cohesion - friction * tension;
        let shear = shear_b * shear_b + shear_c * shear_c;
        let limit2 = limit * limit;
        let mut bits = 0;
        for k in 0..LANES {
            let fine = tension.0[k] <= cut.0[k] && limit.0[k] >= 0.0 && shear.0[k] <= limit2.0[k];
            bits |= u8::from(!fine) << k;
        }
        bits
    }
}

/// Relative displacement of the patch centres and relative rotation (or their rates).
#[inline(always)]
fn relative(lists: &[Vec<f64>; 6], places: &Places, arms: &[Vectors; 2]) -> (Vectors, Vectors) {
    let load = |side: usize, first: usize| -> Vectors {
        [0, 1, 2].map(|k| match places {
            Places::Runs(from) => Lanes::at(&lists[first + k], from[side]),
            Places::Each(index) => Lanes::pick(&lists[first + k], &index[side]),
        })
    };
    let turn = [load(0, 3), load(1, 3)];
    let end = |side: usize| plus(&load(side, 0), &cross(&turn[side], &arms[side]));
    (minus(&end(1), &end(0)), minus(&turn[1], &turn[0]))
}

/// Adds forces and moments to both blocks of each lane.
#[inline(always)]
fn add(
    to: &mut Targets,
    kind: usize,
    places: &Places,
    count: usize,
    arms: &[Vectors; 2],
    force: &Vectors,
    moment: &Vectors,
) {
    let on_i = plus(&cross(&arms[0], force), moment);
    let on_j = plus(&cross(&arms[1], force), moment);
    let net = &mut to.net[kind];
    let base = to.base;
    for k in 0..3 {
        for (list, lanes) in [(k, &force[k]), (k + 3, &on_i[k])] {
            spread(net.0[list], places, 0, base, count, lanes);
        }
    }
    for k in 0..3 {
        for (list, lanes) in [(k, -force[k]), (k + 3, -on_j[k])] {
            match to.slot {
                Some(slot) => {
                    to.slots[kind].0[list][slot..slot + count].copy_from_slice(&lanes.0[..count]);
                }
                None => spread(net.0[list], places, 1, base, count, &lanes),
            }
        }
    }
}

#[inline(always)]
fn spread(
    list: &mut [f64],
    places: &Places,
    side: usize,
    base: usize,
    count: usize,
    lanes: &Lanes,
) {
    match places {
        Places::Runs(from) => {
            let at = from[side] - base;
            for (x, y) in list[at..at + LANES].iter_mut().zip(lanes.0) {
                *x += y;
            }
        }
        Places::Each(index) => {
            for k in 0..count {
                list[index[side][k] - base] += lanes.0[k];
            }
        }
    }
}
