//! Solids in OBJ: each closed convex part of each object is one.
//!
//! Read are the corners (`v`), the faces (`f`, also with corners counted back from the last) and the names of objects
//! (`o`) and groups (`g`); textures, normals, materials, lines and curves are passed over. Within an object corners at the same
//! place are one, as some programs write those of each face again; objects that touch stay apart.
//!
//! Source: Wavefront Technologies, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.

use std::collections::BTreeMap;

use riprap_geom::Vec3;

use super::stl::{Part, Surface, Triangles, parts, surface};
use super::{FileError, at_line, shown};

const NO_FACES: &str = "there are no faces: an OBJ file has lines `v x y z` and `f 1 2 3`";

/// A face: its corners by their place in the file, counted from 0, and its line.
type Face = (Vec<u32>, usize);

/// Faces under one name.
#[derive(Clone, Debug, Default, PartialEq)]
struct Object {
    name: Option<String>,
    faces: Vec<Face>,
}

/// A solid of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Name of its object or group.
    pub name: Option<String>,
    /// Its corners and its place.
    pub part: Part,
}

/// What an OBJ file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Obj {
    /// Corners in the length unit of the file.
    pub points: Vec<[f64; 3]>,
    objects: Vec<Object>,
    /// Faces of groups, where objects have names of their own: parts of them.
    groups: Vec<Object>,
    /// Lines, curves and points, which are no solids.
    pub others: usize,
}

/// The corners and faces that the bytes of a file describe.
///
/// # Errors
/// The first thing that is wrong, with its line.
pub fn parse_obj(bytes: &[u8]) -> Result<Obj, FileError> {
    let text = String::from_utf8_lossy(super::without_mark(bytes));
    let mut obj = Obj::default();
    let mut lines = (1..).zip(text.lines());
    while let Some((line, first)) = lines.next() {
        let mut words: Vec<&str> =
            first.split('#').next().unwrap_or("").split_whitespace().collect();
        // A line that ends so goes on in the next one.
        while words.last().is_some_and(|word| word.ends_with('\\')) {
            let last = words.pop().unwrap_or_default().trim_end_matches('\\');
            words.extend(Some(last).filter(|word| !word.is_empty()));
            words.extend(lines.next().map_or("", |(_, more)| more).split_whitespace());
        }
        let Some((key, rest)) = words.split_first() else {
            continue;
        };
        let name = || Some(rest.join(" ")).filter(|name| !name.is_empty());
        match *key {
            "v" => obj.point(line, rest)?,
            "f" => obj.face(line, rest)?,
            "o" => begin(&mut obj.objects, name()),
            "g" => begin(&mut obj.groups, name()),
            "l" | "p" | "curv" | "curv2" | "surf" => obj.others += 1,
            _ => {}
        }
    }
    if obj.points.is_empty() {
        return Err(at_line(
            1,
            "there are no vertices: an OBJ file has lines `v x y z` and `f 1 2 3`",
        ));
    }
    obj.objects.retain(|object| !object.faces.is_empty());
    obj.groups.retain(|group| !group.faces.is_empty());
    Ok(obj)
}

fn begin(list: &mut Vec<Object>, name: Option<String>) {
    list.push(Object { name, faces: Vec::new() });
}

impl Obj {
    fn point(&mut self, line: usize, words: &[&str]) -> Result<(), FileError> {
        let number = |k: usize| {
            let number = words.get(k).and_then(|word| word.parse::<f64>().ok());
            let number = number.filter(|x| x.is_finite());
            number.ok_or_else(|| at_line(line, "a vertex needs three numbers"))
        };
        self.points.push([number(0)?, number(1)?, number(2)?]);
        Ok(())
    }

    fn face(&mut self, line: usize, words: &[&str]) -> Result<(), FileError> {
        let count = self.points.len() as i64;
        let corner = |word: &&str| {
            let first = word.split('/').next().unwrap_or_default();
            let index = match first.parse::<i64>() {
                Ok(index) if index > 0 => index - 1,
                // Negative ones count back from the last corner.
                Ok(index) if index < 0 => count.saturating_add(index),
                Ok(_) | Err(_) => -1,
            };
            // A face may come before its corners; `whole` looks at that.
            u32::try_from(index)
                .map_err(|_| at_line(line, format!("`{}` is not a vertex", shown(first))))
        };
        let corners: Vec<u32> = words.iter().map(corner).collect::<Result<_, _>>()?;
        if corners.len() < 3 {
            return Err(at_line(line, "a face needs three vertices"));
        }
        for list in [&mut self.objects, &mut self.groups] {
            if list.is_empty() {
                list.push(Object::default());
            }
            if let Some(object) = list.last_mut() {
                object.faces.push((corners.clone(), line));
            }
        }
        Ok(())
    }

    /// All faces, corners by their place in `points`. None where the file has corners alone.
    #[must_use]
    pub fn faces(&self) -> Vec<Vec<u32>> {
        let faces = self.objects.iter().flat_map(|object| &object.faces);
        faces.map(|(corners, _)| corners.clone()).collect()
    }

    /// Number of faces.
    #[must_use]
    pub fn count(&self) -> usize {
        self.objects.iter().map(|object| object.faces.len()).sum()
    }

    /// The closed convex parts of all objects, or of all groups where objects are not told apart.
    ///
    /// # Errors
    /// A part that is open or not convex, with its line.
    pub fn solids(&self) -> Result<Vec<Solid>, FileError> {
        let named = |list: &[Object]| list.len() > 1 || list.iter().any(|o| o.name.is_some());
        if named(&self.objects) {
            return self.parts_of(&self.objects);
        }
        if named(&self.groups)
            && let Ok(solids) = self.parts_of(&self.groups)
        {
            return Ok(solids);
        }
        // Groups may be sides of one solid.
        self.parts_of(&self.objects)
    }

    /// The triangles under each name.
    fn triangles(&self, objects: &[Object]) -> Result<Vec<(Option<String>, Triangles)>, FileError> {
        // A name may come again: faces of one object, some here and some there.
        let mut order: BTreeMap<Option<&str>, usize> = BTreeMap::new();
        let mut lists: Vec<(Option<String>, Triangles)> = Vec::new();
        for object in objects {
            let place = *order.entry(object.name.as_deref()).or_insert(lists.len());
            if place == lists.len() {
                lists.push((object.name.clone(), Triangles::default()));
            }
            for (corners, line) in &object.faces {
                let at = |corner: &u32| {
                    let point = self.points.get(*corner as usize);
                    let missing = || {
                        let (corner, count) = (*corner + 1, self.points.len());
                        at_line(
                            *line,
                            format!("vertex `{corner}` does not exist: the file has {count}"),
                        )
                    };
                    // -0 is 0.
                    point.map(|p| Vec3::from_array(*p) + Vec3::ZERO).ok_or_else(missing)
                };
                let ring: Vec<Vec3> = corners.iter().map(at).collect::<Result<_, _>>()?;
                for k in 2..ring.len() {
                    let triangles = &mut lists[place].1;
                    triangles.corners.push([ring[0], ring[k - 1], ring[k]]);
                    triangles.lines.push(*line);
                }
            }
        }
        Ok(lists)
    }

    /// All faces as one surface.
    ///
    /// # Errors
    /// A corner that is not there, with its line; no faces.
    pub fn surface(&self) -> Result<Surface, FileError> {
        let lists = self.triangles(&self.objects)?;
        let corners: Vec<[Vec3; 3]> =
            lists.into_iter().flat_map(|(_, triangles)| triangles.corners).collect();
        if corners.is_empty() {
            return Err(at_line(1, NO_FACES));
        }
        Ok(surface(&corners))
    }

    fn parts_of(&self, objects: &[Object]) -> Result<Vec<Solid>, FileError> {
        let mut solids = Vec::new();
        for (name, triangles) in self.triangles(objects)? {
            let found = parts(&triangles).map_err(|error| match &name {
                Some(name) => {
                    FileError { text: format!("object `{}`, {}", shown(name), error.text), ..error }
                }
                None => error,
            })?;
            solids.extend(found.into_iter().map(|part| Solid { name: name.clone(), part }));
        }
        if solids.is_empty() {
            return Err(at_line(1, NO_FACES));
        }
        Ok(solids)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube(name: &str, z: f64, first: Option<i64>) -> String {
        let mut text = format!("{name}\n");
        for (x, y, up) in [
            (0, 0, 0.),
            (1, 0, 0.),
            (1, 1, 0.),
            (0, 1, 0.),
            (0, 0, 1.),
            (1, 0, 1.),
            (1, 1, 1.),
            (0, 1, 1.),
        ] {
            text.push_str(&format!("v {x} {y} {}\n", z + up));
        }
        for face in
            [[1, 4, 3, 2], [5, 6, 7, 8], [1, 2, 6, 5], [2, 3, 7, 6], [3, 4, 8, 7], [4, 1, 5, 8]]
        {
            // Counted from the first corner of the file, or back from the last one so far.
            let words = face.map(|k: i64| match first {
                Some(first) => format!("{}/1/1", k + first),
                None => (k - 9).to_string(),
            });
            text.push_str(&format!("f {}\n", words.join(" ")));
        }
        text
    }

    fn solids(text: &str) -> Vec<(Option<String>, usize)> {
        let solids = parse_obj(text.as_bytes()).unwrap().solids().unwrap();
        let solids = solids.into_iter();
        solids.map(|s| (s.name, s.part.points.len())).collect()
    }

    #[test]
    fn objects_that_touch_stay_apart() {
        let named = |name: &str| (Some(name.to_owned()), 8);
        let two = format!("{}{}", cube("o lower", 0.0, Some(0)), cube("o upper", 1.0, None));
        assert_eq!(solids(&two), [named("lower"), named("upper")]);
        let groups = two.replace("o lower", "g lower").replace("o upper", "g upper");
        assert_eq!(solids(&groups), [named("lower"), named("upper")]);
        // One name, and parts that do not touch.
        let apart = format!("{}{}", cube("o stones", 0.0, Some(0)), cube("", 3.0, None));
        assert_eq!(solids(&apart), [named("stones"), named("stones")]);
        // Groups that are sides of one solid.
        let sides = cube("", 0.0, None).replacen("f ", "g bottom\nf ", 1).replacen(
            "f -4",
            "g rest\nf -4",
            1,
        );
        assert_eq!(solids(&sides), [(None, 8)]);
        let parted = cube("o a", 0.0, None).replace("f -8 -5", "f -8 \\\n-5");
        assert_eq!(solids(&parted), [named("a")]);
    }

    #[test]
    fn says_what_is_wrong() {
        let wrong = |text: &str| match parse_obj(text.as_bytes()) {
            Ok(obj) => obj.solids().unwrap_err().to_string(),
            Err(error) => error.to_string(),
        };
        assert!(wrong("").contains("no vertices"));
        assert!(wrong("v 0 0 0\n").contains("no faces"));
        assert!(wrong("v 0 0\n").contains("line 1: a vertex needs three numbers"));
        assert!(wrong("v 0 0 0\nf 1 2\n").contains("line 2: a face needs three vertices"));
        assert!(wrong("v 0 0 0\nf 1 0 1\n").contains("`0` is not a vertex"));
        assert!(wrong("v 0 0 0\nf -1 -2 -1\n").contains("`-2` is not a vertex"));
        assert!(wrong("v 0 0 0\nf 1 9 1\n").contains("vertex `9` does not exist: the file has 1"));
        let open = cube("o box", 0.0, None).replace("f -4 -3 -2 -1\n", "");
        assert!(wrong(&open).contains("object `box`, part 1 is not closed"), "{}", wrong(&open));
    }
}
