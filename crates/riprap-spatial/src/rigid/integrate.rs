//! The kick applied and the blocks moved.

use std::time::Instant;

use crate::exec::Divide;
use crate::joint::patch;
use crate::lanes::{LANES, Lanes, Width};
use crate::rigid::bound::Bound;
use crate::rigid::gather::acting;
use crate::rigid::kick;
use crate::rigid::kick::Kick;
use crate::setup::Kinematics;
use crate::setup::rotation::rotation_vector;
use crate::state::bodies::Turned;
use crate::state::scratch::{Partial, Scratch};
use crate::state::sums::Part;
use crate::state::tiles::{GROUP, Row, Tile, Tiles};
use crate::state::world::World;
use riprap_core::cut;

/// Piece of work of the integration.
struct Piece<'a> {
    tiles: &'a [Tile],
    net: [Part<'a>; 2],
    displacement: Part<'a>,
    velocity: Part<'a>,
    turned: &'a mut [Option<Box<Turned>>],
    peak: &'a mut [f64],
    partial: &'a mut [Partial],
}

impl Divide for Piece<'_> {
    fn divide(self, middle: usize) -> (Self, Self) {
        let blocks = self.tiles[middle].blocks.start - self.tiles[0].blocks.start;
        cut!(
            self,
            tiles: middle,
            net: blocks,
            displacement: blocks,
            velocity: blocks,
            turned: blocks,
            peak: blocks,
            partial: blocks / GROUP,
        )
    }
}

pub(crate) fn integrate(world: &mut World, scratch: &mut Scratch, dt: f64) {
    let own = scratch.own(world);
    let plain = scratch.plain() && world.setup.air == 0.0;
    let moving = Integration {
        kick: Kick {
            solids: &world.solids,
            solid: &world.solid,
            motion: &world.motion,
            reference: &world.reference,
            ..scratch.no_workspace(world)
        },
        tiles: &scratch.tiles,
        dt,
        bound: match world.setup.kinematics {
            Kinematics::Automatic => {
                let bound = world.setup.rotation_bound();
                bound * bound
            }
            // Small: nobody ever changes over; finite: all have at the first evaluation.
            Kinematics::Small | Kinematics::Finite => f64::INFINITY,
        },
        plain,
        width: scratch.width,
    };
    let work = Piece {
        tiles: &scratch.tiles.list,
        net: [scratch.net.whole(), scratch.drag.whole()],
        displacement: Part(world.bodies.displacement.each_mut().map(Vec::as_mut_slice)),
        velocity: Part(world.bodies.velocity.each_mut().map(Vec::as_mut_slice)),
        turned: &mut world.turned,
        peak: &mut world.peak_speed_squared,
        partial: &mut scratch.partial,
    };
    let count = scratch.tiles.list.len();
    let begun = Instant::now();
    scratch.exec.divided_own(work, count, own.clone(), |_, piece| moving.tile(piece));
    let spent = begun.elapsed();
    // One entry of each piece says whether anyone in it has turned that far.
    let first = |tile: &Tile| scratch.partial[tile.blocks.start / GROUP].turning;
    let turning = scratch.tiles.list[own].iter().any(first);
    let turning = match &mut scratch.share {
        Some(share) if world.implicit.is_none() => {
            share.book(spent);
            let sums = [&mut scratch.net, &mut scratch.drag];
            share.motion(&scratch.tiles, world, sums, (dt, turning))
        }
        _ => turning,
    };
    // Stays set until an evaluation takes it.
    scratch.turning |= turning;
}

struct Integration<'a> {
    kick: Kick<'a>,
    tiles: &'a Tiles,
    dt: f64,
    /// Square of the angle at which a block changes over to finite rotations.
    bound: f64,
    plain: bool,
    width: Width,
}

impl Integration<'_> {
    fn tile(&self, mut work: Piece) {
        let tile = work.tiles[0].clone();
        // One entry stands for the piece: it is asked only whether anyone has turned that far.
        work.partial[0].turning = false;
        for row in &self.tiles.rows[tile.rows] {
            if self.plain {
                let width = self.width;
                width.run(
                    #[inline(always)]
                    || self.row(row, tile.blocks.start, &mut work),
                );
            } else {
                for b in row.blocks.clone() {
                    self.block(b, tile.blocks.start, &mut work);
                }
            }
        }
        for &b in &self.tiles.special[tile.special] {
            self.block(b as usize, tile.blocks.start, &mut work);
        }
    }

    /// Kicks and moves a row of free blocks.
    #[inline(always)]
    fn row(&self, row: &Row, base: usize, work: &mut Piece) {
        let solid = &self.kick.solids[row.solid as usize];
        let here = row.blocks.start - base..row.blocks.end - base;
        let dt = self.dt;
        let damped = !work.net[1].0[0].is_empty();
        for k in 0..6 {
            // Tensors of inertia are diagonal in rows, and momentum and spin differ by a factor.
            let ease = if k < 3 { 1.0 / solid.mass } else { solid.inverse.col(k - 3)[k - 3] };
            let change = self.kick.span * ease;
            let v = &mut work.velocity.0[k][here.clone()];
            let u = &mut work.displacement.0[k][here.clone()];
            let f = &work.net[0].0[k][here.clone()];
            if damped {
                let d = &work.net[1].0[k][here.clone()];
                for (((v, u), f), d) in v.iter_mut().zip(u).zip(f).zip(d) {
                    *v += change * (f + d);
                    // With the new velocity, that of the middle of this step: this is what makes it a leapfrog.
                    *u += dt * *v;
                }
            } else {
                for ((v, u), f) in v.iter_mut().zip(u).zip(f) {
                    *v += change * f;
                    *u += dt * *v;
                }
            }
        }
        let [x, y, z, ..] = &work.velocity.0;
        let speeds = x[here.clone()].iter().zip(&y[here.clone()]).zip(&z[here.clone()]);
        for (peak, ((x, y), z)) in work.peak[here.clone()].iter_mut().zip(speeds) {
            let square = x * x + y * y + z * z;
            // Written out, and not as `max`, so that it is one instruction of the vector
            // unit: `max` must look for what is not a number.
            *peak = if square > *peak { square } else { *peak };
        }
        let [.., a, b, c] = &work.displacement.0;
        let mut most = Lanes::default();
        let angles = a[here.clone()]
            .chunks(LANES)
            .zip(b[here.clone()].chunks(LANES))
            .zip(c[here].chunks(LANES));
        for ((a, b), c) in angles {
            for (l, ((a, b), c)) in a.iter().zip(b).zip(c).enumerate() {
                let square = a * a + b * b + c * c;
                most.0[l] = if square > most.0[l] { square } else { most.0[l] };
            }
        }
        work.partial[0].turning |= most.0.into_iter().any(|m| m > self.bound);
    }

    /// Kicks and moves any block.
    fn block(&self, b: usize, base: usize, work: &mut Piece) {
        let at = b - base;
        let (mut v, mut w) = work.velocity.get(at);
        let moving = kick::Moving { velocity: v, spin: w, turned: work.turned[at].as_deref() };
        let change = self.kick.change(b, &moving, &acting(&work.net, at));
        v += change.velocity;
        let (mut u, mut th) = work.displacement.get(at);
        u += self.dt * v;
        if let Some(turned) = &mut work.turned[at] {
            let solid = self.kick.solid_of(b);
            let motion = self.kick.motion[b].as_deref();
            let inertia = || patch::turned_inertia(&solid.inertia, turned.attitude);
            let bound = motion.and_then(|motion| {
                let inertia = inertia();
                Some((Bound::of(motion, inertia)?, inertia))
            });
            // The spin that is kept is that on the way, of the middle of the step as all velocities are.
            match bound {
                Some((bound, inertia)) => {
                    let spin = bound.spin(w, turned.momentum) + change.spin;
                    turned.momentum = inertia * spin;
                    (turned.attitude, w) =
                        bound.turn(turned.attitude, spin, turned.momentum, &solid.inertia, self.dt);
                }
                None => {
                    turned.momentum += change.momentum;
                    (turned.attitude, w) =
                        kick::turn(turned.attitude, turned.momentum, &solid.inverse, self.dt);
                }
            }
            th = rotation_vector(turned.attitude);
        } else {
            w += change.spin;
            th += self.dt * w;
            work.partial[0].turning |= th.length_squared() > self.bound;
        }
        work.velocity.set(at, v, w);
        work.displacement.set(at, u, th);
        work.peak[at] = work.peak[at].max(v.length_squared());
    }
}
