//! Edges to faces: what separates nothing is removed, the rest is walked round.

use std::collections::BTreeMap;

use super::Removed;
use crate::Vec2;
use crate::polygon::{signed_area, turn};

/// Neighbours of every point, sorted by direction (anticlockwise).
struct Graph {
    neighbours: Vec<Vec<u32>>,
}

impl Graph {
    fn new(points: &[Vec2], edges: &BTreeMap<(u32, u32), bool>) -> Graph {
        let mut neighbours = vec![Vec::new(); points.len()];
        for &(a, b) in edges.keys() {
            neighbours[a as usize].push(b);
            neighbours[b as usize].push(a);
        }
        for (v, around) in neighbours.iter_mut().enumerate() {
            let centre = points[v];
            // By half planes and turns: no angle has to be found, and rounded.
            let upper = |p: Vec2| p.y > centre.y || (p.y == centre.y && p.x > centre.x);
            around.sort_by(|&a, &b| {
                let (pa, pb) = (points[a as usize], points[b as usize]);
                upper(pb)
                    .cmp(&upper(pa))
                    // The sum makes -0 a 0, which the total order tells apart.
                    .then_with(|| 0.0f64.total_cmp(&(turn(centre, pa, pb) + 0.0)))
                    .then(a.cmp(&b))
            });
        }
        Graph { neighbours }
    }

    fn remove(&mut self, a: u32, b: u32) {
        self.neighbours[a as usize].retain(|&n| n != b);
        self.neighbours[b as usize].retain(|&n| n != a);
    }

    /// Remove edges with a free end until there is none; how many.
    fn remove_dead_ends(&mut self) -> usize {
        let mut removed = 0;
        let mut free: Vec<u32> =
            (0..self.neighbours.len() as u32).filter(|&v| self.degree(v) == 1).collect();
        while let Some(v) = free.pop() {
            if let Some(&w) = self.neighbours[v as usize].first() {
                self.remove(v, w);
                removed += 1;
                if self.degree(w) == 1 {
                    free.push(w);
                }
            }
        }
        removed
    }

    fn degree(&self, v: u32) -> usize {
        self.neighbours[v as usize].len()
    }

    /// Remove everything that is not connected with point 0; how many edges.
    fn remove_islands(&mut self) -> usize {
        let mut reached = vec![false; self.neighbours.len()];
        let mut queue = vec![0u32];
        reached[0] = true;
        while let Some(v) = queue.pop() {
            for &w in &self.neighbours[v as usize] {
                if !reached[w as usize] {
                    reached[w as usize] = true;
                    queue.push(w);
                }
            }
        }
        let mut ends = 0;
        for (v, around) in self.neighbours.iter_mut().enumerate() {
            if !reached[v] {
                ends += around.len();
                around.clear();
            }
        }
        ends / 2
    }

    /// All loops with their left side inside: at each point the next edge clockwise from the one
    /// just walked.
    fn loops(&self) -> Vec<Vec<u32>> {
        let mut walked: Vec<Vec<bool>> =
            self.neighbours.iter().map(|n| vec![false; n.len()]).collect();
        let mut loops = Vec::new();
        for v in 0..self.neighbours.len() {
            for k in 0..self.neighbours[v].len() {
                if walked[v][k] {
                    continue;
                }
                let mut face = Vec::new();
                let (mut at, mut slot) = (v, k);
                while !walked[at][slot] {
                    walked[at][slot] = true;
                    face.push(at as u32);
                    let next = self.neighbours[at][slot] as usize;
                    let around = &self.neighbours[next];
                    // The edge just walked is in the list of its other end by construction.
                    let back = around.iter().position(|&n| n as usize == at).unwrap_or(0);
                    slot = (back + around.len() - 1) % around.len();
                    at = next;
                }
                loops.push(face);
            }
        }
        loops
    }
}

/// The inner faces, anticlockwise. `Err` holds a place where the edges do not make faces.
pub(super) fn trace(
    points: &[Vec2],
    edges: BTreeMap<(u32, u32), bool>,
    outline: usize,
) -> Result<(Vec<Vec<u32>>, Removed), Vec2> {
    let mut graph = Graph::new(points, &edges);
    let mut removed = Removed::default();
    loop {
        removed.dead_ends += graph.remove_dead_ends();
        removed.islands += graph.remove_islands();
        let loops = graph.loops();
        let useless = useless_edges(points, &loops);
        if !useless.is_empty() {
            removed.islands += useless.len();
            for (a, b) in useless {
                if edges.get(&(a, b)).copied().unwrap_or(false) {
                    return Err(points[a as usize]);
                }
                graph.remove(a, b);
            }
            continue;
        }
        let mut faces = Vec::with_capacity(loops.len());
        let mut outer = 0;
        for face in loops {
            if area(points, &face) > 0.0 {
                faces.push(face);
            } else if face.iter().any(|&p| (p as usize) < outline) {
                outer += 1;
            } else {
                return Err(points[face[0] as usize]);
            }
        }
        return if outer == 1 && !faces.is_empty() { Ok((faces, removed)) } else { Err(points[0]) };
    }
}

fn area(points: &[Vec2], face: &[u32]) -> f64 {
    let outline: Vec<Vec2> = face.iter().map(|&p| points[p as usize]).collect();
    signed_area(&outline)
}

/// Edges with one face on both sides, and edges of loops that hang on a single point of a face.
fn useless_edges(points: &[Vec2], loops: &[Vec<u32>]) -> Vec<(u32, u32)> {
    let mut useless = Vec::new();
    let mut seen: Vec<(u32, u32)> = Vec::new();
    for face in loops {
        seen.clear();
        seen.extend(face.iter().enumerate().map(|(k, &p)| (p, k as u32)));
        seen.sort_unstable();
        if seen.windows(2).all(|pair| pair[0].0 != pair[1].0) || area(points, face) <= 0.0 {
            continue;
        }
        let mut sides: Vec<(u32, u32)> = (0..face.len())
            .map(|k| {
                let (a, b) = (face[k], face[(k + 1) % face.len()]);
                (a.min(b), a.max(b))
            })
            .collect();
        sides.sort_unstable();
        let bridges = sides.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]);
        let before = useless.len();
        useless.extend(bridges);
        if useless.len() > before {
            continue;
        }
        // A point visited twice: of the two parts, the clockwise one is a hole hanging there.
        if let Some(pair) = seen.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let (from, to) = (pair[0].1 as usize, pair[1].1 as usize);
            let inner = &face[from..to];
            let rest: Vec<u32> = face[to..].iter().chain(&face[..from]).copied().collect();
            let hole = if area(points, inner) < area(points, &rest) { inner } else { &rest[..] };
            for k in 0..hole.len() {
                let (a, b) = (hole[k], hole[(k + 1) % hole.len()]);
                useless.push((a.min(b), a.max(b)));
            }
        }
    }
    useless.sort_unstable();
    useless.dedup();
    useless
}
