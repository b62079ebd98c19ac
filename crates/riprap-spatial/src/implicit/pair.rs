//! A pair of blocks as a term of the implicit step: the pressure of its pieces, and friction with memory.

#![expect(clippy::needless_range_loop, reason = "indices are rows and columns of several matrices")]

use riprap_geom::Vec3;

use crate::implicit::hold::Hold;
use crate::implicit::joint::Joint;
use crate::implicit::patch::{
    Basis, Normal, Piece, Pressed, Stepping, Twist, dot, normal_part, whole,
};
use crate::kernel::ContactLaw;
use crate::setup::rotation::rotation;

/// What friction is computed from: the pressure of the last solution.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Pressure {
    /// Normal force, N.
    pub force: f64,
    /// Where it acts, from the origin of the pair, m.
    pub centre: Vec3,
    /// Wet area across the direction of the pair, m².
    pub area: f64,
    /// Mean radius of friction against spinning, m.
    pub radius: f64,
}

/// Mean arm of friction over the radius of gyration of the area.
const ARM: f64 = 0.93;

/// Stiffness of an impact over that of a mass in the step: the rebound is as given but for the inverse of it.
const RIGID: f64 = 1e4;

/// Halvings in which a hidden pressure is found.
const HALVINGS: usize = 50;

/// One pair in a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pair {
    /// Which patch of the two it is.
    pub key: [u32; 2],
    /// Places of both blocks among those that move; `None` for one that does not answer.
    pub ends: [Option<u32>; 2],
    /// From the origin of the pair to the centroids, m.
    pub centres: [Vec3; 2],
    /// Motion of the blocks that do not answer: velocity and spin.
    pub given: [[Vec3; 2]; 2],
    /// Unit vector from the first to the second.
    pub direction: Vec3,
    /// Two unit vectors across it.
    pub across: [Vec3; 2],
    pub pieces: Vec<Piece>,
    /// Corners of all pieces, m.
    pub corners: Vec<[f64; 2]>,
    pub law: ContactLaw,
    /// Shear force (N) on the second block and torsion (N m) of the step before.
    pub shear: Vec3,
    pub torsion: f64,
    /// That of the last solution.
    pub pressure: Pressure,
    /// Wet area of the step before, m².
    pub area_before: f64,
    /// What its pieces have been relieved of, Pa: see [`crate::implicit::memory::Kept::hidden`].
    pub hidden: f64,
    /// Whether it rebounds in this step.
    pub strikes: bool,
    /// The joint that ties the blocks, in place of the pieces of a contact.
    pub joint: Option<Box<Joint>>,
    /// What holds the second block from outside, in their place.
    pub hold: Option<Box<Hold>>,
}

/// What a pair answers at a twist.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Answer {
    /// Whether there is any.
    pub acts: bool,
    /// Wrench on the second block about the origin: N and N m.
    pub wrench: Twist,
    /// Rate of the impulse against the twist, kg and so on.
    pub rate: [Twist; 6],
}

/// What a pair has done in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Reply {
    /// Wrenches of pressure and friction on the second block about the origin, N and N m.
    pub elastic: Twist,
    pub spring: Twist,
    /// Friction on the second block, N, and its torsion, N m.
    pub shear: Vec3,
    pub torsion: f64,
    pub sliding: bool,
    /// Heat of friction, J.
    pub heat: f64,
    /// How far the blocks lie in each other at the end of the step, m.
    pub depth: f64,
}

/// Friction at a twist.
struct Rubbing {
    screws: [Twist; 3],
    /// Trial forces: two along the surface, one against spinning over its arm, N.
    trial: [f64; 3],
    /// Most that it can carry, N.
    limit: f64,
    /// Stiffness, N/m.
    stiffness: f64,
}

impl Rubbing {
    fn size(&self) -> f64 {
        let [a, b, c] = self.trial;
        (a * a + b * b + c * c).sqrt()
    }

    /// Share of the trial forces that is carried.
    fn share(&self) -> f64 {
        let size = self.size();
        if size > self.limit { self.limit / size } else { 1.0 }
    }
}

impl Pair {
    /// What is known of it from the step before: friction is turned into its surface, and lost with the area that it has lost.
    pub(crate) fn recall(&mut self, shear: Vec3, torsion: f64, pressure: Pressure) {
        self.shear = shear - shear.dot(self.direction) * self.direction;
        self.torsion = torsion;
        self.pressure = pressure;
        self.area_before = pressure.area;
    }

    /// Takes a pressure off all of it, no more than its deepest point has: `hidden` (Pa), or so much that the normal force at rest is `due` (N) where
    /// it would be larger.
    pub(crate) fn hide(&mut self, hidden: f64, due: Option<f64>, spare: &mut Vec<[f64; 2]>) {
        let most = |piece: &Piece| piece.most(&self.corners, piece.at_rest());
        let deepest = self.pieces.iter().map(most).fold(0.0, f64::max);
        let mut force = |hidden: f64| -> f64 {
            let at_rest = Stepping { span: 0.0, dt: 0.0 };
            let of = |piece: &Piece| {
                let piece = piece.relieved(hidden);
                piece.press(&self.corners, &Normal::default(), &at_rest, 1.0, spare).load[0]
            };
            self.pieces.iter().map(of).sum()
        };
        self.hidden = match due {
            None => hidden.min(deepest),
            Some(due) if force(0.0) <= due => 0.0,
            // The force falls with what is hidden: halved to the last bit but a few.
            Some(due) => {
                let halve = |[low, high]: [f64; 2], _| {
                    let middle = 0.5 * (low + high);
                    if force(middle) > due { [middle, high] } else { [low, middle] }
                };
                (0..HALVINGS).fold([0.0, deepest], halve)[1]
            }
        };
        for piece in &mut self.pieces {
            *piece = piece.relieved(self.hidden);
        }
    }

    /// Corrects the springs along it for the way that turning blocks have gone in the step before, beyond that at the velocities of its start:
    /// what sticks to a block that turns stays on its circle. `turned` are the turns of the blocks in that step (rad), `arms` from their
    /// centroids to the pressure centre at its start (m).
    pub(crate) fn follow(&mut self, turned: [Vec3; 2], arms: [Vec3; 2]) {
        let beyond = |side: usize| {
            let (turn, arm) = (turned[side], arms[side]);
            if turn == Vec3::ZERO {
                return Vec3::ZERO;
            }
            rotation(turn) * arm - arm - turn.cross(arm)
        };
        let way = beyond(1) - beyond(0);
        let along = way - way.dot(self.direction) * self.direction;
        self.shear -= self.law.shear_stiffness * self.area_before * along;
    }

    /// How fast the blocks come nearer to each other at the pressure centre, m/s.
    pub(crate) fn approach(&self, twist: &Twist) -> f64 {
        let [x, y, z, p, q, r] = *twist;
        let at_centre = Vec3::new(x, y, z) + Vec3::new(p, q, r).cross(self.pressure.centre);
        -at_centre.dot(self.direction)
    }

    /// Makes it an impact: where the pieces press in the solution `end`, points leave each other with a share of the speed at which they approach in
    /// `start`, whatever the depth. `mass` (kg) is that of the lighter block.
    pub(crate) fn strike(
        &mut self,
        end: &Twist,
        start: &Twist,
        mass: f64,
        step: &Stepping,
        spare: &mut Vec<[f64; 2]>,
    ) {
        let stiffness = self.law.normal_stiffness * self.pressure.area;
        let harder = (RIGID * mass / (step.dt * step.span * stiffness)).max(1.0);
        let basis = self.basis();
        let twists = [normal_part(&basis, end), normal_part(&basis, start)];
        for piece in &mut self.pieces {
            piece.strike(&mut self.corners, twists, self.law.rebound, harder, step, spare);
        }
        self.strikes = true;
    }

    fn rubbing(&self, twist: &Twist, step: &Stepping, soft: f64) -> Option<Rubbing> {
        let p = &self.pressure;
        let stiffness = soft * self.law.shear_stiffness * p.area;
        let limit = self.law.friction * p.force + self.law.cohesion * p.area;
        if stiffness <= 0.0 || limit <= 0.0 {
            return None;
        }
        let along = |direction: Vec3| {
            let turn = p.centre.cross(direction);
            [direction.x, direction.y, direction.z, turn.x, turn.y, turn.z]
        };
        let spin = p.radius * self.direction;
        let screws =
            [along(self.across[0]), along(self.across[1]), [0.0, 0.0, 0.0, spin.x, spin.y, spin.z]];
        let before = [
            self.shear.dot(self.across[0]),
            self.shear.dot(self.across[1]),
            if p.radius > 0.0 { self.torsion / p.radius } else { 0.0 },
        ];
        let mut trial = before;
        for (y, screw) in trial.iter_mut().zip(&screws) {
            *y -= step.dt * stiffness * dot(screw, twist);
        }
        Some(Rubbing { screws, trial, limit, stiffness })
    }

    /// Energy in its pressure where nothing moves, J.
    pub(crate) fn stored(&self, spare: &mut Vec<[f64; 2]>) -> f64 {
        self.pieces.iter().map(|piece| piece.stored(&self.corners, spare)).sum()
    }

    /// What it has done in a step that ends with this twist.
    pub(crate) fn reply(&self, twist: &Twist, step: &Stepping, spare: &mut Vec<[f64; 2]>) -> Reply {
        let mut reply = Reply::default();
        if let Some(answer) = self.tied(twist, step, 1.0, false) {
            reply.elastic = answer.wrench;
            return reply;
        }
        let (basis, mut elastic) = (self.basis(), Normal::default());
        let part = normal_part(&basis, twist);
        for piece in &self.pieces {
            let pressed = piece.press(&self.corners, &part, step, 1.0, spare);
            piece.add_wrench(&pressed, &mut elastic);
            let most = piece.most(&self.corners, &pressed.pressure);
            if most > 0.0 {
                reply.depth = reply.depth.max((most + self.hidden) / self.law.normal_stiffness);
            }
        }
        reply.elastic = whole(&basis, elastic);
        if self.strikes {
            // Its pressure is that of an impulse.
            reply.depth = 0.0;
        }
        let Some(rubbing) = self.rubbing(twist, step, 1.0) else {
            return reply;
        };
        let (share, size) = (rubbing.share(), rubbing.size());
        for (y, screw) in rubbing.trial.iter().zip(&rubbing.screws) {
            for k in 0..6 {
                reply.spring[k] += share * y * screw[k];
            }
        }
        reply.sliding = share < 1.0;
        reply.heat = share * (1.0 - share) * size * size / rubbing.stiffness;
        let [a, b, c] = rubbing.trial.map(|y| share * y);
        reply.shear = a * self.across[0] + b * self.across[1];
        reply.torsion = c * self.pressure.radius;
        reply
    }

    /// What is left of friction where the wet area has become `area` (m²): what has parted carries nothing.
    pub(crate) fn left(&self, area: f64) -> f64 {
        if self.area_before > 0.0 { (area / self.area_before).min(1.0) } else { 1.0 }
    }

    pub(crate) fn basis(&self) -> Basis {
        [self.direction, self.across[0], self.across[1]]
    }

    /// That of the pressure alone.
    fn pressing(
        &self,
        twist: &Twist,
        step: &Stepping,
        soft: f64,
        with_rate: bool,
        spare: &mut Vec<[f64; 2]>,
    ) -> Answer {
        let mut answer = Answer::default();
        let (mut wrench, mut rate) = (Normal::default(), [Normal::default(); 3]);
        let basis = self.basis();
        let part = normal_part(&basis, twist);
        for piece in &self.pieces {
            let pressed = piece.press(&self.corners, &part, step, soft, spare);
            if pressed.is_dry() {
                continue;
            }
            answer.acts = true;
            piece.add_wrench(&pressed, &mut wrench);
            if with_rate {
                piece.add_rate(&pressed, step, soft, &mut rate);
            }
        }
        if answer.acts {
            answer.wrench = whole(&basis, wrench);
            if with_rate {
                // By columns, then by rows.
                let columns = rate.map(|row| whole(&basis, row));
                for k in 0..6 {
                    let rows = whole(&basis, columns.map(|column| column[k]));
                    for i in 0..6 {
                        answer.rate[i][k] = rows[i];
                    }
                }
            }
        }
        answer
    }

    /// That of a joint, or of what holds a block from outside.
    fn tied(&self, twist: &Twist, step: &Stepping, soft: f64, with_rate: bool) -> Option<Answer> {
        let mut answer = Answer::default();
        if let Some(joint) = &self.joint {
            joint.add(twist, step, soft, with_rate, &mut answer);
        } else {
            self.hold.as_ref()?.add(twist, step, soft, with_rate, &mut answer);
        }
        Some(answer)
    }

    /// Force and, where asked for, its rate.
    pub(crate) fn answer(
        &self,
        twist: &Twist,
        step: &Stepping,
        soft: f64,
        with_rate: bool,
        spare: &mut Vec<[f64; 2]>,
    ) -> Answer {
        if let Some(answer) = self.tied(twist, step, soft, with_rate) {
            return answer;
        }
        let mut answer = self.pressing(twist, step, soft, with_rate, spare);
        let Some(rubbing) = self.rubbing(twist, step, soft) else {
            return answer;
        };
        answer.acts = true;
        let share = rubbing.share();
        for (y, screw) in rubbing.trial.iter().zip(&rubbing.screws) {
            for k in 0..6 {
                answer.wrench[k] += share * y * screw[k];
            }
        }
        if with_rate {
            let scale = step.span * step.dt * rubbing.stiffness * share;
            let size = rubbing.size();
            let unit = rubbing.trial.map(|y| if share < 1.0 { y / size } else { 0.0 });
            for a in 0..3 {
                let mut row = [0.0; 6];
                for b in 0..3 {
                    let along = f64::from(u8::from(a == b)) - unit[a] * unit[b];
                    for k in 0..6 {
                        row[k] += scale * along * rubbing.screws[b][k];
                    }
                }
                for i in 0..6 {
                    for k in 0..6 {
                        answer.rate[i][k] += rubbing.screws[a][i] * row[k];
                    }
                }
            }
        }
        answer
    }

    /// The pressure at a twist, for the friction of the next solution.
    pub(crate) fn pressure_at(
        &self,
        twist: &Twist,
        step: &Stepping,
        spare: &mut Vec<[f64; 2]>,
    ) -> Pressure {
        let mut found = Pressure::default();
        let (mut first, mut second, mut area_first) = (Vec3::ZERO, 0.0, Vec3::ZERO);
        let twist = normal_part(&self.basis(), twist);
        for piece in &self.pieces {
            let pressed = piece.press(&self.corners, &twist, step, 1.0, spare);
            let part = piece.shares(&pressed);
            found.force += part.force;
            first += part.force_first;
            found.area += part.area;
            area_first += part.area_first;
            second += part.area_second;
        }
        if found.force > 0.0 {
            found.centre = first / found.force;
        }
        if found.area > 0.0 {
            let middle = area_first / found.area;
            let gyration = (second / found.area - middle.length_squared()).max(0.0);
            found.radius = ARM * gyration.sqrt();
        }
        found
    }
}

/// What a piece adds to the pressure of its pair.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shares {
    pub force: f64,
    pub force_first: Vec3,
    pub area: f64,
    pub area_first: Vec3,
    pub area_second: f64,
}

impl Piece {
    fn shares(&self, pressed: &Pressed) -> Shares {
        let [foot, u, v] = self.frame();
        let [p, pu, pv] = pressed.load;
        let [a, au, av, auu, _, avv] = pressed.moments.scaled(self.weight());
        // Axes are unit vectors across each other.
        let square =
            a * foot.length_squared() + 2.0 * (au * foot.dot(u) + av * foot.dot(v)) + auu + avv;
        Shares {
            force: p,
            force_first: p * foot + pu * u + pv * v,
            area: a,
            area_first: a * foot + au * u + av * v,
            area_second: square,
        }
    }
}
