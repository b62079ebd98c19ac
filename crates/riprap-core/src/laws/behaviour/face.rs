//! A face whose four points fail together.

use super::super::face_joint::{SIGNS, Sums};
use super::{BEYOND, Law, Loss, Memory, Traction, divided, lost};

impl Law<'_> {
    /// Mean slip of the points of a face, m.
    fn mean_slip(memory: &[Memory; 4]) -> [f64; 2] {
        [0, 1].map(|k| 0.25 * memory.iter().map(|m| m.slip[k]).sum::<f64>())
    }

    /// Tractions of a face with the memory that its points have, and their openings.
    fn looks(
        &self,
        start: &[Traction; 4],
        at: &[[f64; 3]; 4],
        memory: &[Memory; 4],
    ) -> [(f64, Traction); 4] {
        let dilated = self.dilated(Self::mean_slip(memory), &memory[0]);
        std::array::from_fn(|p| {
            // An open point of a face that slides carries its share of the shear.
            let m = Memory { open: false, ..memory[p] };
            let (w, mut t) = self.look(&start[p], &at[p], &m, dilated);
            if memory[p].open {
                t[0] = 0.0;
            }
            (w, t)
        })
    }

    /// Tractions of a face with the memory that its points have.
    #[must_use]
    pub fn carried_face(
        &self,
        start: &[Traction; 4],
        at: &[[f64; 3]; 4],
        memory: &[Memory; 4],
    ) -> [Traction; 4] {
        self.looks(start, at, memory).map(|(_, t)| t)
    }

    /// Openings of the points of a face, m; negative where they are closed.
    #[must_use]
    pub fn openings_of_face(
        &self,
        start: &[Traction; 4],
        at: &[[f64; 3]; 4],
        memory: &[Memory; 4],
    ) -> [f64; 4] {
        self.looks(start, at, memory).map(|(w, _)| w)
    }

    /// Energy of each point of a face in the normal and in the shear spring, J/m².
    #[must_use]
    pub fn energy_of_face(
        &self,
        start: &[Traction; 4],
        at: &[[f64; 3]; 4],
        memory: &[Memory; 4],
    ) -> [[f64; 2]; 4] {
        self.looks(start, at, memory).map(|(w, t)| self.parts(w, &t))
    }

    /// A face that fails as one: by the mean traction of its points and by its torsion moment, as [`super::super::face_joint::face`].
    ///
    /// Dilation and the slip that weakens are those of the whole face. `half_spacing` are the places of the points along b and c, m.
    #[must_use]
    pub fn face(
        &self,
        start: &[Traction; 4],
        at: &[[f64; 3]; 4],
        moved: &[[f64; 3]; 4],
        half_spacing: [f64; 2],
        memory: &mut [Memory; 4],
    ) -> ([Traction; 4], Loss) {
        let old = std::array::from_fn(|p| std::array::from_fn(|k| at[p][k] - moved[p][k]));
        let was_open = memory.iter().all(|m| m.open);
        let before = self
            .looks(start, &old, memory)
            .map(|(w, t)| if was_open { ([0.0; 3], 0.0) } else { (t, self.stored(w, &t)) });
        let account = |now: &[(f64, Traction); 4]| {
            (0..4)
                .map(|p| {
                    let (w, t) = &now[p];
                    let w = if t[0] == 0.0 { 0.0 } else { *w };
                    // A loss is per area: each point stands for a quarter of the face.
                    0.25 * lost((&before[p].0, before[p].1), (t, self.stored(w, t)), &moved[p])
                })
                .sum::<f64>()
        };
        let (whole, parted) = (!memory[0].broken, memory[0].parted);
        for p in 0..4 {
            memory[p].sliding = false;
            memory[p].open = false;
            if was_open {
                self.start_anew(&start[p], &at[p], &moved[p], &mut memory[p]);
            }
        }
        let slip = Self::mean_slip(memory);
        let dilated = self.dilated(slip, &memory[0]);
        let base: [f64; 4] = std::array::from_fn(|p| self.base(&start[p], &at[p], &memory[p]));
        let mean = 0.25 * base.iter().sum::<f64>() - dilated;
        // All points have one damage.
        let mut one = memory[0];
        self.part(mean, &mut one);
        let trial: [[f64; 2]; 4] =
            std::array::from_fn(|p| self.shear(&start[p], &at[p], &memory[p]));
        let sums = Sums::of(&trial.map(|[b, c]| [0.0, b, c]), half_spacing);
        let measure = sums.shear_measure(half_spacing);
        let across = |p: usize, dilated: f64, damage: f64, parted: f64| {
            let w = base[p] - dilated;
            // Failed: no tension at any point.
            if damage >= 1.0 && w >= 0.0 { 0.0 } else { self.normal(w, damage, parted) }
        };
        let mean_of = |dilated: f64, damage: f64, parted: f64| {
            0.25 * (0..4).map(|p| across(p, dilated, damage, parted)).sum::<f64>()
        };
        let accumulated = one.accumulated_slip;
        let mut damage = self.damage(&one, accumulated);
        let stays = |damage: f64, parted: f64| {
            let sigma = mean_of(dilated, damage, parted);
            let open = damage >= 1.0 && sigma == 0.0;
            let limit = if open { 0.0 } else { self.limit(sigma, damage, accumulated) };
            measure <= BEYOND * limit
        };
        let mut fails = !stays(damage, one.parted);
        // Beyond its peak the face breaks; whether it also slides is told by the strength that is left.
        if fails && self.is_brittle() && whole {
            one.broken = true;
            damage = 1.0;
            fails = !stays(damage, one.parted);
        }
        let above = self.above_residual(mean_of(dilated, damage, one.parted), damage, accumulated);
        let (mut plastic, mut lifted, mut keep) = (0.0, dilated, 1.0);
        let closed = damage < 1.0 || mean_of(dilated, damage, one.parted) < 0.0;
        if fails && closed {
            // Shorter than 1 where torsion has a part in the measure: only slip along the face dilates.
            let direction = sums.shear.map(|x| x / measure);
            [plastic, lifted] = self.flow(measure, (slip, direction), &one, |dilated, damage| {
                mean_of(dilated, damage, one.parted)
            });
            // The return is along the trial: shear and torsion shrink by one factor.
            keep = (1.0 - self.springs[1] * plastic / measure).max(0.0);
            self.slid(plastic, &mut one, lifted);
        } else if fails {
            keep = 0.0;
        }
        let damage = self.damage(&one, one.accumulated_slip);
        let now: [(f64, Traction); 4] = std::array::from_fn(|p| {
            let [b, c] = [SIGNS[0][p] * half_spacing[0], SIGNS[1][p] * half_spacing[1]];
            let [mut tb, mut tc] = trial[p];
            if fails {
                tb = keep * (sums.shear[0] - sums.twist * c);
                tc = keep * (sums.shear[1] + sums.twist * b);
            }
            let sigma = across(p, lifted, damage, one.parted);
            (base[p] - lifted, [sigma, tb, tc])
        });
        for p in 0..4 {
            let (w, t) = &now[p];
            memory[p] = Memory {
                slip: [0, 1]
                    .map(|k| memory[p].slip[k] + (trial[p][k] - t[k + 1]) / self.springs[1]),
                normal_offset: memory[p].normal_offset,
                open: one.broken && *w >= 0.0,
                sliding: fails && closed,
                ..one
            };
        }
        let t = now.map(|(_, t)| t);
        let opened = whole && one.broken && mean > 0.0;
        if !fails && !opened && one.parted == parted {
            return (t, Loss::default());
        }
        let all = account(&now);
        let sigma = mean_of(lifted, damage, one.parted);
        let after = self.above_residual(sigma, damage, one.accumulated_slip);
        let separation =
            if opened || one.parted > parted { all } else { 0.5 * plastic * (above + after) };
        (t, divided(all, separation))
    }
}
