//! Blocks of a drawing, and where they are inserted.

use std::collections::BTreeMap;

use super::super::dxf_pairs::Pairs;
use super::{Content, Drawing, Entity, FileError, Kind, Place, Polyline, Reading, Why, entities};
use crate::foreign::{at_byte, at_line};

/// Most blocks in each other.
const DEEPEST: usize = 16;
/// Most insertions of one entity along a row or a column.
const MOST_COPIES: f64 = 10_000.0;

/// A block of a drawing.
#[derive(Default)]
pub(super) struct Block {
    content: Content,
    /// The point of it that comes to the point of insertion.
    base: [f64; 2],
}

/// A place at which a block stands.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Insert {
    name: String,
    layer: String,
    at: [f64; 2],
    scale: [f64; 2],
    /// Angle anticlockwise.
    turn: f64,
    copies: [u32; 2],
    spacing: [f64; 2],
    /// Whether its plane is seen from behind: x runs the other way.
    mirrored: bool,
    upright: bool,
    place: Place,
}

impl Insert {
    pub(super) fn of(entity: &Entity) -> Self {
        let at = entity.points.first().map_or([0.0; 2], |p| [p[0], p[1]]);
        let copies = [70, 71].map(|code| entity.number(code, 1.0).clamp(1.0, MOST_COPIES) as u32);
        let flat = entity.normal.x == 0.0 && entity.normal.y == 0.0;
        Insert {
            name: entity.name.clone(),
            layer: entity.layer.clone(),
            at,
            scale: [41, 42].map(|code| entity.number(code, 1.0)),
            turn: entity.number(50, 0.0).to_radians(),
            copies,
            spacing: [44, 45].map(|code| entity.number(code, 0.0)),
            mirrored: entity.normal.z < 0.0,
            upright: !flat,
            place: entity.place,
        }
    }
}

/// Where a block stands: turned and scaled, then shifted.
#[derive(Clone, Copy)]
struct Frame {
    x: [f64; 2],
    y: [f64; 2],
    at: [f64; 2],
}

impl Frame {
    const WORLD: Frame = Frame { x: [1.0, 0.0], y: [0.0, 1.0], at: [0.0, 0.0] };

    fn turned(&self, p: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| p[0] * self.x[k] + p[1] * self.y[k])
    }

    fn place(&self, p: [f64; 2]) -> [f64; 2] {
        let turned = self.turned(p);
        [0, 1].map(|k| self.at[k] + turned[k])
    }

    /// That of a copy of a block in this one.
    fn of(&self, insert: &Insert, base: [f64; 2], copy: [u32; 2]) -> Frame {
        let (sin, cos) = (libm::sin(insert.turn), libm::cos(insert.turn));
        let mirror = if insert.mirrored { -1.0 } else { 1.0 };
        let local = |x: f64, y: f64| [mirror * (cos * x - sin * y), sin * x + cos * y];
        let shift = [0, 1].map(|k| f64::from(copy[k]) * insert.spacing[k]);
        let (shift, x, y) =
            (local(shift[0], shift[1]), local(insert.scale[0], 0.0), local(0.0, insert.scale[1]));
        let back = [0, 1].map(|k| base[0] * x[k] + base[1] * y[k]);
        let at = [mirror * insert.at[0], insert.at[1]];
        let at = [0, 1].map(|k| at[k] + shift[k] - back[k]);
        Frame { x: self.turned(x), y: self.turned(y), at: self.place(at) }
    }
}

/// Reads the section of blocks.
pub(super) fn blocks(
    pairs: &mut Pairs,
    blocks: &mut BTreeMap<String, Block>,
    reading: &mut Reading,
) -> Result<(), FileError> {
    loop {
        let Some((code, value)) = super::section_goes_on(pairs)? else {
            return Ok(());
        };
        if code != 0 || value.text() != "BLOCK" {
            continue;
        }
        let (mut name, mut block) = (String::new(), Block::default());
        // The head of a block ends with its first entity, which begins with the code 0.
        let mut first = None;
        while let Some((code, value)) = super::section_goes_on(pairs)? {
            match code {
                0 => {
                    first = Some(value.text().into_owned());
                    break;
                }
                2 => name = pairs.name(value),
                10 => block.base[0] = pairs.real(value)?,
                20 => block.base[1] = pairs.real(value)?,
                _ => {}
            }
        }
        let more = match first.as_deref() {
            None => return Ok(()),
            Some("ENDBLK") => true,
            Some(word) => entities(pairs, &mut block.content, reading, word)?,
        };
        // Spaces are blocks too; what they hold stands among the entities.
        if !name.starts_with('*') || !name.to_uppercase().ends_with("_SPACE") {
            blocks.insert(name, block);
        }
        if !more {
            return Ok(());
        }
    }
}

/// Puts the lines of the drawing, and of the blocks that are inserted in it, into the drawing.
pub(super) fn expand(
    drawing: &mut Drawing,
    content: Content,
    blocks: &BTreeMap<String, Block>,
    reading: &mut Reading,
) -> Result<(), FileError> {
    let Content { lines, inserts, faces, left_out } = content;
    drawing.lines.extend(lines);
    drawing.faces.extend(faces);
    for (what, count) in left_out {
        *drawing.left_out.entry(what).or_default() += count;
    }
    let mut work = Work { drawing, blocks, room: reading.room };
    for insert in &inserts {
        work.insert(insert, "0", &Frame::WORLD, &mut Vec::new())?;
    }
    Ok(())
}

struct Work<'a> {
    drawing: &'a mut Drawing,
    blocks: &'a BTreeMap<String, Block>,
    /// Points and insertions that there is room for.
    room: usize,
}

impl<'a> Work<'a> {
    fn leave_out(&mut self, why: Why, count: usize) {
        let what = (Kind::Insert.word().to_owned(), why);
        *self.drawing.left_out.entry(what).or_default() += count;
    }

    /// Inserts a block, which stands in the blocks `inside`.
    fn insert(
        &mut self,
        insert: &Insert,
        layer: &str,
        frame: &Frame,
        inside: &mut Vec<&'a str>,
    ) -> Result<(), FileError> {
        let wrong = |text: String| match insert.place {
            Place::Line(line) => at_line(line, text),
            Place::Byte(byte) => at_byte(byte, text),
        };
        let Some((name, block)) = self.blocks.get_key_value(&insert.name) else {
            self.leave_out("of blocks that are not in the file", 1);
            return Ok(());
        };
        if insert.upright {
            self.leave_out("not in a plane z", 1);
            return Ok(());
        }
        if inside.len() >= DEEPEST || inside.contains(&name.as_str()) {
            let text = format!(
                "block {:?} contains itself, or blocks are nested more than {DEEPEST} levels deep",
                super::shown(name)
            );
            return Err(wrong(text));
        }
        // The layer 0 in a block is that of the place where it stands.
        let own = |of: &str, place: &str| if of == "0" { place } else { of }.to_owned();
        let here = own(&insert.layer, layer);
        inside.push(name);
        for row in 0..insert.copies[1] {
            for column in 0..insert.copies[0] {
                let frame = frame.of(insert, block.base, [column, row]);
                let points: usize = block.content.lines.iter().map(|l| l.points.len()).sum();
                let needed = points + block.content.inserts.len() + 1;
                let room = self.room.checked_sub(needed);
                let many = super::MAX_POINTS;
                let text = || wrong(format!("block references expand to more than {many} points"));
                self.room = room.ok_or_else(text)?;
                let lines = block.content.lines.iter();
                self.drawing.lines.extend(lines.map(|line| Polyline {
                    layer: own(&line.layer, &here),
                    points: line.points.iter().map(|p| frame.place(*p)).collect(),
                    ..line.clone()
                }));
                for inner in &block.content.inserts {
                    self.insert(inner, &here, &frame, inside)?;
                }
                for (what, count) in &block.content.left_out {
                    *self.drawing.left_out.entry(what.clone()).or_default() += count;
                }
                self.drawing.inserted += 1;
            }
        }
        inside.pop();
        Ok(())
    }
}
