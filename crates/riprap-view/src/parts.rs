//! Work on many blocks by several threads. Each part gives a list, and the lists come in the order of the parts: the result is that of one
//! thread.

use std::ops::Range;

/// Threads at most; a viewer is not alone on its machine.
const MOST: usize = 8;
/// Fewer things than this are one part.
const LEAST: usize = 4096;

/// Lists of all parts of `0..count`, one after the other.
pub(crate) fn in_parts<T: Send>(
    count: usize,
    of: impl Fn(Range<usize>) -> Vec<T> + Sync,
) -> Vec<T> {
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get().min(MOST));
    let parts = threads.min(count.div_ceil(LEAST)).max(1);
    if parts == 1 {
        return of(0..count);
    }
    let of = &of;
    let range = |k: usize| k * count / parts..(k + 1) * count / parts;
    std::thread::scope(|scope| {
        let others: Vec<_> = (1..parts).map(|k| scope.spawn(move || of(range(k)))).collect();
        let mut all = of(range(0));
        for other in others {
            match other.join() {
                Ok(part) => all.extend(part),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        all
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_come_in_their_order() {
        for count in [0, 1, LEAST, 5 * LEAST + 7] {
            let all = in_parts(count, |range| range.map(|k| 3 * k).collect());
            assert_eq!(all, (0..count).map(|k| 3 * k).collect::<Vec<_>>());
        }
    }
}
