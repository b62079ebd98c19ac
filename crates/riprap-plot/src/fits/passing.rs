//! The curve of sizes of fragments, as they are counted.

/// Fragments by size.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Passing {
    /// Ascending, m.
    pub size: Vec<f64>,
    /// Share of the volume in fragments up to that size.
    pub passing: Vec<f64>,
}

impl Passing {
    /// From sizes with volumes; those without a volume do not count.
    #[must_use]
    pub fn of(fragments: impl Iterator<Item = (f64, f64)>) -> Self {
        let mut fragments: Vec<(f64, f64)> = fragments.filter(|(_, v)| *v > 0.0).collect();
        fragments.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let all: f64 = fragments.iter().map(|(_, v)| v).sum();
        let mut sum = 0.0;
        let (mut size, mut passing): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        for (x, v) in fragments {
            sum += v;
            // Fragments of one size pass together.
            if size.last().is_some_and(|s| x <= s * (1.0 + 1e-9)) {
                if let Some(last) = passing.last_mut() {
                    *last = sum / all;
                }
            } else {
                size.push(x);
                passing.push(sum / all);
            }
        }
        Self { size, passing }
    }

    /// Share of the volume in fragments up to a size.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let k = self.size.partition_point(|s| *s <= x);
        k.checked_sub(1).map_or(0.0, |k| self.passing[k])
    }

    /// The size that a share passes: linear in the logarithm of the size between fragments. A share below that of the
    /// smallest fragments is their size.
    #[must_use]
    pub fn quantile(&self, share: f64) -> f64 {
        let k = self.passing.partition_point(|p| *p < share);
        let Some(k) = (k < self.size.len()).then_some(k) else {
            return self.size.last().copied().unwrap_or(f64::NAN);
        };
        let Some(below) = k.checked_sub(1) else {
            return self.size[0];
        };
        let (p0, p1) = (self.passing[below], self.passing[k]);
        let part = (share - p0) / (p1 - p0);
        self.size[below] * libm::pow(self.size[k] / self.size[below], part)
    }

    /// Sieves from the smallest to the largest size.
    #[must_use]
    pub fn sieves(&self, count: usize) -> Vec<f64> {
        let (Some(&low), Some(&high)) = (self.size.first(), self.size.last()) else {
            return Vec::new();
        };
        let step = libm::log(high / low) / (count - 1) as f64;
        let mut all: Vec<f64> = (0..count).map(|k| low * libm::exp(step * k as f64)).collect();
        // Not a hair below the largest.
        if let Some(last) = all.last_mut() {
            *last = high;
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cumulative_shares() {
        let cubes = [8.0, 1.0, 1.0, 0.0, f64::NAN];
        let s = Passing::of(cubes.into_iter().map(|v| (libm::cbrt(v), v)));
        assert_eq!(s.size, [1.0, 2.0]);
        assert_eq!(s.passing, [0.2, 1.0]);
        assert_eq!((s.at(0.9), s.at(1.5), s.at(2.0)), (0.0, 0.2, 1.0));
        assert_eq!(s.quantile(0.1), 1.0);
        // Three eighths of the way from 0.2 to 1.
        assert!((s.quantile(0.5) - 2f64.powf(0.375)).abs() < 1e-12);
        assert_eq!(s.quantile(1.0), 2.0);
    }
}
