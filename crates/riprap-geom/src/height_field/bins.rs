//! Which triangles lie near a place: square bins over the projection of a surface.

use super::HeightField;

/// Bins for each triangle, about.
const PER_TRIANGLE: f64 = 0.5;
/// Most entries in all bins for each triangle, and how many are never too many. Thin triangles askew to the axes, as in a fan, reach
/// into bins all over the surface with their boxes: larger bins then take less memory and no more time.
const ENTRIES: (u64, u64) = (64, 1 << 20);
/// Most bins along an axis.
const MOST: f64 = 8192.0;

/// First and last bin along x and y.
type Range = [[usize; 2]; 2];

/// How many entries the bins of some rectangles have.
fn entries(boxes: &[Range]) -> u64 {
    let one = |[from, to]: &Range| {
        let along = [0, 1].map(|k| (to[k] - from[k] + 1) as u64);
        along[0] * along[1]
    };
    boxes.iter().map(one).sum()
}

/// Triangles by place. Every bin lists the triangles whose box in the plane reaches into it, ascending.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bins {
    low: [f64; 2],
    size: f64,
    counts: [usize; 2],
    first: Vec<u32>,
    members: Vec<u32>,
}

impl Bins {
    /// Sorts the triangles of a surface.
    #[must_use]
    pub fn new(surface: &HeightField) -> Self {
        let (low, high) = surface.bounds();
        let extent = (high - low).truncate();
        let wanted = PER_TRIANGLE * surface.triangles.len() as f64;
        let size = (extent.x * extent.y / wanted.max(1.0))
            .sqrt()
            // Else a long and narrow surface would have any number of bins along it.
            .max(extent.max_element() / MOST);
        let mut bins = Self { low: [low.x, low.y], size, ..Self::default() };
        let triangles = surface.triangles.len() as u64;
        let most = (ENTRIES.0 * triangles).max(ENTRIES.1).min(u64::from(u32::MAX));
        let boxes = loop {
            bins.counts = [extent.x, extent.y].map(|length| (length / bins.size) as usize + 1);
            let boxes = bins.boxes(surface);
            // With one bin each triangle is in it once.
            if entries(&boxes) <= most || bins.counts == [1; 2] {
                break boxes;
            }
            bins.size *= 2.0;
        };
        let [nx, ny] = bins.counts;
        // Counted first, so that all lists lie in one array.
        let mut first = vec![0_u32; nx * ny + 1];
        let each = |[from, to]: &Range, act: &mut dyn FnMut(usize)| {
            for j in from[1]..=to[1] {
                for i in from[0]..=to[0] {
                    act(j * nx + i);
                }
            }
        };
        for range in &boxes {
            each(range, &mut |bin| first[bin + 1] += 1);
        }
        for bin in 1..first.len() {
            first[bin] += first[bin - 1];
        }
        let mut members = vec![0; first[nx * ny] as usize];
        let mut next = first.clone();
        for (t, range) in (0_u32..).zip(&boxes) {
            each(range, &mut |bin| {
                members[next[bin] as usize] = t;
                next[bin] += 1;
            });
        }
        bins.first = first;
        bins.members = members;
        bins
    }

    /// First and last bin along x and y of each triangle.
    fn boxes(&self, surface: &HeightField) -> Vec<Range> {
        let boxes = (0..surface.triangles.len()).map(|t| {
            let [a, b, c] = surface.corners(t);
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            self.range([low.x, low.y], [high.x, high.y])
        });
        boxes.collect()
    }

    /// First and last bin along x and y of a rectangle; those outside count to the outermost bins.
    fn range(&self, low: [f64; 2], high: [f64; 2]) -> Range {
        let number = |at: [f64; 2]| {
            [0, 1].map(|k: usize| {
                let cell = (at[k] - self.low[k]) / self.size;
                (cell.max(0.0) as usize).min(self.counts[k] - 1)
            })
        };
        [number(low), number(high)]
    }

    fn list(&self, bin: usize) -> &[u32] {
        &self.members[self.first[bin] as usize..self.first[bin + 1] as usize]
    }

    /// The lists of all bins.
    pub(super) fn lists(&self) -> impl Iterator<Item = &[u32]> {
        (0..self.counts[0] * self.counts[1]).map(|bin| self.list(bin))
    }

    /// Triangles near a place.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> &[u32] {
        let [[i, j], _] = self.range([x, y], [x, y]);
        self.list(j * self.counts[0] + i)
    }

    /// Puts the triangles near a rectangle into `found`, ascending, each once.
    pub fn near(&self, low: [f64; 2], high: [f64; 2], found: &mut Vec<u32>) {
        found.clear();
        let [from, to] = self.range(low, high);
        for j in from[1]..=to[1] {
            for i in from[0]..=to[0] {
                found.extend_from_slice(self.list(j * self.counts[0] + i));
            }
        }
        // A triangle is in every bin that its box reaches into.
        found.sort_unstable();
        found.dedup();
    }
}
