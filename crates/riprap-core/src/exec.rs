//! The one place that names the thread pool.
//!
//! Sums run over groups of a fixed size and a fixed tree of groups ([`crate::sums`]), so that results are the same bits for any
//! thread count and however work is cut into pieces.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError, mpsc};
use std::time::{Duration, Instant};

use rayon::prelude::*;

use crate::peers::{Peers, channels};
use crate::sums::{GROUP, Tree};

/// Items per chunk in parallel stages without sums, and in looks; a power of 2 times [`GROUP`].
pub const CHUNK: usize = 512;

/// Pieces that work on a whole model should have, several for each of as many threads as a machine may have, unless they get larger than
/// [`LARGEST_PIECE`] or smaller than a group.
const PIECES: usize = 256;
/// Most items in a piece.
const LARGEST_PIECE: usize = 2048;

/// Items in a piece of work on `count` of them: whole groups.
#[must_use]
pub fn piece(count: usize) -> usize {
    let piece = count.div_ceil(PIECES).next_multiple_of(GROUP);
    piece.clamp(GROUP, LARGEST_PIECE)
}

/// Work that can be cut between two of its chunks.
pub trait Divide: Sized + Send {
    /// The chunks before number `middle` (counted from the first of this piece) and the others.
    fn divide(self, middle: usize) -> (Self, Self);
}

/// What can be cut in two at a place; a list that is shorter gives an empty rest.
pub trait Cut: Sized {
    /// What is before `at`, and the rest.
    fn cut(self, at: usize) -> (Self, Self);
}

impl<T> Cut for &[T] {
    fn cut(self, at: usize) -> (Self, Self) {
        self.split_at(at.min(self.len()))
    }
}

impl<T> Cut for &mut [T] {
    fn cut(self, at: usize) -> (Self, Self) {
        let at = at.min(self.len());
        self.split_at_mut(at)
    }
}

impl<T: Cut> Cut for [T; 2] {
    fn cut(self, at: usize) -> (Self, Self) {
        let [(a0, a1), (b0, b1)] = self.map(|part| part.cut(at));
        ([a0, b0], [a1, b1])
    }
}

/// The number of the first item.
impl Cut for usize {
    fn cut(self, at: usize) -> (Self, Self) {
        (self, self + at)
    }
}

/// Cuts a struct in two, each field ([`Cut`]) at its place: `cut!(self, blocks: n, patches: m)`.
#[macro_export]
macro_rules! cut {
    ($of:expr, $($field:ident: $at:expr),+ $(,)?) => {{
        $(let $field = $crate::exec::Cut::cut($of.$field, $at);)+
        (Self { $($field: $field.0),+ }, Self { $($field: $field.1),+ })
    }};
}

/// Threads, and the time in which they had work.
struct Pool {
    threads: rayon::ThreadPool,
    /// Wall time of whoever waited for them, ns.
    nanos: AtomicU64,
}

impl Pool {
    /// Does work on the threads. Within work of theirs it is a part of that.
    fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        if rayon::current_thread_index().is_some() {
            return self.threads.install(work);
        }
        let begun = Instant::now();
        let result = self.threads.install(work);
        self.nanos.fetch_add(begun.elapsed().as_nanos() as u64, Ordering::Relaxed);
        result
    }
}

/// Runs chunked loops, serially or on a pool of its own.
pub struct Exec {
    pool: Option<Pool>,
    threads: usize,
    /// The ranks that compute the same model, where there are others.
    peers: Option<Arc<Peers>>,
    /// Threads of all ranks.
    workers: usize,
}

impl std::fmt::Debug for Exec {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Exec").field("threads", &self.threads).finish_non_exhaustive()
    }
}

/// The operating system refused to start the threads.
#[derive(Debug, thiserror::Error)]
#[error("could not start {threads} threads: {reason}")]
pub struct ExecError {
    threads: usize,
    reason: String,
}

impl Exec {
    /// Runs everything on the calling thread.
    #[must_use]
    pub fn serial() -> Self {
        Self { pool: None, threads: 1, peers: None, workers: 1 }
    }

    /// A pool of `threads` threads; 0 and 1 run on the calling thread.
    ///
    /// # Errors
    /// When the threads cannot be started.
    pub fn new(threads: usize) -> Result<Self, ExecError> {
        if threads <= 1 {
            return Ok(Self::serial());
        }
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|e| ExecError { threads, reason: e.to_string() })?;
        let pool = Pool { threads: pool, nanos: AtomicU64::new(0) };
        Ok(Self { pool: Some(pool), threads, peers: None, workers: threads })
    }

    /// As [`Exec::new`] for one of several ranks. All of them must call it.
    ///
    /// # Errors
    /// When the threads cannot be started.
    pub fn among(peers: Arc<Peers>, threads: usize) -> Result<Self, ExecError> {
        let mut exec = Self::new(threads)?;
        // Work is cut alike on all, whatever machine each is on.
        let most = peers.gather((exec.threads as u64).to_le_bytes().to_vec()).map(|all| {
            let number =
                |m: &Vec<u8>| m.as_chunks().0.first().map_or(1, |b| u64::from_le_bytes(*b));
            all.iter().map(|m| number(m)).max().unwrap_or(1)
        });
        exec.workers = peers.size() * most.unwrap_or(1) as usize;
        exec.peers = (peers.size() > 1).then_some(peers);
        Ok(exec)
    }

    /// The ranks that compute the same model, where there are others.
    #[must_use]
    pub fn peers(&self) -> Option<&Arc<Peers>> {
        self.peers.as_ref()
    }

    /// Number of threads of all ranks, where each has as many as the largest.
    #[must_use]
    pub fn workers(&self) -> usize {
        self.workers
    }

    /// Wall time in which several threads had work; what else a stage takes is serial.
    #[must_use]
    pub fn pooled(&self) -> Duration {
        let nanos = self.pool.as_ref().map(|pool| pool.nanos.load(Ordering::Relaxed));
        Duration::from_nanos(nanos.unwrap_or(0))
    }

    /// Number of threads.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// Calls `f(first_index, chunk_of_a, chunk_of_b, partial)` for each chunk of two slices of equal
    /// length, with one `partial` per chunk.
    ///
    /// # Panics
    /// When the slices differ in length.
    pub fn chunks2<A: Send, B: Send, P: Send>(
        &self,
        a: &mut [A],
        b: &mut [B],
        partials: &mut [P],
        f: impl Fn(usize, &mut [A], &mut [B], &mut P) + Sync,
    ) {
        assert_eq!(a.len(), b.len(), "chunked slices differ in length");
        match &self.pool {
            Some(pool) if a.len() > CHUNK => pool.install(|| {
                a.par_chunks_mut(CHUNK)
                    .zip(b.par_chunks_mut(CHUNK))
                    .zip(partials.par_iter_mut())
                    .enumerate()
                    .for_each(|(k, ((a, b), p))| f(k * CHUNK, a, b, p));
            }),
            _ => a
                .chunks_mut(CHUNK)
                .zip(b.chunks_mut(CHUNK))
                .zip(partials.iter_mut())
                .enumerate()
                .for_each(|(k, ((a, b), p))| f(k * CHUNK, a, b, p)),
        }
    }

    /// Workspaces that [`Exec::groups2`] needs for `count` items: one for each thread that can have work.
    #[must_use]
    pub fn workspaces(&self, count: usize) -> usize {
        count.div_ceil(piece(count)).min(self.threads.max(1))
    }

    /// Calls `f(first_index, group_of_a, group_of_b, partial, workspace)` for each [`GROUP`] of two slices of equal length, with one
    /// `partial` per group. A `workspace` is used by one thread at a time, in any order: no result may depend on what it holds.
    ///
    /// # Panics
    /// When the slices differ in length, or there are fewer than [`Exec::workspaces`].
    pub fn groups2<A: Send, B: Send, P: Send, R: Send>(
        &self,
        a: &mut [A],
        b: &mut [B],
        partials: &mut [P],
        workspaces: &mut [R],
        f: impl Fn(usize, &mut [A], &mut [B], &mut P, &mut R) + Sync,
    ) {
        assert_eq!(a.len(), b.len(), "grouped slices differ in length");
        assert!(workspaces.len() >= self.workspaces(a.len()), "a workspace for each thread");
        let Some(first) = workspaces.first_mut() else {
            return;
        };
        let piece = piece(a.len());
        let one = |k: usize, a: &mut [A], b: &mut [B], p: &mut [P], workspace: &mut R| {
            let groups = a.chunks_mut(GROUP).zip(b.chunks_mut(GROUP)).zip(p);
            for (g, ((a, b), p)) in groups.enumerate() {
                f(k * piece + g * GROUP, a, b, p, workspace);
            }
        };
        match &self.pool {
            Some(pool) if a.len() > piece => {
                let spare = Mutex::new(workspaces.iter_mut().collect::<Vec<_>>());
                let spare = || spare.lock().unwrap_or_else(PoisonError::into_inner);
                pool.install(|| {
                    a.par_chunks_mut(piece)
                        .zip(b.par_chunks_mut(piece))
                        .zip(partials.par_chunks_mut(piece / GROUP))
                        .enumerate()
                        .for_each(|(k, ((a, b), p))| {
                            let taken = spare().pop();
                            let Some(workspace) = taken else {
                                unreachable!("there are as many as threads")
                            };
                            one(k, a, b, p, workspace);
                            spare().push(workspace);
                        });
                });
            }
            _ => a
                .chunks_mut(piece)
                .zip(b.chunks_mut(piece))
                .zip(partials.chunks_mut(piece / GROUP))
                .enumerate()
                .for_each(|(k, ((a, b), p))| one(k, a, b, p, first)),
        }
    }

    /// As [`Exec::chunks2`], where item `k` of `a` owns the items `first[k]..first[k + 1]` of `b`.
    pub fn ragged<A: Send, B: Send, P: Send>(
        &self,
        a: &mut [A],
        b: &mut [B],
        first: &[u32],
        partials: &mut [P],
        f: impl Fn(usize, &mut [A], &mut [B], &mut P) + Sync,
    ) {
        match &self.pool {
            Some(pool) if a.len() > CHUNK => {
                pool.install(|| split(0, a, b, first, partials, &f, true));
            }
            _ => split(0, a, b, first, partials, &f, false),
        }
    }

    /// Calls `f(first_index, chunk)` for each chunk of a slice.
    pub fn chunks<A: Send>(&self, items: &mut [A], f: impl Fn(usize, &mut [A]) + Sync) {
        match &self.pool {
            Some(pool) if items.len() > CHUNK => pool.install(|| {
                items.par_chunks_mut(CHUNK).enumerate().for_each(|(k, chunk)| f(k * CHUNK, chunk));
            }),
            _ => items.chunks_mut(CHUNK).enumerate().for_each(|(k, chunk)| f(k * CHUNK, chunk)),
        }
    }

    /// Calls `f(items, partial)` for the runs of [`CHUNK`] of `count` items, with one `partial` per run.
    ///
    /// # Panics
    /// When there are fewer partials than runs.
    pub fn ranges<P: Send>(
        &self,
        count: usize,
        partials: &mut [P],
        f: impl Fn(Range<usize>, &mut P) + Sync,
    ) {
        let partials = &mut partials[..count.div_ceil(CHUNK)];
        let range = |k: usize| k * CHUNK..count.min((k + 1) * CHUNK);
        match &self.pool {
            Some(pool) if count > CHUNK => pool.install(|| {
                partials.par_iter_mut().enumerate().for_each(|(k, p)| f(range(k), p));
            }),
            _ => partials.iter_mut().enumerate().for_each(|(k, p)| f(range(k), p)),
        }
    }

    /// `f` of each run of `per` (at least 1) items, in order.
    pub fn map<T: Sync, R: Send>(
        &self,
        items: &[T],
        per: usize,
        f: impl Fn(&[T]) -> R + Sync,
    ) -> Vec<R> {
        match &self.pool {
            Some(pool) if items.len() > per => {
                pool.install(|| items.par_chunks(per).map(&f).collect())
            }
            _ => items.chunks(per).map(f).collect(),
        }
    }

    /// `f` of each run of [`CHUNK`] (the last one may be shorter) of the numbers below `n`, in order.
    pub fn chunked<R: Send>(&self, n: usize, f: impl Fn(Range<usize>) -> R + Sync) -> Vec<R> {
        let chunks = n.div_ceil(CHUNK);
        match &self.pool {
            Some(pool) if chunks > 1 => pool.install(|| {
                let numbers = (0..chunks).into_par_iter();
                numbers.map(|chunk| f(chunk_at(chunk, n))).collect()
            }),
            _ => chunks_of(n).map(f).collect(),
        }
    }

    /// The smallest of what `f` finds of each run of [`CHUNK`] of the numbers below `n`; infinite where there are none. What is not a
    /// number is left out.
    pub fn smallest(&self, n: usize, f: impl Fn(Range<usize>) -> f64 + Sync) -> f64 {
        match &self.pool {
            Some(pool) if n > CHUNK => pool.install(|| {
                (0..n.div_ceil(CHUNK))
                    .into_par_iter()
                    .map(|k| f(k * CHUNK..n.min((k + 1) * CHUNK)))
                    .reduce(|| f64::INFINITY, f64::min)
            }),
            _ => chunks_of(n).map(f).fold(f64::INFINITY, f64::min),
        }
    }

    /// Sums of `f` over the numbers below `n`: within groups first, then over the tree of groups.
    pub fn sums<const N: usize>(&self, n: usize, f: impl Fn(usize) -> [f64; N] + Sync) -> [f64; N] {
        let add = |sum: [f64; N], x: [f64; N]| std::array::from_fn(|k| sum[k] + x[k]);
        let tree = |mut tree: Tree<N>, sum: [f64; N]| {
            tree.push(sum);
            tree
        };
        // A chunk is a branch of the tree.
        let chunk = |range: Range<usize>| {
            let groups = range.clone().step_by(GROUP);
            let one = |at: usize| (at..range.end.min(at + GROUP)).map(&f).fold([0.0; N], add);
            groups.map(one).fold(Tree::default(), tree).sum()
        };
        match &self.pool {
            Some(_) => self.chunked(n, chunk).into_iter().fold(Tree::default(), tree),
            // Without a list: a look on one thread allocates nothing.
            None => chunks_of(n).map(chunk).fold(Tree::default(), tree),
        }
        .sum()
    }

    /// Sum of `f` over the numbers below `n`, added as in [`Exec::sums`].
    pub fn sum(&self, n: usize, f: impl Fn(usize) -> f64 + Sync) -> f64 {
        let [sum] = self.sums(n, |k| [f(k)]);
        sum
    }

    /// What `f` finds with the largest number (in the total order of `f64`, where NaN stands above all); the last of
    /// equals.
    pub fn largest<T: Send>(
        &self,
        n: usize,
        f: impl Fn(usize) -> Option<(f64, T)> + Sync,
    ) -> Option<(f64, T)> {
        let later = |a: &(f64, T), b: &(f64, T)| a.0.total_cmp(&b.0);
        let one = |range: Range<usize>| range.filter_map(&f).max_by(later);
        match &self.pool {
            Some(_) => self.chunked(n, one).into_iter().flatten().max_by(later),
            None => chunks_of(n).filter_map(one).max_by(later),
        }
    }

    /// [`Exec::divided`] for the chunks `own` of `chunks` alone.
    pub fn divided_own<W: Divide>(
        &self,
        work: W,
        chunks: usize,
        own: Range<usize>,
        f: impl Fn(usize, W) + Sync,
    ) {
        if own.is_empty() {
            return;
        }
        let work = if own.start > 0 { work.divide(own.start).1 } else { work };
        let work = if own.end < chunks { work.divide(own.len()).0 } else { work };
        self.divided(work, own.len(), |chunk, piece| f(own.start + chunk, piece));
    }

    /// Calls `f(chunk, piece)` once for each of `chunks` chunks of `work`; on a pool in any order.
    pub fn divided<W: Divide>(&self, work: W, chunks: usize, f: impl Fn(usize, W) + Sync) {
        match &self.pool {
            Some(pool) if chunks > 1 => pool.install(|| halve(work, 0, chunks, &f)),
            _ => {
                let mut rest = work;
                for chunk in 0..chunks {
                    if chunk + 1 == chunks {
                        f(chunk, rest);
                        return;
                    }
                    let (first, others) = rest.divide(1);
                    f(chunk, first);
                    rest = others;
                }
            }
        }
    }
}

/// Runs `lead` on this thread as rank 0 of `size` ranks, and `follow` on a thread for each of the others; what all return. A rank that panics
/// is gone for the others, and returns nothing.
pub fn ranks<R, F: Send>(
    size: usize,
    lead: impl FnOnce(Arc<Peers>) -> R,
    follow: impl Fn(Arc<Peers>) -> F + Sync,
) -> (R, Vec<Option<F>>) {
    let mut links = channels(size.max(1)).into_iter().map(|link| Arc::new(Peers::new(link)));
    let first = links.next();
    std::thread::scope(|scope| {
        let follow = &follow;
        let threads: Vec<_> = links.map(|peers| scope.spawn(move || follow(peers))).collect();
        let Some(first) = first else { unreachable!("there is at least one rank") };
        let led = lead(first);
        (led, threads.into_iter().map(|thread| thread.join().ok()).collect())
    })
}

/// Run number `chunk` of [`CHUNK`] of the numbers below `n`.
fn chunk_at(chunk: usize, n: usize) -> Range<usize> {
    chunk * CHUNK..n.min((chunk + 1) * CHUNK)
}

/// All runs of [`CHUNK`] of the numbers below `n`, in order.
fn chunks_of(n: usize) -> impl Iterator<Item = Range<usize>> {
    (0..n.div_ceil(CHUNK)).map(move |chunk| chunk_at(chunk, n))
}

fn halve<W: Divide>(work: W, at: usize, chunks: usize, f: &(impl Fn(usize, W) + Sync)) {
    if chunks == 1 {
        f(at, work);
        return;
    }
    let middle = chunks / 2;
    let (first, others) = work.divide(middle);
    rayon::join(|| halve(first, at, middle, f), || halve(others, at + middle, chunks - middle, f));
}

/// Works on whole items side by side on `threads` threads and hands the results to `done` in the
/// order of the items, each as soon as all before it are there.
///
/// For independent runs (sweeps, verification); the order in which items are begun is theirs too.
///
/// # Panics
/// When `work` panics.
pub fn side_by_side<T: Sync, R: Send>(
    threads: usize,
    items: &[T],
    work: impl Fn(&T) -> R + Sync,
    mut done: impl FnMut(R),
) {
    let next = AtomicUsize::new(0);
    let (send, receive) = mpsc::channel();
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, items.len().max(1)) {
            let (send, next, work) = (send.clone(), &next, &work);
            scope.spawn(move || {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(index) else { return };
                    // The receiver lives until all senders are gone.
                    let _ = send.send((index, work(item)));
                }
            });
        }
        drop(send);
        let mut waiting = BTreeMap::new();
        let mut turn = 0;
        for (index, result) in receive {
            waiting.insert(index, result);
            while let Some(result) = waiting.remove(&turn) {
                done(result);
                turn += 1;
            }
        }
    });
}

/// Halves the work at chunk boundaries until one chunk is left.
fn split<A: Send, B: Send, P: Send>(
    at: usize,
    a: &mut [A],
    b: &mut [B],
    first: &[u32],
    partials: &mut [P],
    f: &(impl Fn(usize, &mut [A], &mut [B], &mut P) + Sync),
    parallel: bool,
) {
    if a.len() <= CHUNK {
        if let (false, Some(partial)) = (a.is_empty(), partials.first_mut()) {
            f(at, a, b, partial);
        }
        return;
    }
    let chunks = a.len().div_ceil(CHUNK) / 2;
    let middle = chunks * CHUNK;
    let (a0, a1) = a.split_at_mut(middle);
    let (b0, b1) = b.split_at_mut((first[at + middle] - first[at]) as usize);
    let (p0, p1) = partials.split_at_mut(chunks);
    if parallel {
        rayon::join(
            || split(at, a0, b0, first, p0, f, true),
            || split(at + middle, a1, b1, first, p1, f, true),
        );
    } else {
        split(at, a0, b0, first, p0, f, false);
        split(at + middle, a1, b1, first, p1, f, false);
    }
}

#[cfg(test)]
mod tests;
