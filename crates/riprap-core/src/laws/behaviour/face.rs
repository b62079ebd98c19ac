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
        let (whole, parted) = (!memory[0].broken, memory[0].parted);
        for p in 0..4 {
            memory[p].sliding = false;
            memory[p].open = false;
            if was_open {
                self.start_anew(&start[p], &at[p], &moved[p], &mut memory[p]);
            }
        }
        let trial = Trial::new(self, start, at, memory, half_spacing);
        // All points have one damage.
        let mut one = memory[0];
        let mean = trial.mean();
        self.part(mean, &mut one);
        let end = trial.end(&mut one, whole);
        let damage = self.damage(&one, one.accumulated_slip);
        let now = trial.tractions(&end, damage, &one, half_spacing);
        for p in 0..4 {
            let (w, t) = &now[p];
            memory[p] = Memory {
                slip: [0, 1]
                    .map(|k| memory[p].slip[k] + (trial.shear[p][k] - t[k + 1]) / self.springs[1]),
                normal_offset: memory[p].normal_offset,
                open: one.broken && *w >= 0.0,
                sliding: end.slides,
                ..one
            };
        }
        let t = now.map(|(_, t)| t);
        let opened = whole && one.broken && mean > 0.0;
        if !end.fails && !opened && one.parted == parted {
            return (t, Loss::default());
        }
        let lost = (0..4).map(|p| {
            let (w, t) = &now[p];
            let w = if t[0] == 0.0 { 0.0 } else { *w };
            // A loss is per area: each point stands for a quarter of the face.
            0.25 * lost((&before[p].0, before[p].1), (t, self.stored(w, t)), &moved[p])
        });
        let all = lost.sum::<f64>();
        let sigma = trial.mean_of(end.lifted, damage, one.parted);
        let after = self.above_residual(sigma, damage, one.accumulated_slip);
        let separation = if opened || one.parted > parted {
            all
        } else {
            0.5 * end.plastic * (end.above + after)
        };
        (t, divided(all, separation))
    }
}

/// A face whose springs have followed the move, before it fails.
struct Trial<'a> {
    law: &'a Law<'a>,
    /// Mean slip, m.
    slip: [f64; 2],
    /// Opening by dilation, m.
    dilated: f64,
    /// Opening of each point without dilation, m.
    base: [f64; 4],
    /// Shear tractions of the points, Pa.
    shear: [[f64; 2]; 4],
    sums: Sums,
    /// Shear with torsion, Pa.
    measure: f64,
}

/// Where the return to the strength ends.
struct End {
    fails: bool,
    /// Whether it fails while closed.
    slides: bool,
    /// Plastic slip, m.
    plastic: f64,
    /// Opening by dilation, m.
    lifted: f64,
    /// What is kept of shear and torsion.
    keep: f64,
    /// Strength above the residual one before, Pa.
    above: f64,
}

impl<'a> Trial<'a> {
    fn new(
        law: &'a Law<'a>,
        start: &[Traction; 4],
        at: &[[f64; 3]; 4],
        memory: &[Memory; 4],
        half_spacing: [f64; 2],
    ) -> Self {
        let slip = Law::mean_slip(memory);
        let shear: [[f64; 2]; 4] =
            std::array::from_fn(|p| law.shear(&start[p], &at[p], &memory[p]));
        let sums = Sums::of(&shear.map(|[b, c]| [0.0, b, c]), half_spacing);
        Self {
            law,
            slip,
            dilated: law.dilated(slip, &memory[0]),
            base: std::array::from_fn(|p| law.base(&start[p], &at[p], &memory[p])),
            shear,
            measure: sums.shear_measure(half_spacing),
            sums,
        }
    }

    /// Mean opening, m.
    fn mean(&self) -> f64 {
        0.25 * self.base.iter().sum::<f64>() - self.dilated
    }

    /// Normal traction of a point, Pa.
    fn across(&self, p: usize, dilated: f64, damage: f64, parted: f64) -> f64 {
        let w = self.base[p] - dilated;
        // Failed: no tension at any point.
        if damage >= 1.0 && w >= 0.0 { 0.0 } else { self.law.normal(w, damage, parted) }
    }

    /// Mean normal traction, Pa.
    fn mean_of(&self, dilated: f64, damage: f64, parted: f64) -> f64 {
        0.25 * (0..4).map(|p| self.across(p, dilated, damage, parted)).sum::<f64>()
    }

    /// Whether the face bears its shear.
    fn stays(&self, damage: f64, one: &Memory) -> bool {
        let sigma = self.mean_of(self.dilated, damage, one.parted);
        let open = damage >= 1.0 && sigma == 0.0;
        let limit = if open { 0.0 } else { self.law.limit(sigma, damage, one.accumulated_slip) };
        self.measure <= BEYOND * limit
    }

    /// Returns the face to its strength; `one` is what all points remember, `whole` whether it was intact before.
    fn end(&self, one: &mut Memory, whole: bool) -> End {
        let Self { law, dilated, measure, .. } = *self;
        let accumulated = one.accumulated_slip;
        let mut damage = law.damage(one, accumulated);
        let mut fails = !self.stays(damage, one);
        // Beyond its peak the face breaks; whether it also slides depends on the remaining strength.
        if fails && law.is_brittle() && whole {
            one.broken = true;
            damage = 1.0;
            fails = !self.stays(damage, one);
        }
        let sigma = self.mean_of(dilated, damage, one.parted);
        let above = law.above_residual(sigma, damage, accumulated);
        let (mut plastic, mut lifted, mut keep) = (0.0, dilated, 1.0);
        let slides = fails && (damage < 1.0 || sigma < 0.0);
        if slides {
            // Shorter than 1 where torsion has a part in the measure: only slip along the face dilates.
            let direction = self.sums.shear.map(|x| x / measure);
            [plastic, lifted] =
                law.flow(measure, (self.slip, direction), one, |dilated, damage| {
                    self.mean_of(dilated, damage, one.parted)
                });
            // The return is along the trial: shear and torsion shrink by one factor.
            keep = (1.0 - law.springs[1] * plastic / measure).max(0.0);
            law.slid(plastic, one, lifted);
        } else if fails {
            keep = 0.0;
        }
        End { fails, slides, plastic, lifted, keep, above }
    }

    /// Opening and traction of each point at the end.
    fn tractions(
        &self,
        end: &End,
        damage: f64,
        one: &Memory,
        half_spacing: [f64; 2],
    ) -> [(f64, Traction); 4] {
        let Sums { shear, twist, .. } = self.sums;
        std::array::from_fn(|p| {
            let [b, c] = [SIGNS[0][p] * half_spacing[0], SIGNS[1][p] * half_spacing[1]];
            let [mut tb, mut tc] = self.shear[p];
            if end.fails {
                tb = end.keep * (shear[0] - twist * c);
                tc = end.keep * (shear[1] + twist * b);
            }
            let sigma = self.across(p, end.lifted, damage, one.parted);
            (self.base[p] - end.lifted, [sigma, tb, tc])
        })
    }
}
