//! Forces and moments on blocks, one list per component.

use riprap_geom::Vec3;

/// Adds up a list over a fixed tree and leaves the sum in its first item (the others hold parts of it): items `0` and
/// `1`, `2` and `3` and so on, then the sums of these pairs, and so on. Parts of `2^k` items can be added by themselves.
pub fn tree<T: Copy>(list: &mut [T], add: impl Fn(&mut T, &T)) {
    let mut stride = 1;
    while stride < list.len() {
        for k in (0..list.len() - stride).step_by(2 * stride) {
            let other = list[k + stride];
            add(&mut list[k], &other);
        }
        stride *= 2;
    }
}

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
        Self {
            lists: std::array::from_fn(|_| vec![0.0; n]),
        }
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

impl<'a> Part<'a> {
    /// Entries before `middle` and the others; an empty part gives two empty parts.
    #[must_use]
    pub fn split(self, middle: usize) -> (Self, Self) {
        let mut first: [&'a mut [f64]; 6] = Default::default();
        let mut rest: [&'a mut [f64]; 6] = Default::default();
        for (k, list) in self.0.into_iter().enumerate() {
            let at = middle.min(list.len());
            (first[k], rest[k]) = list.split_at_mut(at);
        }
        (Self(first), Self(rest))
    }

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

#[cfg(test)]
mod tests {
    use super::tree;

    #[test]
    fn the_tree_does_not_depend_on_how_a_list_is_cut() {
        let sum = |list: &[f64]| {
            let mut list = list.to_vec();
            tree(&mut list, |a, b| *a += b);
            list[0]
        };
        let list: Vec<f64> = (0..1000).map(|k| 1.0 / (1.0 + f64::from(k))).collect();
        for length in [1, 2, 3, 7, 64, 100, 999, 1000] {
            let whole = sum(&list[..length]);
            assert!((whole - list[..length].iter().sum::<f64>()).abs() < 1e-13 * whole);
            for part in [1, 2, 8, 64, 512] {
                let parts: Vec<f64> = list[..length].chunks(part).map(sum).collect();
                assert_eq!(sum(&parts).to_bits(), whole.to_bits(), "{length} {part}");
            }
        }
        tree(&mut [], |a: &mut f64, b| *a += b);
    }
}
