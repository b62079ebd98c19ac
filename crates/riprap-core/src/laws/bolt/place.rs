//! Whether a bolt can be where it is: the spans of rock along it, in order.

/// Why a bolt cannot be installed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Misplaced {
    /// No block there.
    #[error("it passes through no block")]
    Outside,
    /// The head is off the rock.
    #[error("its head lies outside the rock, which begins {gap} m further along")]
    Head {
        /// Distance to the rock, m.
        gap: f64,
    },
    /// A plate inside the rock.
    #[error("its plate lies inside the rock")]
    Buried,
    /// The toe is off the rock.
    #[error("its toe lies outside the rock, {gap} m beyond the last block")]
    Toe {
        /// Distance from the rock, m.
        gap: f64,
    },
    /// All grout is off the rock.
    #[error("no part of its grouted length lies in rock")]
    NoGrout,
}

/// How far ends may be off the rock, as a share of the length.
const LOOSE: f64 = 1e-3;
/// Spans that are shorter, as a share of the length, are none.
const TOUCH: f64 = 1e-9;

/// The block in which a bolt of this length begins, of spans along it.
#[must_use]
pub fn collar(spans: &[([f64; 2], u32)], length: f64) -> Option<u32> {
    let here = |[from, to]: [f64; 2]| to.min(length) - from.max(0.0) > TOUCH * length;
    let inside = spans.iter().filter(|(span, _)| here(*span));
    inside.min_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.1.cmp(&b.1))).map(|(_, block)| *block)
}

/// Puts spans of blocks (m from the head of a bolt of this length) in order and checks that the bolt can be there. Spans reach as far as `range`
/// allows.
///
/// # Errors
/// What is wrong with its place.
pub fn order(
    mut spans: Vec<([f64; 2], u32)>,
    length: f64,
    grouted: f64,
    plate: bool,
) -> Result<Vec<([f64; 2], u32)>, Misplaced> {
    let slack = LOOSE * length;
    spans.retain(|([from, to], _)| to.min(length) - from.max(0.0) > TOUCH * length);
    spans.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.1.cmp(&b.1)));
    let (Some(first), Some(last)) = (spans.first(), spans.last()) else {
        return Err(Misplaced::Outside);
    };
    let ([head, _], [_, toe]) = (first.0, last.0);
    if head > slack {
        return Err(Misplaced::Head { gap: head });
    }
    // Rock is looked for up to `slack` before the head: where it is met that early, it goes on.
    if plate && head < -0.5 * slack {
        return Err(Misplaced::Buried);
    }
    if toe < length - slack {
        return Err(Misplaced::Toe { gap: length - toe });
    }
    if last.0[1].min(length) <= length - grouted {
        return Err(Misplaced::NoGrout);
    }
    // Blocks may lie in each other a little: each begins where the one before ends.
    let mut end = 0.0;
    for ([from, to], _) in &mut spans {
        *from = from.max(end);
        *to = to.min(length).max(*from);
        end = *to;
    }
    Ok(spans)
}

/// The range in which spans are looked for: a little beyond both ends.
#[must_use]
pub fn range(length: f64) -> [f64; 2] {
    [-LOOSE * length, length]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_in_the_air_are_refused() {
        let two = |a: f64, b: f64| vec![([a, 1.0], 0), ([1.0, b], 1)];
        assert!(order(two(0.0, 2.0), 2.0, f64::INFINITY, true).is_ok());
        let gap = 0.3;
        let found = order(two(gap, 2.0), 2.0, f64::INFINITY, false);
        assert_eq!(found, Err(Misplaced::Head { gap }));
        let found = order(two(0.0, 1.75), 2.0, f64::INFINITY, false);
        assert_eq!(found, Err(Misplaced::Toe { gap: 0.25 }));
        let found = order(two(-0.002, 2.0), 2.0, f64::INFINITY, true);
        assert_eq!(found, Err(Misplaced::Buried));
        assert_eq!(order(Vec::new(), 2.0, 1.0, false), Err(Misplaced::Outside));
    }
}
