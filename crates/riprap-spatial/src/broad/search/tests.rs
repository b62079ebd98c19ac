//! The candidate list against all pairs of blocks and all of their faces.

use riprap_geom::polyhedron::{Polyhedron, hull};
use riprap_geom::{Quat, Vec3};

use super::*;
use crate::broad::covered::NO_FACE;
use crate::kernel::Found;
use crate::kernel::kit::{Chance, Placed};
use crate::kernel::surface::Walker;

/// Bricks, tetrahedra and hulls of 8 to 20 points, some flat or long.
fn shape(chance: &mut Chance) -> Shape {
    loop {
        let count = [0, 4, 8, 14, 20][chance.below(5)];
        let half = Vec3::new(0.1 + chance.unit(), 0.1 + chance.unit(), 0.1 + chance.unit());
        let solid = if count == 0 {
            Polyhedron::brick(Vec3::ZERO, half)
        } else {
            let points: Vec<Vec3> = (0..count).map(|_| chance.direction() * half).collect();
            match hull(&points) {
                Ok(solid) => solid,
                Err(_) => continue,
            }
        };
        let centre = solid.vertices.iter().sum::<Vec3>() / solid.vertices.len() as f64;
        if let Ok(shape) = Shape::new(&solid, centre) {
            return shape;
        }
    }
}

/// `shape` enlarged.
fn scaled(shape: &Shape, by: f64) -> Shape {
    let mut shape = shape.clone();
    shape.vertices.iter_mut().for_each(|v| *v *= by);
    shape.offsets.iter_mut().for_each(|d| *d *= by);
    shape.areas.iter_mut().for_each(|a| *a *= by * by);
    shape.radius *= by;
    shape.inradius *= by;
    shape
}

/// Blocks of sizes 1 to `ratio` that fill a cube about once.
struct Heap {
    shapes: Vec<Shape>,
    shape: Vec<u32>,
    roles: Vec<Role>,
    pose: Vec<Pose>,
}

impl Heap {
    fn new(chance: &mut Chance, count: usize, ratio: f64) -> Self {
        let kinds: Vec<Shape> = (0..20).map(|_| shape(chance)).collect();
        let shapes: Vec<Shape> =
            (0..count).map(|k| scaled(&kinds[k % 20], libm::pow(ratio, chance.unit()))).collect();
        // Most sit near an earlier one, so that small ones meet large ones too.
        let edge = libm::cbrt(count as f64) * libm::sqrt(ratio);
        let mut pose: Vec<Pose> = Vec::with_capacity(count);
        for b in 0..count {
            let position = if b % 8 == 0 {
                edge * libm::cbrt(chance.unit()) * chance.direction()
            } else {
                let other = chance.below(b);
                let reach = shapes[b].radius + shapes[other].radius;
                let way = chance.direction() * reach;
                pose[other].position + way * (0.5 + 0.5 * chance.unit())
            };
            pose.push(Pose { position, rotation: chance.rotation() });
        }
        Self { shape: (0..count as u32).collect(), roles: vec![Role::Active; count], pose, shapes }
    }

    fn blocks(&self) -> Blocks<'_> {
        Blocks { shapes: &self.shapes, shape: &self.shape, roles: &self.roles, covered: &NO_FACE }
    }

    fn search(&self) -> Search {
        let mut search = Search::default();
        search.renew(&self.blocks(), |b| self.pose[b], |_| 0.0, 0.0);
        search
    }

    fn candidates(&self, search: &Search, threads: usize) -> Candidates {
        let mut candidates = Candidates::default();
        let exec = Exec::new(threads).unwrap();
        candidates.rebuild(&self.blocks(), search, &[None; 3], |_| false, |_| false, &exec);
        candidates
    }

    /// Moves every block as far as its margin allows, or nearly.
    fn shake(&mut self, search: &Search, chance: &mut Chance) {
        for (b, pose) in self.pose.iter_mut().enumerate() {
            let (start, margin, radius) = (search.pose[b], search.margin[b], self.shapes[b].radius);
            let share: f64 = chance.unit();
            let turned =
                |angle: f64, axis: Vec3| Quat::from_axis_angle(axis, angle) * start.rotation;
            *pose = Pose {
                position: start.position + chance.direction() * (0.999 * share * margin),
                rotation: turned(0.999 * (1.0 - share) * margin / radius, chance.direction()),
            };
            assert!(!search.leaves(b, radius, pose, 0.0));
        }
    }

    /// Planes of a pair at the present poses, and their peak.
    fn peak(&self, i: usize, j: usize) -> (Peak, Planes, Vec3) {
        let mut normals = [Vec::new(), Vec::new()];
        let ends = [i, j];
        let turns = [0, 1].map(|s: usize| {
            turn(&self.shapes[ends[s]], self.pose[ends[s]].rotation, &mut normals[s])
        });
        let bodies = [0, 1].map(|s: usize| Body {
            shape: &self.shapes[ends[s]],
            normals: &normals[s],
            turn: turns[s],
            position: self.pose[ends[s]].position,
        });
        let origin = planes::origin(&bodies[0], &bodies[1]);
        let mut lists = Planes::default();
        lists.gather_all([&bodies[0], &bodies[1]], origin);
        let far = 4.0 * (self.shapes[i].radius + self.shapes[j].radius);
        (peak(&lists, far), lists, origin)
    }

    /// Pairs that overlap now, by looking at all pairs.
    fn overlapping(&self) -> Vec<(usize, usize)> {
        let mut pairs = Vec::new();
        for i in 0..self.pose.len() {
            for j in i + 1..self.pose.len() {
                let apart = (self.pose[j].position - self.pose[i].position).length();
                if apart < self.shapes[i].radius + self.shapes[j].radius
                    && matches!(self.peak(i, j).0, Peak::Overlap { .. })
                {
                    pairs.push((i, j));
                }
            }
        }
        pairs
    }
}

/// The plane nearest to `x` among those from `first` to `last`, and its distance.
fn nearest(planes: &Planes, range: std::ops::Range<usize>, x: Vec3) -> (usize, f64) {
    let depth = |k: usize| planes.d[k] - planes.normal(k).dot(x);
    let start = range.start;
    range
        .map(|k| (k, depth(k)))
        .fold((start, f64::INFINITY), |best, one| if one.1 < best.1 { one } else { best })
}

#[test]
fn no_pair_and_no_face_is_missed_after_motions_within_the_margins() {
    let mut chance = Chance::new(7);
    let (mut pairs, mut points, mut left_out) = (0, 0, 0);
    for (count, ratio) in [(60, 1.0), (60, 10.0), (100, 1000.0)] {
        for _ in 0..2 {
            let mut heap = Heap::new(&mut chance, count, ratio);
            let search = heap.search();
            let candidates = heap.candidates(&search, 1);
            for _ in 0..2 {
                heap.shake(&search, &mut chance);
                for (i, j) in heap.overlapping() {
                    pairs += 1;
                    let key = [i as u32, j as u32];
                    let at = candidates.pairs.binary_search_by_key(&key, |c| c.ends);
                    let pair = &candidates.pairs[at.expect("an overlapping pair is listed")];
                    let lists = pair.faces(&candidates.lists);
                    let (Peak::Overlap { depth, at, .. }, planes, _) = heap.peak(i, j) else {
                        panic!("it overlaps")
                    };
                    let sides = [0..planes.split, planes.split..planes.len()];
                    left_out += planes.len() - lists[0].len() - lists[1].len();
                    // Points of the overlap: in the ball, and on the way from it to its boundary.
                    for _ in 0..30 {
                        let direction = chance.direction();
                        let reach = (0..planes.len())
                            .map(|k| {
                                let speed = planes.normal(k).dot(direction);
                                let room = planes.d[k] - planes.normal(k).dot(at);
                                if speed > 0.0 { room / speed } else { f64::INFINITY }
                            })
                            .fold(f64::INFINITY, f64::min);
                        let x = at + direction * (chance.unit() * reach);
                        let near = sides.clone().map(|side| nearest(&planes, side, x));
                        let s = usize::from(near[1].1 < near[0].1);
                        let face = (near[s].0 - sides[s].start) as u16;
                        assert!(
                            lists[s].contains(&face),
                            "face {face} of block {s} of ({i}, {j}) is nearest at a depth of {} of {depth}",
                            near[s].1
                        );
                        points += 1;
                    }
                }
            }
        }
    }
    println!("{pairs} overlapping pairs, {points} points, {left_out} faces left out");
    assert!(pairs > 500 && left_out > 10 * pairs, "{pairs} {left_out}");
}

#[test]
fn listed_faces_give_what_all_faces_give_after_motions_within_the_margins() {
    let mut chance = Chance::new(19);
    let (mut walker, mut pairs, mut largest) = (Walker::default(), 0, 0.0f64);
    for (count, ratio) in [(120, 1.0), (120, 30.0)] {
        let mut heap = Heap::new(&mut chance, count, ratio);
        let search = heap.search();
        let candidates = heap.candidates(&search, 1);
        for _ in 0..3 {
            heap.shake(&search, &mut chance);
            for pair in &candidates.pairs {
                let ends = pair.ends.map(|b| b as usize);
                let shapes = ends.map(|b| &heap.shapes[b]);
                let placed = Placed::new(shapes, ends.map(|b| heap.pose[b]));
                let whole = placed.find_all(&mut walker);
                let listed = placed.find(&mut walker, pair.faces(&candidates.lists), None);
                match (whole, listed) {
                    (Found::Touching(whole), Found::Touching(listed)) => {
                        assert_eq!([whole.unlabelled, listed.unlabelled], [0, 0]);
                        let size = whole.weight * shapes[0].radius.max(shapes[1].radius);
                        assert!((whole.force - listed.force).length() < 1e-10 * whole.weight);
                        assert!((whole.moment - listed.moment).length() < 1e-10 * size);
                        assert!((whole.area - listed.area).abs() < 1e-10 * whole.area);
                        largest = largest.max(whole.vector_area.length() / pair.area);
                        pairs += 1;
                    }
                    (whole, listed) => assert_eq!(whole, listed),
                }
            }
        }
    }
    println!("{pairs} touching pairs, area up to {largest} of what was foreseen");
    assert!(pairs > 500 && largest > 0.5 && largest < 1.5);
}

#[test]
fn blocks_apart_are_left_out_and_close_ones_are_not() {
    let shape = Shape::brick(Vec3::splat(0.5)).unwrap();
    let margin = MARGIN * shape.radius;
    for (gap, wanted) in [(1.9 * margin, 1), (2.1 * margin, 0)] {
        let heap = Heap {
            shapes: vec![shape.clone()],
            shape: vec![0; 2],
            roles: vec![Role::Active; 2],
            pose: vec![Pose::at(Vec3::ZERO), Pose::at(Vec3::new(0.05, 1.0 + gap, 0.2))],
        };
        let candidates = heap.candidates(&heap.search(), 1);
        assert_eq!(candidates.pairs.len(), wanted);
        if let [pair] = candidates.pairs[..] {
            // All but the far faces, and those that the other block's side cuts off.
            let faces: [&[u16]; 2] = [&[0, 1, 3, 5], &[0, 1, 2, 4]];
            assert_eq!(pair.faces(&candidates.lists), faces);
            assert!(pair.ties);
        }
    }
}

#[test]
fn the_list_is_the_same_for_any_number_of_threads_and_after_a_restart() {
    let mut chance = Chance::new(3);
    let heap = Heap::new(&mut chance, 1400, 20.0);
    let search = heap.search();
    let first = heap.candidates(&search, 1);
    let restored = search.clone();
    for other in [heap.candidates(&search, 3), heap.candidates(&restored, 2)] {
        assert_eq!(first.pairs, other.pairs);
        assert_eq!(first.lists, other.lists);
    }
    assert!(first.pairs.len() > 1400);
    // Made again in the same room after another list.
    let mut again = heap.candidates(&Heap::new(&mut chance, 1400, 5.0).search(), 1);
    again.rebuild(&heap.blocks(), &search, &[None; 3], |_| false, |_| false, &Exec::serial());
    assert_eq!((first.pairs, first.lists), (again.pairs, again.lists));
}

#[test]
fn the_order_of_the_blocks_changes_nothing_but_their_numbers() {
    let mut chance = Chance::new(11);
    let count = 300;
    let heap = Heap::new(&mut chance, count, 100.0);
    let mut order: Vec<usize> = (0..count).collect();
    for k in (1..count).rev() {
        order.swap(k, chance.below(k + 1));
    }
    let other = Heap {
        shapes: order.iter().map(|&b| heap.shapes[b].clone()).collect(),
        shape: heap.shape.clone(),
        roles: heap.roles.clone(),
        pose: order.iter().map(|&b| heap.pose[b]).collect(),
    };
    let listed = |heap: &Heap, name: &dyn Fn(u32) -> usize| {
        let candidates = heap.candidates(&heap.search(), 1);
        let mut pairs: Vec<_> = candidates
            .pairs
            .iter()
            .map(|c| {
                let mut sides = [(name(c.ends[0]), 0), (name(c.ends[1]), 1)];
                sides.sort_unstable();
                let faces = c.faces(&candidates.lists);
                (sides.map(|(b, s)| (b, faces[s].to_vec())), c.ties)
            })
            .collect();
        pairs.sort();
        pairs
    };
    let same = listed(&heap, &|b| b as usize);
    assert_eq!(same, listed(&other, &|b| order[b as usize]));
    assert!(same.len() > count);
}

#[test]
fn states_follow_their_pairs() {
    let mut chance = Chance::new(5);
    let heap = Heap::new(&mut chance, 60, 1.0);
    let candidates = heap.candidates(&heap.search(), 1);
    let keys: Vec<[u32; 2]> = candidates.pairs.iter().map(|c| c.ends).collect();
    assert!(keys.len() > 30);
    // Every other pair was there before, and two that have gone.
    let mut old: Vec<([u32; 2], usize)> = keys.iter().copied().zip(1..).step_by(2).collect();
    old.insert(0, ([0, 0], 0));
    old.push(([99, 100], 99));
    let mut lost = Vec::new();
    let old = old.into_iter().map(|(ends, state)| (PairKey::plain(ends), state));
    let states = candidates.carry(old, |_| 0, |pair, state| lost.push((pair.ends, state)));
    let wanted: Vec<usize> = (1..=keys.len()).map(|k| k * (k % 2)).collect();
    assert_eq!(states, wanted);
    assert_eq!(lost, [([0, 0], 0), ([99, 100], 99)]);
}

#[test]
fn margins_grow_with_speed_within_bounds() {
    let mut chance = Chance::new(9);
    let mut heap = Heap::new(&mut chance, 5, 1.0);
    heap.shapes = vec![Shape::brick(Vec3::splat(1.0)).unwrap(); 5];
    heap.shapes[4] = Shape::brick(Vec3::splat(100.0)).unwrap();
    let radius = heap.shapes[0].radius;
    let speeds = [0.0, 10.0, 1e9, f64::NAN, 0.0];
    let mut search = Search::default();
    search.renew(&heap.blocks(), |b| heap.pose[b], |b| speeds[b], 0.02);
    let wanted = [0.04, 0.2 / radius, 0.4, 0.4, 0.08 * radius / heap.shapes[4].radius];
    for (b, share) in wanted.into_iter().enumerate() {
        let margin = search.margin[b] / heap.shapes[b].radius;
        assert!((margin - share).abs() < 1e-12, "{b}: {margin}");
    }
}

#[test]
fn the_bound_of_the_way_holds_for_the_corners() {
    let mut chance = Chance::new(13);
    for _ in 0..1000 {
        let shape = shape(&mut chance);
        let pose = |chance: &mut Chance| Pose {
            position: chance.direction(),
            rotation: chance.rotation(),
        };
        let (from, to) = (pose(&mut chance), pose(&mut chance));
        let way = |v: &Vec3| (to.place(*v) - from.place(*v)).length();
        let farthest = shape.vertices.iter().map(way).fold(0.0, f64::max);
        assert!(farthest <= path_bound(&from, &to, shape.radius) * (1.0 + 1e-12));
    }
    // The same attitude has two quaternions.
    let q = chance.rotation();
    let turned = |rotation: Quat| Pose { position: Vec3::ZERO, rotation };
    assert_eq!(path_bound(&turned(q), &turned(-q), 1.0), 0.0);
}

/// Boxes that all look at, those that meet and the candidates, each per block, from 2000 to 32 000 blocks of about one size and of sizes
/// 1:1000. Counts, no times: they are the same in every run.
#[test]
fn cost_is_linear_in_the_number_of_blocks() {
    let mut chance = Chance::new(17);
    let kinds: Vec<Shape> = (0..20).map(|_| shape(&mut chance)).collect();
    for ratio in [1.0, 1000.0] {
        let each = [2_000, 8_000, 32_000].map(|count| {
            let heap = graded(&mut chance, &kinds, count, ratio);
            let mut candidates = heap.candidates(&heap.search(), 1);
            let (boxes, roles) = (&candidates.boxes, &heap.roles);
            let looks = candidates.grid.looks(boxes, roles);
            let serial = Exec::serial();
            let close = candidates.grid.close_pairs(boxes, roles, |_, _| false, &serial);
            let count = heap.pose.len() as f64;
            [looks, close.len(), candidates.pairs.len()].map(|n| n as f64 / count)
        });
        println!("sizes 1:{ratio}: {each:.2?}");
        // Of 9 x 9 x 30 blocks a third is skin, with fewer neighbours, and less where there are more: a quarter is left for that. If each
        // looked at all others, there would be four times as many.
        let looks = each.map(|each| each[0]);
        assert!(looks[1] < 1.25 * looks[0] && looks[2] < 1.25 * looks[1]);
        // 47 at most, of one size: boxes differ by up to five times and stand in cells up to twice as large as they are, of which each looks
        // into 27. Coarse ones are few, so that mixed sizes cost no more. There is about one meeting for each block.
        assert!(looks.iter().all(|looks| *looks < 60.0));
        assert!(each.iter().all(|each| each[1] < 2.0 && each[2] < 1.0));
    }
}

#[test]
#[ignore = "prints times: cargo test --release -p riprap-spatial --lib found::search -- --ignored --nocapture"]
fn time_of_the_search() {
    let mut chance = Chance::new(17);
    let kinds: Vec<Shape> = (0..20).map(|_| shape(&mut chance)).collect();
    for ratio in [1.0, 1000.0] {
        for count in [2_000, 20_000, 200_000] {
            let heap = graded(&mut chance, &kinds, count, ratio);
            let count = heap.pose.len();
            let search = heap.search();
            let exec = Exec::serial();
            let mut candidates = heap.candidates(&search, 1);
            let begin = std::time::Instant::now();
            candidates.rebuild(&heap.blocks(), &search, &[None; 3], |_| false, |_| false, &exec);
            let whole = begin.elapsed().as_secs_f64();
            let (boxes, roles) = (&candidates.boxes, &heap.roles);
            let begin = std::time::Instant::now();
            let close = candidates.grid.close_pairs(boxes, roles, |_, _| false, &exec).len();
            let grid = begin.elapsed().as_secs_f64();
            let begin = std::time::Instant::now();
            assert!(!candidates.outdated(
                &heap.blocks(),
                &search,
                |b| heap.pose[b],
                |_| 0.0,
                &exec
            ));
            let check = begin.elapsed().as_secs_f64();
            let each = |n: f64| n / count as f64;
            println!(
                "sizes 1:{ratio}, {count} blocks: {:.2} us a block (grid {:.2}), {:.1} close and {:.1} candidates a block, check {:.1} ns",
                1e6 * each(whole),
                1e6 * each(grid),
                each(close as f64),
                each(candidates.pairs.len() as f64),
                1e9 * each(check),
            );
        }
    }
}

/// Layers of blocks on top of each other, each layer of the same area and of blocks a tenth as large as the one below.
fn graded(chance: &mut Chance, kinds: &[Shape], count: usize, ratio: f64) -> Heap {
    let layers = if ratio > 1.0 { 4 } else { 1 };
    let (mut shapes, mut pose) = (Vec::new(), Vec::new());
    let finest = libm::sqrt(count as f64 / if ratio > 1.0 { 1.0 } else { 30.0 });
    let mut height = 0.0;
    for layer in 0..layers {
        let size = libm::pow(10.0, f64::from(layers - 1 - layer));
        let across = (finest / size).ceil() as usize;
        let rows = if ratio > 1.0 { 1 } else { 30 };
        for k in 0..across * across * rows {
            let [x, y, z] = [k % across, k / across % across, k / across / across]
                .map(|n| n as f64 + 0.1 * chance.unit());
            shapes.push(scaled(&kinds[k % kinds.len()], 0.7 * size));
            pose.push(Pose {
                position: Vec3::new(size * x, size * y, height + size * (0.5 + z)),
                rotation: chance.rotation(),
            });
        }
        height += size * rows as f64;
    }
    Heap {
        shape: (0..pose.len() as u32).collect(),
        roles: vec![Role::Active; pose.len()],
        shapes,
        pose,
    }
}
