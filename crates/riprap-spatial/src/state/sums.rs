//! Forces and moments on blocks, one list per component.

use riprap_geom::Vec3;

use crate::exec::Cut;
pub use riprap_core::sums::tree;

/// Force (x, y, z), N, and moment about the centroid (x, y, z), N m, of many blocks or slots.
#[derive(Clone, Debug, Default)]
pub struct Sums {
    /// One list per component.
    pub lists: [Vec<f64>; 6],
}

impl Sums {
    /// `n` zeros.
    #[must_use]
    pub fn zeros(n: usize) -> Self {
        Self { lists: std::array::from_fn(|_| vec![0.0; n]) }
    }

    /// Whether it has no entries.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lists[0].is_empty()
    }

    /// Force on item `b`, N.
    #[must_use]
    pub fn force(&self, b: usize) -> Vec3 {
        let [x, y, z, ..] = &self.lists;
        Vec3::new(x[b], y[b], z[b])
    }

    /// Moment on item `b`, N m.
    #[must_use]
    pub fn moment(&self, b: usize) -> Vec3 {
        let [.., x, y, z] = &self.lists;
        Vec3::new(x[b], y[b], z[b])
    }

    /// All of it, to be cut in pieces.
    #[must_use]
    pub fn whole(&mut self) -> Part<'_> {
        Part(self.lists.each_mut().map(Vec::as_mut_slice))
    }
}

/// A range of [`Sums`].
pub struct Part<'a>(pub [&'a mut [f64]; 6]);

impl Cut for Part<'_> {
    fn cut(self, at: usize) -> (Self, Self) {
        let [a, b, c, d, e, f] = self.0.map(|list| list.cut(at));
        (Self([a.0, b.0, c.0, d.0, e.0, f.0]), Self([a.1, b.1, c.1, d.1, e.1, f.1]))
    }
}

impl Part<'_> {
    /// Sets all to zero.
    pub fn clear(&mut self) {
        for list in &mut self.0 {
            list.fill(0.0);
        }
    }

    /// Adds a force and a moment to entry `at`.
    #[inline]
    pub fn add(&mut self, at: usize, force: Vec3, moment: Vec3) {
        for k in 0..3 {
            self.0[k][at] += force[k];
            self.0[k + 3][at] += moment[k];
        }
    }

    /// Force and moment of entry `at`.
    #[inline]
    #[must_use]
    pub fn get(&self, at: usize) -> (Vec3, Vec3) {
        let v = |k: usize| Vec3::new(self.0[k][at], self.0[k + 1][at], self.0[k + 2][at]);
        (v(0), v(3))
    }
}

impl Part<'_> {
    /// Sets entry `at`.
    #[inline]
    pub fn set(&mut self, at: usize, first: Vec3, second: Vec3) {
        for k in 0..3 {
            self.0[k][at] = first[k];
            self.0[k + 3][at] = second[k];
        }
    }
}
