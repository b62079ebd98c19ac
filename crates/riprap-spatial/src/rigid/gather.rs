//! Second pass of the gathering: slots, faces, loads, gravity; works of the kick.
//!
//! The first pass has left in the sums of each block the patches that its own piece could add, in the order that
//! [`crate::state::tiles`] draws. This pass goes on with the slots, in the same order, and then with what acts on a block from
//! outside:
//!
//! ```text
//!    sum of b  =  ((((patches of its group + of earlier groups in its piece)     first pass
//!                    + slots: earlier groups in other pieces, nearest first
//!                    + slots: later groups)                                      second pass
//!                   + weight) + loads, faces with a condition, pushes)
//! ```
//!
//! Works (what forces did in the half step before and will do in the half step after) are added up over the 64 blocks of a
//! group, rows first and then single blocks, and over a fixed tree of the groups.

use std::time::Instant;

use riprap_core::cut;
use riprap_geom::Vec3;

use crate::exec::Divide;
use crate::joint::patch::Poses;
use crate::lanes::{LANES, Lanes, Width};
use crate::push::boundary;
use crate::push::boundary::FaceForces;
use crate::rigid::kick::{Acting, Kick, Moving};
use crate::state::bodies::{Bodies, SolidClass, Turned};
use crate::state::contact_scratch::{ContactScratch, Share};
use crate::state::face::Face;
use crate::state::push::{Pushes, Wrench};
use crate::state::scratch::{FaceEntry, NonFinite, Partial, Scratch};
use crate::state::share::Gathered;
use crate::state::sums;
use crate::state::sums::{Part, Sums};
use crate::state::tiles::{GROUP, Row, Tile, Tiles};
use crate::state::world::World;

/// Piece of work of the second pass.
struct Second<'a> {
    tiles: &'a [Tile],
    net: [Part<'a>; 2],
    faces: &'a mut [Face],
    /// Of the faces; empty where nobody keeps accounts.
    entries: &'a mut [FaceEntry],
    partial: &'a mut [Partial],
}

impl Divide for Second<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let [a, b] = [&self.tiles[0], &self.tiles[middle]];
        let blocks = b.blocks.start - a.blocks.start;
        let count = b.faces.start - a.faces.start;
        cut!(self, tiles: middle, net: blocks, faces: count, entries: count, partial: blocks / GROUP)
    }
}

/// Second pass: slots, faces, loads, gravity; works of the kick.
pub(crate) fn gather(world: &mut World, scratch: &mut Scratch) -> Result<(), NonFinite> {
    let (own, shared_out) = (scratch.own(world), scratch.share(world).is_some());
    let (bodies, turned) = (&world.bodies, world.turned.as_slice());
    let gathering = Gathering {
        bodies,
        turned,
        boundary: boundary::Context {
            poses: Poses { bodies, turned },
            boundaries: &world.setup.boundaries,
            in_situ: world.setup.in_situ.as_ref(),
            origin: world.setup.origin,
            reference: &world.reference,
            time: world.time,
            half: scratch.kick_halves(world),
            pending: world.pending,
        },
        kick: Kick {
            solids: &world.solids,
            solid: &world.solid,
            motion: &world.motion,
            reference: &world.reference,
            ..scratch.no_workspace(world)
        },
        tiles: &scratch.tiles,
        slots: &scratch.slots,
        pushes: &scratch.pushes,
        found: &scratch.desk,
        implicit: world.implicit.is_some(),
        // The work of implicit joints is booked block by block.
        plain: scratch.plain()
            && world.setup.air == 0.0
            && (world.implicit.is_none() || world.patches.is_empty()),
        width: scratch.width,
    };
    scratch.face_entries.clear();
    if !world.accounts.is_empty() && !scratch.tiles.conditioned(0..world.faces.len()).is_empty() {
        let none = FaceEntry::default();
        scratch.face_entries.resize(world.faces.len(), none);
    }
    let work = Second {
        tiles: &scratch.tiles.list,
        net: [scratch.net.whole(), scratch.drag.whole()],
        faces: &mut world.faces,
        entries: &mut scratch.face_entries,
        partial: &mut scratch.partial,
    };
    let count = scratch.tiles.list.len();
    let begun = Instant::now();
    scratch.exec.divided_own(work, count, own, |_, piece| gathering.tile(piece));
    let bad = match &mut scratch.share {
        Some(share) if shared_out => {
            share.book(begun.elapsed());
            let mut gathered = Gathered {
                sums: [&mut scratch.net, &mut scratch.drag],
                patches: &mut world.patches,
                faces: &mut world.faces,
                entries: &mut scratch.face_entries,
                partial: &mut scratch.partial,
            };
            share.sums(&scratch.tiles, &mut gathered)
        }
        _ => {
            let bad = scratch.partial.iter().find_map(|p| p.bad);
            sums::tree(&mut scratch.partial, Partial::add);
            bad
        }
    };
    let all = scratch.partial.first().copied().unwrap_or_default();
    world.works.add(&all.arrival);
    scratch.departure = all.departure;
    bad.map_or(Ok(()), |block| Err(NonFinite { block }))
}

struct Gathering<'a> {
    bodies: &'a Bodies,
    turned: &'a [Option<Box<Turned>>],
    boundary: boundary::Context<'a>,
    kick: Kick<'a>,
    tiles: &'a Tiles,
    slots: &'a [Sums; 2],
    pushes: &'a Pushes,
    /// What found contacts do to each block.
    found: &'a ContactScratch,
    /// Whether contacts are implicit ones, which book all their work together.
    implicit: bool,
    /// Whether blocks in rows need nothing but gravity and water.
    plain: bool,
    width: Width,
}

impl Gathering<'_> {
    fn tile(&self, mut work: Second) {
        let tile = &work.tiles[0];
        work.partial.fill(Partial::default());
        let base = tile.blocks.start;
        for (net, slots) in work.net.iter_mut().zip(self.slots) {
            if slots.is_empty() {
                continue;
            }
            for (list, slots) in net.0.iter_mut().zip(&slots.lists) {
                for run in &self.tiles.incoming[tile.incoming.clone()] {
                    let (at, slot) = (run.block as usize - base, run.slot as usize);
                    let count = run.count as usize;
                    for (sum, x) in list[at..at + count].iter_mut().zip(&slots[slot..slot + count])
                    {
                        *sum += x;
                    }
                }
            }
        }
        for row in &self.tiles.rows[tile.rows.clone()] {
            let partial = &mut work.partial[tile.group(row.blocks.start)];
            // With mass or local damping a change of velocity is no longer a factor times the force.
            if self.plain {
                let width = self.width;
                width.run(
                    #[inline(always)]
                    || self.row(row, base, &mut work.net, partial),
                );
            } else {
                for b in row.blocks.clone() {
                    let none = (&mut [][..], &mut [][..]);
                    self.block(b, base, none, &mut work.net, partial);
                }
            }
        }
        let conditioned = self.tiles.conditioned(tile.faces.clone()).iter();
        let mut conditioned = conditioned.map(|f| *f as usize - tile.faces.start).peekable();
        for &b in &self.tiles.special[tile.special.clone()] {
            while conditioned.next_if(|f| work.faces[*f].block < b).is_some() {}
            // From its first face with a condition to its last one: what lies between adds nothing.
            let mut of = 0..0;
            while let Some(face) = conditioned.next_if(|f| work.faces[*f].block == b) {
                of = if of.is_empty() { face } else { of.start }..face + 1;
            }
            let faces = &mut work.faces[of.clone()];
            let entries = work.entries.get_mut(of).unwrap_or_default();
            let partial = &mut work.partial[tile.group(b as usize)];
            let faces = (faces, entries);
            self.block(b as usize, base, faces, &mut work.net, partial);
        }
    }

    /// Gravity, the pushes of water and their works for a row of free blocks.
    #[inline(always)]
    fn row(&self, row: &Row, base: usize, net: &mut [Part; 2], partial: &mut Partial) {
        let solid = &self.kick.solids[row.solid as usize];
        let here = row.blocks.start - base..row.blocks.end - base;
        let [net, drag] = net;
        let damped = !drag.0[0].is_empty();
        let [before, after] = self.kick.half;
        let rates = &self.bodies.velocity;
        let change = self.kick.span / solid.mass;
        let mut sum = Lanes::default();
        let loads = match self.pushes.wet {
            true => &self.pushes.loads.blocks[row.blocks.clone()],
            false => &[],
        };
        for (k, rates) in rates.iter().take(3).enumerate() {
            let weight = solid.mass * self.kick.gravity[k];
            let list = &mut net.0[k][here.clone()];
            if !loads.is_empty() {
                // With the weight in one sum, as in `block`.
                for (f, load) in list.iter_mut().zip(loads) {
                    *f += weight + load.force[k];
                }
            }
            if weight != 0.0 {
                let add = if loads.is_empty() { weight } else { 0.0 };
                let v = &rates[row.blocks.clone()];
                let (mut early, mut late) = (Lanes::default(), Lanes::default());
                let chunks = list.chunks_mut(LANES).zip(v.chunks(LANES));
                for (at, (f, v)) in chunks.enumerate() {
                    for (l, (f, v)) in f.iter_mut().zip(v).enumerate() {
                        *f += add;
                        let at = here.start + LANES * at + l;
                        let push = if damped { *f + drag.0[k][at] } else { *f };
                        early.0[l] += v;
                        late.0[l] += v + change * push;
                    }
                }
                partial.arrival.gravity += before * weight * early.sum();
                partial.departure.gravity += after * weight * late.sum();
            }
        }
        if !loads.is_empty() {
            self.row_loads(row, base, (loads, solid), net, drag, partial);
        }
        for list in net.0.iter().chain(&drag.0) {
            if list.is_empty() {
                continue;
            }
            for chunk in list[here.clone()].chunks(LANES) {
                for (s, x) in sum.0.iter_mut().zip(chunk) {
                    // Nil for what is finite, else not a number.
                    *s += 0.0 * x;
                }
            }
        }
        if damped {
            self.row_drag(row, base, net, drag, partial);
        }
        // Only what is not a number differs from zero here: one test for a whole row.
        if sum.sum() != 0.0 && partial.bad.is_none() {
            let finite = |b: usize| {
                let (force, moment) = net.get(b - base);
                (force + moment).is_finite()
            };
            let bad = row.blocks.clone().find(|b| !finite(*b));
            partial.bad = Some(bad.unwrap_or(row.blocks.start) as u32);
        }
    }

    /// Moments of the pushes of water on a row of free blocks, and the works of both.
    #[inline(always)]
    fn row_loads(
        &self,
        row: &Row,
        base: usize,
        (loads, solid): (&[Wrench], &SolidClass),
        net: &mut Part,
        drag: &Part,
        partial: &mut Partial,
    ) {
        let here = row.blocks.start - base..row.blocks.end - base;
        let [before, after] = self.kick.half;
        for k in 0..6 {
            // In rows tensors of inertia are diagonal (`Tiles::make_rows`), so that each freedom has its own.
            let ease = match k {
                0..3 => 1.0 / solid.mass,
                _ => solid.inverse.col(k - 3)[k - 3],
            };
            let change = self.kick.span * ease;
            let push = |load: &Wrench| match k {
                0..3 => load.force[k],
                _ => load.moment[k - 3],
            };
            let list = &mut net.0[k][here.clone()];
            if k >= 3 {
                for (f, load) in list.iter_mut().zip(loads) {
                    *f += push(load);
                }
            }
            let v = &self.bodies.velocity[k][row.blocks.clone()];
            let (mut early, mut late) = (0.0, 0.0);
            for (at, ((f, v), load)) in list.iter().zip(v).zip(loads).enumerate() {
                let all = match drag.0[k].get(here.start + at) {
                    Some(d) => f + d,
                    None => *f,
                };
                early += push(load) * v;
                late += push(load) * (v + change * all);
            }
            partial.arrival.loads += before * early;
            partial.departure.loads += after * late;
        }
    }

    /// Works of dashpots on a row of free blocks.
    #[inline(always)]
    fn row_drag(&self, row: &Row, base: usize, net: &Part, drag: &Part, partial: &mut Partial) {
        let solid = &self.kick.solids[row.solid as usize];
        let [before, after] = self.kick.half;
        for k in 0..6 {
            let ease = if k < 3 { 1.0 / solid.mass } else { solid.inverse.col(k - 3)[k - 3] };
            let change = self.kick.span * ease;
            let here = row.blocks.start - base..row.blocks.end - base;
            let v = self.bodies.velocity[k][row.blocks.clone()].chunks(LANES);
            let (f, d) = (&net.0[k][here.clone()], &drag.0[k][here]);
            let (mut early, mut late) = (Lanes::default(), Lanes::default());
            for ((v, f), d) in v.zip(f.chunks(LANES)).zip(d.chunks(LANES)) {
                for (l, ((v, f), d)) in v.iter().zip(f).zip(d).enumerate() {
                    early.0[l] += d * v;
                    late.0[l] += d * (v + change * (f + d));
                }
            }
            partial.arrival.damping -= before * early.sum();
            partial.departure.damping -= after * late.sum();
        }
    }

    /// All that can act on a block, and its works. `entries` of the faces are empty where nobody keeps accounts.
    fn block(
        &self,
        b: usize,
        base: usize,
        (faces, entries): (&mut [Face], &mut [FaceEntry]),
        net: &mut [Part; 2],
        partial: &mut Partial,
    ) {
        let mut load = self.pushes.loads.blocks.get(b).copied().unwrap_or_default();
        let mut dashpots = None;
        // Works of `load` are booked here as those of loads; writers of `own` have booked what theirs do.
        let mut other = self.pushes.own.blocks.get(b).copied().unwrap_or_default();
        for (k, face) in faces.iter_mut().enumerate() {
            let pushes = match self.implicit {
                // Springs and dashpots are among what the step has found.
                true => FaceForces { dead: self.boundary.given(face), ..FaceForces::default() },
                false => self.boundary.act(face, &mut partial.arrival, &mut dashpots),
            };
            if let Some(entry) = entries.get_mut(k) {
                entry.dead = pushes.dead;
                entry.halves[0] = pushes.booked;
            }
            for (sum, push) in [(&mut other, pushes.spring), (&mut load, pushes.dead)] {
                sum.force += push.force;
                sum.moment += push.moment;
            }
        }
        let weight = self.kick.solid_of(b).mass * self.kick.gravity;
        let (force, moment) = net[0].get(b - base);
        let joined = Share { force, moment };
        net[0].add(b - base, weight + load.force + other.force, load.moment + other.moment);
        let found = self.found.on_block(b);
        if let Some(found) = &found {
            for share in [&found.elastic, &found.spring] {
                net[0].add(b - base, share.force, share.moment);
            }
            // Apart, since the kick books what drag does as damping.
            if !net[1].0[0].is_empty() {
                net[1].add(b - base, found.drag.force, found.drag.moment);
            }
        }
        let moving = Moving {
            velocity: self.bodies.velocity(b),
            spin: self.bodies.spin(b),
            turned: self.turned[b].as_deref(),
        };
        let (v, w) = (moving.velocity, moving.spin);
        // Implicit in the mean of the velocities before and after: it needs all other forces first.
        let mean = dashpots.map(|d| {
            let (force, moment) = net[0].get(b - base);
            let acting = Wrench { force, moment };
            d.mean(self.kick.solid_of(b), [v, w], &acting, self.kick.span)
        });
        let dashpot = dashpots.zip(mean).map(|(d, mean)| d.push(&mean));
        if let Some(dashpot) = &dashpot {
            // Not into the drag: its work is booked as absorbed, below, and would be once more as damping.
            net[0].add(b - base, dashpot.force, dashpot.moment);
        }
        let acting = acting(net, b - base);
        let all = acting.force + acting.moment + acting.drag + acting.drag_moment;
        if !all.is_finite() && partial.bad.is_none() {
            partial.bad = Some(b as u32);
        }
        let (arrival, departure) = (&mut partial.arrival, &mut partial.departure);
        let loads = (load.force, load.moment);
        let change = self.kick.works(b, &moving, &acting, loads, arrival, departure);
        if found.is_some() || self.implicit {
            let [before, after] = self.kick.half;
            let found = found.unwrap_or_default();
            let mut pressing = found.elastic;
            if self.implicit {
                pressing.plus(&found.spring);
                pressing.plus(&joined);
            }
            let power = |v: Vec3, w: Vec3| pressing.force.dot(v) + pressing.moment.dot(w);
            // What the pressure stores is what has been done against it, hence the sign.
            arrival.contact_path -= before * power(v, w);
            departure.contact_path -= after * power(v + change.velocity, w + change.spin);
        }
        if let Some(dashpot) = &dashpot {
            let [before, after] = self.kick.half;
            arrival.absorbed -= before * dashpot.power(v, w);
            departure.absorbed -= after * dashpot.power(v + change.velocity, w + change.spin);
        }
        let rates = [(v, w), (v + change.velocity, w + change.spin)];
        for (face, entry) in faces.iter().zip(entries) {
            let halves = self.kick.half.into_iter().zip(rates);
            let dashpot = mean.and_then(|mean| Some(self.boundary.dashpots(face)?.push(&mean)));
            for (account, (half, (v, w))) in entry.halves.iter_mut().zip(halves) {
                account.loads += half * entry.dead.power(v, w);
                if let Some(dashpot) = &dashpot {
                    account.absorbed -= half * dashpot.power(v, w);
                }
            }
        }
    }
}

/// Forces on entry `at` of the sums.
pub(crate) fn acting(net: &[Part; 2], at: usize) -> Acting {
    let (force, moment) = net[0].get(at);
    let (drag, drag_moment) =
        if net[1].0[0].is_empty() { (Vec3::ZERO, Vec3::ZERO) } else { net[1].get(at) };
    Acting { force, moment, drag, drag_moment }
}
