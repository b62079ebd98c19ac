//! Rooms, the top-level modules of a crate: circles among them, and the floors on which they are.
//!
//! A crate with a file `floors.txt` lists its rooms there, one floor a line, the lowest first. A room may name rooms on
//! lower floors, and rooms to its left on its own floor. `allow contact -> read` admits what does not comply yet; an
//! entry that is not needed is an error. The root of a crate has no floor: it hands names on to other crates.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::graph::{self, Graph};
use super::source::{Crate, Words};
use crate::source_tree::shown;

/// Rooms in circles that a crate without floors still has. It may neither have more nor fewer: what is cured is taken
/// out here.
const IN_CIRCLES: [(&str, usize); 5] = [
    ("riprap-keys", 2),
    ("riprap-planar", 7),
    ("riprap-plot", 2),
    ("riprap-scenario", 9),
    ("riprap-view", 3),
];

/// Where the room of a module begins to name another room: file and line, for each pair of rooms and each file.
type Named = BTreeMap<(String, String), Vec<(String, usize)>>;

/// Prints the circles of rooms of a crate and every breach of its floors; how many breaches there are.
pub fn check(root: &Path, folder: &Path, name: &str, modules: &Crate) -> Result<u64, String> {
    let named = named(root, modules);
    let circles = circles(&named);
    for circle in &circles {
        println!("{name}: {} rooms in a circle: {circle}", circle.split(' ').count());
    }
    let file = folder.join("floors.txt");
    let wrong = if file.exists() {
        let text =
            std::fs::read_to_string(&file).map_err(|e| format!("{}: {e}", file.display()))?;
        against(&shown(root, &file), &text, &rooms(modules), &named)
    } else {
        let admitted = IN_CIRCLES.iter().find(|(n, _)| *n == name).map_or(0, |(_, count)| *count);
        against_count(name, &circles, admitted)
    };
    wrong.iter().for_each(|line| println!("{line}"));
    Ok(wrong.len() as u64)
}

/// `cargo xtask arrows CRATE rooms`: each room with the rooms that it names and the number of files that do.
pub fn print(root: &Path, modules: &Crate) {
    let named = named(root, modules);
    for room in rooms(modules) {
        let to = named.iter().filter(|((from, _), _)| *from == room);
        let to: Vec<String> = to.map(|((_, to), at)| format!("{to} {}", at.len())).collect();
        println!("{room} -> {}", to.join(", "));
    }
}

/// The room of a module; the root of the crate has none.
fn room(module: &Words) -> Option<&String> {
    module.get(1)
}

fn rooms(modules: &Crate) -> BTreeSet<String> {
    modules.keys().filter_map(room).cloned().collect()
}

fn named(root: &Path, modules: &Crate) -> Named {
    let mut found = Named::new();
    for ((from, to), line) in graph::named(modules) {
        let (Some(here), Some(there)) = (room(from), room(&to)) else { continue };
        if here != there {
            let file = shown(root, &modules[from].file);
            let all = found.entry((here.clone(), there.clone())).or_default();
            match all.iter_mut().find(|(f, _)| *f == file) {
                Some((_, first)) => *first = line.min(*first),
                None => all.push((file, line)),
            }
        }
    }
    found
}

/// The circles of rooms, each as the names of its rooms.
fn circles(named: &Named) -> Vec<String> {
    let mut arrows = Graph::new();
    for (from, to) in named.keys() {
        arrows.entry(vec![to.clone()]).or_default();
        arrows.entry(vec![from.clone()]).or_default().insert(vec![to.clone()]);
    }
    graph::circles(&arrows).iter().map(|circle| circle.concat().join(" ")).collect()
}

/// What is wrong with the circles of a crate without floors.
fn against_count(name: &str, circles: &[String], admitted: usize) -> Vec<String> {
    let count: usize = circles.iter().map(|circle| circle.split(' ').count()).sum();
    let says = format!("{name}: {count} rooms in circles, {admitted} admitted");
    match count.cmp(&admitted) {
        Ordering::Equal => Vec::new(),
        Ordering::Less => vec![format!("{says}: lower its entry in IN_CIRCLES")],
        Ordering::Greater => vec![format!("{says}: {}", circles.join("; "))],
    }
}

/// `floors.txt`.
#[derive(Debug, Default)]
struct Floors<'a> {
    /// Floor and place on it, for each room.
    places: BTreeMap<&'a str, (usize, usize)>,
    /// Line, and the two rooms.
    allowed: Vec<(usize, &'a str, &'a str)>,
}

/// What is wrong with a crate with floors, or with its `floors.txt`, named `file`.
fn against(file: &str, text: &str, rooms: &BTreeSet<String>, named: &Named) -> Vec<String> {
    let (floors, mut wrong) = read(file, text);
    let place = |room: &str| floors.places.get(room);
    let missing = rooms.iter().filter(|r| place(r).is_none());
    wrong.extend(missing.map(|r| format!("{file}: no floor has the room `{r}`")));
    let gone = floors.places.keys().filter(|r| !rooms.contains(**r));
    wrong.extend(gone.map(|r| format!("{file}: the crate has no room `{r}`")));
    let mut needed = BTreeSet::new();
    for ((from, to), at) in named {
        let (Some(a), Some(b)) = (place(from), place(to)) else { continue };
        if b < a {
            continue;
        }
        if floors.allowed.iter().any(|(_, f, t)| f == from && t == to) {
            needed.insert((from.as_str(), to.as_str()));
            continue;
        }
        let why = if a.0 == b.0 {
            format!("to its right on floor {}", a.0)
        } else {
            format!("floor {} above {}", b.0, a.0)
        };
        let line = |(at, line): &(String, usize)| format!("{at}:{line}: {from} names {to} ({why})");
        wrong.extend(at.iter().map(line));
    }
    let idle = floors.allowed.iter().filter(|(_, from, to)| !needed.contains(&(*from, *to)));
    wrong.extend(idle.map(|(line, from, to)| {
        format!("{file}:{line}: {from} names nothing above it in {to}: take this line out")
    }));
    wrong
}

/// The floors, and what cannot be read.
fn read<'a>(file: &str, text: &'a str) -> (Floors<'a>, Vec<String>) {
    let (mut floors, mut wrong, mut floor) = (Floors::default(), Vec::new(), 0);
    for (k, line) in text.lines().enumerate() {
        let words: Vec<&str> =
            line.split('#').next().unwrap_or_default().split_whitespace().collect();
        let number = k + 1;
        match words.as_slice() {
            [] => {}
            ["allow", from, "->", to] => floors.allowed.push((number, from, to)),
            ["allow", ..] => wrong.push(format!("{file}:{number}: write `allow room -> room`")),
            rooms => {
                floor += 1;
                for (place, room) in rooms.iter().enumerate() {
                    if floors.places.insert(room, (floor, place)).is_some() {
                        wrong.push(format!("{file}:{number}: `{room}` has a floor already"));
                    }
                }
            }
        }
    }
    (floors, wrong)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Breaches of `floors` by a crate, and its circles.
    pub(crate) fn breaches(modules: &Crate, floors: &str) -> (Vec<String>, Vec<String>) {
        let root = modules.values().next().and_then(|m| m.file.parent());
        let named = named(root.unwrap_or(Path::new("/")), modules);
        (against("floors.txt", floors, &rooms(modules), &named), circles(&named))
    }

    #[test]
    fn a_count_of_rooms_in_circles_neither_grows_nor_stays_above_the_truth() {
        let circles = ["a b".to_owned(), "c d e".to_owned()];
        assert!(against_count("x", &circles, 5).is_empty());
        assert_eq!(
            against_count("x", &circles, 4),
            ["x: 5 rooms in circles, 4 admitted: a b; c d e"]
        );
        assert!(against_count("x", &[], 2)[0].contains("lower its entry"));
    }
}
