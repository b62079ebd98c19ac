//! How stiff the contacts of a block are against its own motion.

use riprap_geom::{Mat3, Vec3};

use crate::contact::limit::InverseInertia;
use crate::kernel::{ContactLaw, Pose, Shape};
use crate::state::contact_scratch::FacePair;

/// Where springs of a contact are, seen from a block.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct AreaMoments {
    /// Unit normal, of either sign.
    pub(super) normal: Vec3,
    /// Their centre from the centroid of the block, m.
    pub(super) arm: Vec3,
    /// m².
    pub(super) area: f64,
    /// Polar second moment about the centre over the area, m².
    pub(super) polar: f64,
    /// Area that the springs along it stand for at least, m².
    pub(super) held: f64,
}

impl FacePair {
    /// The smaller face, turned into space, seen from a block from which it is `way` (m) to the centroid of its own; a share of it where
    /// no more than a small part can be in touch.
    ///
    /// Springs of the area a at a place r from the centre of a face of the area A and the radius of gyration i answer a motion u of the
    /// centre and a turn t by `a (u + t r)² <= a (1 + r²/i²) (u² + t² i²)`: nowhere are they stiffer than `(1 + r²/i²) a/A` of the whole face.
    pub(super) fn spread(&self, turn: Mat3, way: Vec3) -> AreaMoments {
        AreaMoments {
            normal: turn * self.normal,
            arm: turn * self.centre + way,
            area: self.face.min((1.0 + self.corner / self.polar) * self.area),
            polar: self.polar,
            held: 0.0,
        }
    }

    /// Finds how fast the smaller face alone is as a spring, for the slower of both blocks.
    pub(super) fn with_square(
        mut self,
        eases: [InverseInertia; 2],
        poses: [Pose; 2],
        law: &ContactLaw,
    ) -> Self {
        let of = poses[self.side];
        let turn = Mat3::from_quat(of.rotation);
        let squares = [0, 1].map(|s| {
            let mut felt = ContactStiffness::default();
            felt.add(&eases[s], law, &self.spread(turn, of.position - poses[s].position));
            felt.bound(&eases[s])
        });
        self.square = squares[0].max(squares[1]);
        self
    }

    pub(super) fn new(area: f64, side: usize, shape: &Shape, face: usize) -> Self {
        let corners: Vec<Vec3> =
            (shape.outline(face).iter()).map(|v| shape.vertices[*v as usize]).collect();
        let normal = shape.normals[face];
        // A fan of triangles about the first corner: centroid, and the mean square of distances from it, of corners and centroid.
        let (mut whole, mut first, mut second) = (0.0, Vec3::ZERO, 0.0);
        let start = corners.first().copied().unwrap_or_default();
        for two in corners.windows(2) {
            let [p, q] = [two[0] - start, two[1] - start];
            let share = 0.5 * normal.dot(p.cross(q));
            whole += share;
            first += share / 3.0 * (p + q);
            second += share / 6.0 * (p.length_squared() + q.length_squared() + p.dot(q));
        }
        let centre = if whole > 0.0 { first / whole } else { Vec3::ZERO };
        let centre_at = start + centre;
        let corner = (corners.iter()).map(|v| (*v - centre_at).length_squared());
        Self {
            area,
            side,
            normal,
            corner: corner.fold(0.0, f64::max),
            centre: centre_at,
            face: shape.areas[face],
            square: 0.0,
            polar: if whole > 0.0 {
                (second / whole - centre.length_squared()).max(0.0)
            } else {
                shape.radius * shape.radius
            },
        }
    }
}

/// Springs of the contacts of a block, as its motion feels them, 1/s²: displacements times the root of the mass, rotations times that of the
/// inertia.
#[derive(Default)]
pub(super) struct ContactStiffness {
    /// Those that are not in the matrix yet, the first `count` of them, with their stiffness across and along.
    contacts: [(AreaMoments, [f64; 2]); WAITING],
    count: usize,
    matrix: Matrix,
    /// Trace of the matrix.
    trace: f64,
    /// Of contacts whose place is not known, wherever they are.
    pub(super) anywhere: f64,
}

/// Contacts of a block that are kept, so that most matrices are never put together: more than most blocks have.
const WAITING: usize = 12;

/// The symmetric matrix of displacements along x, y, z and rotations about x, y, z.
#[derive(Clone, Default)]
struct Matrix {
    rows: [[f64; 6]; 6],
}

/// What round-off may take from a trace, over it.
const ROUNDING: f64 = 1e-9;

impl ContactStiffness {
    /// Forgets all contacts.
    pub(super) fn clear(&mut self) {
        if self.count > WAITING {
            self.matrix = Matrix::default();
        }
        (self.count, self.trace, self.anywhere) = (0, 0.0, 0.0);
    }

    /// Adds a contact.
    pub(super) fn add(&mut self, ease: &InverseInertia, law: &ContactLaw, spread: &AreaMoments) {
        let &AreaMoments { normal, arm, area, polar, held } = spread;
        let (across, along) =
            (2.0 * area * law.normal_stiffness, 2.0 * area.max(held) * law.shear_stiffness);
        let moved = 2.0 * along + across;
        let lever = normal.cross(arm).length_squared();
        let turned = 2.0 * along * arm.length_squared()
            + (across - along) * lever
            + polar * (2.0 * across + along);
        self.trace += ease.mass * moved + ease.inertia * turned;
        if self.count < WAITING {
            self.contacts[self.count] = (*spread, [across, along]);
        } else {
            if self.count == WAITING {
                self.matrix = self.waiting(ease);
            }
            self.matrix.add(ease, spread, [across, along]);
        }
        self.count += 1;
    }

    /// The matrix of the contacts that are kept.
    fn waiting(&self, ease: &InverseInertia) -> Matrix {
        let mut matrix = Matrix::default();
        for (spread, stiffness) in &self.contacts[..self.count.min(WAITING)] {
            matrix.add(ease, spread, *stiffness);
        }
        matrix
    }

    /// Bound of the largest eigenvalue, 1/s², that costs nothing: at most six times as large.
    pub(super) fn rough_bound(&self) -> f64 {
        self.trace * (1.0 + ROUNDING) + self.anywhere
    }

    /// Bound of the largest eigenvalue, 1/s²: `|K⁴|^(1/4)` of the matrix K of displacements and rotations, at most 6^(1/8) too much.
    pub(super) fn bound(&self, ease: &InverseInertia) -> f64 {
        let norm = match self.count > WAITING {
            true => self.matrix.norm(),
            false => self.waiting(ease).norm(),
        };
        norm + self.anywhere
    }
}

impl Matrix {
    fn add(&mut self, ease: &InverseInertia, spread: &AreaMoments, [across, along]: [f64; 2]) {
        let &AreaMoments { normal: n, arm, polar, .. } = spread;
        let force = |d: Vec3| along * d + (across - along) * n.dot(d) * n;
        let (mass, inertia) = (ease.mass.sqrt(), ease.inertia.sqrt());
        for (k, axis) in [Vec3::X, Vec3::Y, Vec3::Z].into_iter().enumerate() {
            // Unit motions of the block, and what the contact answers.
            let moved = force(axis);
            let turned = force(axis.cross(arm));
            let couple =
                arm.cross(turned) + polar * (across * axis + (along - across) * n.dot(axis) * n);
            let arm_moved = arm.cross(moved);
            for l in 0..3 {
                self.rows[k][l] += mass * mass * moved[l];
                self.rows[k][3 + l] += mass * inertia * arm_moved[l];
                self.rows[3 + k][l] += mass * inertia * turned[l];
                self.rows[3 + k][3 + l] += inertia * inertia * couple[l];
            }
        }
    }

    /// `|K⁴|^(1/4)`.
    fn norm(&self) -> f64 {
        let size = (self.rows.iter().flatten()).fold(0.0_f64, |most, x| most.max(x.abs()));
        if size == 0.0 || !size.is_finite() {
            return size;
        }
        // Fourth powers of squared frequencies could be beyond all numbers.
        let scaled = self.rows.map(|row| row.map(|x| x / size));
        let fourth = squared(&squared(&scaled));
        let sum: f64 = fourth.iter().flatten().map(|x| x * x).sum();
        size * sum.sqrt().sqrt().sqrt()
    }
}

/// Square of a symmetric matrix.
fn squared(a: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
    a.map(|row| {
        let mut out = [0.0; 6];
        for (x, other) in row.iter().zip(a) {
            for (sum, y) in out.iter_mut().zip(other) {
                *sum += x * y;
            }
        }
        out
    })
}

#[cfg(test)]
mod tests {
    use riprap_geom::Quat;

    use super::*;

    fn cube() -> (Shape, InverseInertia) {
        let shape = Shape::brick(Vec3::splat(0.5)).unwrap();
        // 1 kg, 1 m: I = 1/6.
        let ease = InverseInertia { mass: 1.0, inertia: 6.0, height: 0.25, reach: 0.75 };
        (shape, ease)
    }

    const LAW: ContactLaw = ContactLaw {
        normal_stiffness: 1.0,
        shear_stiffness: 0.5,
        friction: 0.0,
        cohesion: 0.0,
        damping_ratio: 0.0,
        rebound: 0.0,
        growth: 0.0,
    };

    /// A cube on one face: across 2 kn; along and tilting, with the coupling of both, the larger root of a matrix of two rows.
    #[test]
    fn one_face_has_the_frequency_of_the_closed_form() {
        let (shape, ease) = cube();
        let face = FacePair::new(1.0, 0, &shape, 0);
        assert!((face.polar - 1.0 / 6.0).abs() < 1e-15 && face.centre.length() == 0.5);
        let mut felt = ContactStiffness::default();
        let turn = Mat3::from_quat(Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), 0.7));
        felt.add(&ease, &LAW, &face.spread(turn, Vec3::ZERO));
        // ks = 1/2 at half an edge, twice; tilting against J = 1/6 in full, as a bound of the moments across.
        let (along, both, tilt) = (1.0, 0.5 * 6.0_f64.sqrt(), 6.0 * (0.25 + 2.0 / 6.0));
        let root = f64::hypot(0.5 * (tilt - along), both);
        let exact = (0.5 * (along + tilt) + root).max(2.0);
        let bound = felt.bound(&ease);
        assert!(bound >= exact && bound < 1.25 * exact, "{bound} {exact}");
        let rough = felt.rough_bound();
        assert!(rough >= bound && rough < 6.0 * exact, "{rough} {bound}");
    }

    /// A small part of a face, wherever it lies, and the share of the face that stands for it.
    #[test]
    fn a_small_part_of_a_face_is_no_stiffer_than_its_share() {
        let (shape, ease) = cube();
        let area = 0.01;
        let face = FacePair::new(area, 0, &shape, 0);
        let whole = face.spread(Mat3::IDENTITY, Vec3::ZERO);
        assert!((whole.area - 4.0 * area).abs() < 1e-12);
        let mut share = ContactStiffness::default();
        share.add(&ease, &LAW, &whole);
        let [_, e, h] = riprap_geom::polyhedron::frame(face.normal);
        for (s, t) in [(0.45, 0.45), (0.45, 0.0), (0.0, -0.45), (-0.45, 0.45), (0.0, 0.0)] {
            let mut part = ContactStiffness::default();
            let spread = AreaMoments {
                normal: face.normal,
                arm: face.centre + s * e + t * h,
                area,
                polar: area / 6.0,
                held: 0.0,
            };
            part.add(&ease, &LAW, &spread);
            assert!(part.bound(&ease) <= share.bound(&ease), "{s} {t}");
            let rows = |felt: &ContactStiffness| felt.waiting(&ease).rows;
            let [of_part, of_share] = [&part, &share].map(rows);
            for k in 0..6 {
                assert!(of_part[k][k] <= of_share[k][k], "{s} {t}: {k}");
            }
            let trace: f64 = (0..6).map(|k| of_part[k][k]).sum();
            assert!((part.trace / trace - 1.0).abs() < 1e-12, "{s} {t}");
        }
    }

    /// A block with more contacts than are kept.
    #[test]
    fn many_contacts_are_those_of_a_matrix() {
        let (shape, ease) = cube();
        let mut felt = ContactStiffness::default();
        for round in 0..3 {
            felt.clear();
            let mut whole = Matrix::default();
            for k in 0..[WAITING + 5, 3, WAITING + 1][round] {
                let spread = FacePair::new(0.1, 0, &shape, k % 6);
                let spread = spread.spread(Mat3::IDENTITY, Vec3::splat(0.01 * k as f64));
                felt.add(&ease, &LAW, &spread);
                let area = 2.0 * spread.area;
                whole.add(
                    &ease,
                    &spread,
                    [area * LAW.normal_stiffness, area * LAW.shear_stiffness],
                );
            }
            assert_eq!(felt.bound(&ease), whole.norm());
            assert!(felt.rough_bound() >= whole.norm());
        }
    }

    #[test]
    fn a_part_of_a_face_is_no_stiffer_than_the_face() {
        let (shape, ease) = cube();
        let face = FacePair::new(1.0, 0, &shape, 0).spread(Mat3::IDENTITY, Vec3::ZERO);
        let mut whole = ContactStiffness::default();
        whole.add(&ease, &LAW, &face);
        // A quarter of it, in a corner.
        let [_, e, h] = riprap_geom::polyhedron::frame(face.normal);
        let mut part = ContactStiffness::default();
        let spread = AreaMoments {
            normal: face.normal,
            arm: face.arm + 0.25 * (e + h),
            area: 0.25,
            polar: 1.0 / 24.0,
            held: 0.0,
        };
        part.add(&ease, &LAW, &spread);
        assert!(part.bound(&ease) <= whole.bound(&ease));
    }
}
