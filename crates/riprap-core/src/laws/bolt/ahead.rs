//! What a chain would carry: for steps that seek the forces of their end.

use super::{Chain, Factors};

/// A chain at a parting of the rock that it has not come to yet; it remembers nothing of it, and nothing breaks.
///
/// The potential of the chain, least over the motion of its bar, is a convex function of the parting: the forces of the bars are its
/// slope, and [`Ahead::rate`] the matrix of its second derivatives.
#[derive(Clone, Debug, Default)]
pub struct Ahead {
    motion: Vec<f64>,
    work: Factors,
}

impl Ahead {
    /// At the present state of a chain.
    #[must_use]
    pub fn new(chain: &Chain) -> Self {
        Self { motion: chain.motion.clone(), work: chain.factors() }
    }

    /// Takes over that bars of the chain have broken.
    pub fn refresh(&mut self, chain: &Chain) {
        self.work.refresh(chain);
    }

    /// Force in each bar (N) where the rock has parted by `apart` (m) along each.
    pub fn forces(&mut self, chain: &Chain, apart: &[f64]) -> &[f64] {
        chain.seek(&mut self.motion, apart, None, &mut self.work);
        self.work.found()
    }

    /// Change of the force in each bar with the parting along bar `k` where [`Ahead::forces`] has looked last, N/m.
    pub fn rate(&mut self, chain: &Chain, k: usize, rates: &mut [f64]) {
        self.work.rates(chain, k, rates);
    }

    /// The first bar that has yielded beyond its rupture where [`Ahead::forces`] has looked last.
    #[must_use]
    pub fn torn(&self, chain: &Chain, apart: &[f64]) -> Option<usize> {
        let r = &self.motion;
        (0..chain.bars.len()).find(|&k| {
            let bar = &chain.bars[k];
            let elastic = r[k + 1] - r[k] + apart[k] - chain.plastic[k];
            let plastic = chain.plastic[k] + bar.map(elastic, chain.yielded[k]).plastic;
            bar.stiffness > 0.0 && plastic >= bar.breaks
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laws::bolt::{Bar, Hold};

    /// A bar of three pieces in grout that slips, with a piece that yields and breaks in its middle.
    fn chain() -> Chain {
        let holds = vec![Hold::grout(1e8, 40e3); 4];
        let bar = Bar { stiffness: 5e8, yields: 60e3, hardening: 1e6, breaks: 2e-3 };
        Chain::new(holds, vec![bar; 3])
    }

    #[test]
    fn what_a_chain_would_carry_is_what_it_carries() {
        let work = |chain: &Chain| chain.factors();
        for opening in [1e-4, 5e-4, 1.5e-3] {
            let apart = [0.0, opening, 0.3 * opening];
            let mut chain = chain();
            let mut ahead = Ahead::new(&chain);
            let would = ahead.forces(&chain, &apart).to_vec();
            assert_eq!(ahead.torn(&chain, &apart), None);
            let mut room = work(&chain);
            chain.solve(&apart, &mut room);
            assert_eq!(would, chain.force, "{opening}");
        }
        let mut chain = chain();
        let mut ahead = Ahead::new(&chain);
        let apart = [0.0, 5e-3, 0.0];
        ahead.forces(&chain, &apart);
        assert_eq!(ahead.torn(&chain, &apart), Some(1));
        let mut room = work(&chain);
        assert_eq!(chain.solve(&apart, &mut room).breaks, 1);
    }

    #[test]
    fn rates_are_slopes_of_the_forces() {
        let chain = chain();
        for opening in [1e-4, 5e-4, 1.5e-3] {
            let apart = [1e-5, opening, 0.3 * opening];
            let mut ahead = Ahead::new(&chain);
            for k in 0..3 {
                let mut rates = [0.0; 3];
                ahead.forces(&chain, &apart);
                ahead.rate(&chain, k, &mut rates);
                let mut beside = apart;
                beside[k] += 1e-9;
                let now = ahead.forces(&chain, &apart).to_vec();
                let then = ahead.forces(&chain, &beside).to_vec();
                for b in 0..3 {
                    let slope = (then[b] - now[b]) / 1e-9;
                    assert!(
                        (slope - rates[b]).abs() < 1e-3 * 5e8,
                        "{opening} {k} {b}: {slope} {rates:?}"
                    );
                }
            }
        }
    }
}
