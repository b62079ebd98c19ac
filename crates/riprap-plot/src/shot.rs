//! Blocks in space as they stand, without a browser: a parallel or a perspective picture, drawn point by point by its depth.
//!
//! Faces that look away are left out. Behind a cut they are not: as blocks do not overlap, a point whose nearest face looks away lies in a
//! block that the cut goes through, and has the plain colour of that block.

mod camera;
mod chains;
mod contacts;
mod drawing;
mod film;
mod kinds;
mod light;
mod notes;
mod rods;
mod trails;
mod views;
mod wanted;

use std::path::{Path, PathBuf};

use resvg::tiny_skia::{ColorU8, Pixmap};
use riprap_geom::Vec3;
use riprap_record::frame::Frame;
use riprap_record::manifest::Manifest;
use riprap_record::write_whole;

use super::blocks::{bar, chips_of, colours};
use super::drawing::{Chosen, choose};
use super::foot::{Foot, Piece};
use super::frames::moment;
use super::load::{Which, listed};
use super::run::Run;
use super::section::need_space;
use super::svg::Page;
use super::{Look, PlotError, bolts};
use camera::{Camera, Window};
use drawing::Drawing;
use kinds::Kinds;
use light::Light;
use trails::Ways;
pub use views::Asked;
pub use wanted::{CHANGED, Cut, Eye, Note, Shot, Trails};
use wanted::{FINE, TITLE, failed, rgb};

/// Room for the legend, and around the lines below, pixels.
const LEGEND: f64 = 140.0;
const FOOT: f64 = 7.0;
const SIDE: f64 = 12.0;
/// Pictures of a film in a second.
const RATES: std::ops::RangeInclusive<f64> = 0.1..=60.0;

/// Draws frames of a run in space, all of them where none is named, with one window and one range of colours: PNG, several of them
/// numbered, or where the file ends in `.apng` one animated PNG with so many pictures a second.
///
/// # Errors
/// A run in the plane, unknown fields, options without sense, files that cannot be read or written.
pub fn shots<'r>(
    run: impl Into<Run<'r>>,
    frames: &[Which],
    shot: &Shot,
    rate: Option<f64>,
    out: &Path,
) -> Result<Vec<PathBuf>, PlotError> {
    let run = run.into();
    let folder = run.folder;
    shot.checked()?;
    let animated = is_film(out);
    check_rate(rate, animated)?;
    let manifest = Manifest::read(folder)?;
    let all: Vec<Which> = match frames {
        [] => (1..=listed(folder)?.len()).map(Which::Index).collect(),
        some => some.to_vec(),
    };
    let seen = Seen::by(run, &all, shot, &manifest.materials)?;
    let picture = |which: Which| {
        let frame = run.frame(which)?;
        let suffix = run.suffix(&manifest, &moment(folder, &frame)?);
        seen.picture(&frame, [manifest.title.as_str(), &suffix], shot)
    };
    if animated {
        film::write(out, all.len(), rate.unwrap_or(10.0), all.iter().map(|w| picture(*w)))?;
        return Ok(vec![out.to_owned()]);
    }
    let mut written = Vec::new();
    for (number, which) in (1..).zip(&all) {
        let path = match all.len() {
            1 => out.to_owned(),
            _ => numbered(out, number),
        };
        write_whole(&path, &picture(*which)?.encode_png().map_err(failed)?)?;
        written.push(path);
    }
    Ok(written)
}

/// Whether a file of that name is an animated PNG.
#[must_use]
pub fn is_film(out: &Path) -> bool {
    out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("apng"))
}

fn check_rate(rate: Option<f64>, animated: bool) -> Result<(), PlotError> {
    let wrong = |given: f64, wanted| {
        Err(PlotError::Option { option: "fps", given: given.to_string(), wanted })
    };
    match rate {
        Some(rate) if !animated => {
            wrong(rate, "only a film has pictures a second: write to a file that ends in .apng")
        }
        Some(rate) if !RATES.contains(&rate) => wrong(rate, "give a number from 0.1 to 60"),
        Some(_) | None => Ok(()),
    }
}

/// `a.png` as `a_0007.png`.
fn numbered(out: &Path, number: usize) -> PathBuf {
    let stem = out.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
    out.with_file_name(format!("{stem}_{number:04}.png"))
}

/// What all pictures of a series share.
struct Seen {
    camera: Camera,
    window: Window,
    /// Values of all frames.
    values: Vec<f64>,
    /// Names and colours, where the values are kinds.
    kinds: Option<Kinds>,
    /// Largest force of a bolt, N; `None`: none are drawn.
    bolts: Option<f64>,
    /// Largest contact force, N, and longest vector, in its unit.
    strongest: [f64; 2],
    /// The ways of blocks, where they are drawn.
    ways: Option<Ways>,
    /// What is said of bolts, chains, arrows, contacts and trails.
    said: Vec<Vec<Piece>>,
    /// Materials of ground from a survey.
    ground: Vec<f64>,
}

impl Seen {
    fn by(
        run: Run<'_>,
        all: &[Which],
        shot: &Shot,
        materials: &[String],
    ) -> Result<Self, PlotError> {
        let mut seen = Self::of(all.iter().map(|which| run.frame(*which)), shot, materials)?;
        if let Some(wanted) = shot.trails {
            let count = listed(run.folder)?.len();
            let frames = || (1..=count).map(|k| run.frame(Which::Index(k)));
            seen.follow(Ways::of(frames, shot, wanted)?);
        }
        Ok(seen)
    }

    /// Draws the ways of blocks, too.
    fn follow(&mut self, ways: Ways) {
        self.said.push(vec![Piece::plain(ways.note())]);
        self.ways = Some(ways);
    }

    fn of(
        frames: impl Iterator<Item = Result<Frame, PlotError>>,
        shot: &Shot,
        materials: &[String],
    ) -> Result<Self, PlotError> {
        let axes = camera::axes(&shot.eye);
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let mut values = Vec::new();
        let (mut most, mut bars) = (0.0_f64, false);
        let mut ground = Vec::new();
        let (mut strongest, mut unit) = ([0.0_f64; 2], String::new());
        let (mut touching, mut count) = ([0_usize; CHANGED.len()], 0);
        for frame in frames {
            let frame = frame?;
            need_space(&frame, "blocks in space")?;
            let chosen = choose(&frame, &shot.field)?.values;
            let survey = (0..frame.blocks()).filter(|i| drawing::is_survey(&frame, *i));
            ground.extend(survey.filter_map(|i| chosen.get(i)));
            values.extend(chosen);
            let corners = drawing::corners(&frame, shot);
            for corner in corners.iter().flatten().filter(|c| c.is_finite()) {
                let seen = Vec3::from(axes.map(|axis| axis.dot(*corner)));
                (low, high) = (low.min(seen), high.max(seen));
            }
            count += 1;
            for (most, here) in touching.iter_mut().zip(contacts::counts(&frame)) {
                *most = here.max(*most);
            }
            let [force, vector] = chains::most(&frame, shot);
            strongest = [strongest[0].max(force), strongest[1].max(vector)];
            if let Some(name) = &shot.vectors {
                unit = chains::unit_of(&frame, name)?;
            }
            if shot.bolts {
                let one = std::slice::from_ref(&frame);
                most = most.max(bolts::most(one));
                bars |= bolts::note(one).is_some();
            }
        }
        let (camera, window) = camera::fitted(&shot.eye, axes, [low, high], shot.size);
        let kinds = Kinds::of(&shot.field, materials);
        let bolts = bars.then_some(most);
        let mut said: Vec<Vec<Piece>> = bolts
            .map(rods::note)
            .into_iter()
            .chain(chains::notes(shot, strongest, &unit))
            .map(|text| vec![Piece::plain(text)])
            .collect();
        said.extend(shot.contacts.map(|_| contacts::note(shot, &touching, count)));
        Ok(Self { camera, window, values, kinds, bolts, strongest, ways: None, said, ground })
    }

    /// The picture of a frame with title and legend.
    fn picture(&self, frame: &Frame, words: [&str; 2], shot: &Shot) -> Result<Pixmap, PlotError> {
        let chosen = choose(frame, &shot.field)?;
        let page = self.page(&chosen, words, shot);
        let look = Look { dpi: Some(96.0), ..Look::default() };
        let mut map = Pixmap::decode_png(&page.png(&look)?).map_err(failed)?;
        let (colours, scale) = colours(&self.values, shot.options);
        let paint = |value: &f64| match &self.kinds {
            Some(kinds) => rgb(kinds.colour(*value)),
            None => rgb(&colours.at(scale.share(*value))),
        };
        let mut of: Vec<[f64; 3]> = chosen.values.iter().map(paint).collect();
        self.shade(frame, &mut of);
        let seen = (&self.camera, &self.window);
        let mut drawing = Drawing::of(frame, shot, seen);
        let light = match shot.shadows {
            true => Light::on(&drawing, frame, shot, seen, drawing::usual(frame)),
            false => Light::even(),
        };
        drawing.paint(&of, &light);
        let rods = chains::rods(frame, shot, seen, self.strongest, self.window.reach());
        drawing.lay(&rods, seen.1, 0.0);
        drawing.lay(&contacts::rods(frame, shot, seen), seen.1, 0.6);
        if let Some(ways) = &self.ways {
            drawing.lay(&ways.rods(frame, shot, seen), seen.1, 0.0);
        }
        if let Some(most) = &self.bolts {
            drawing.rods(frame, shot, (&self.camera, &self.window), *most);
        }
        let across = map.width() as usize;
        for y in 0..shot.size[1] as usize {
            for x in 0..shot.size[0] as usize {
                let mut sum = [0.0; 3];
                for k in 0..FINE * FINE {
                    let point = drawing.colour(FINE * x + k % FINE, FINE * y + k / FINE);
                    (0..3).for_each(|part| sum[part] += point[part]);
                }
                let [r, g, b] = sum.map(|part| (part / (FINE * FINE) as f64).round() as u8);
                let place = (y + TITLE as usize) * across + x;
                map.pixels_mut()[place] = ColorU8::from_rgba(r, g, b, 255).premultiply();
            }
        }
        notes::write(&mut map, frame, shot, seen)?;
        Ok(map)
    }

    /// Shades of materials by block; ground from a survey is grey, but for kinds that it has.
    fn shade(&self, frame: &Frame, of: &mut [[f64; 3]]) {
        let materials = self.kinds.as_ref().is_some_and(Kinds::are_materials);
        if self.kinds.is_some() && !materials {
            return;
        }
        let numbers = frame.column("block").map(|c| &c.data);
        for (i, colour) in of.iter_mut().enumerate() {
            let number = numbers.and_then(|all| all.get(i)).map_or(i as u32, |n| *n as u32);
            if drawing::is_survey(frame, i) {
                *colour = rgb(kinds::TERRAIN);
            } else if materials {
                *colour = kinds::shaded(*colour, number);
            }
        }
    }

    /// Title, legend and what is said of marks, with room for the blocks.
    fn page(&self, chosen: &Chosen, [title, suffix]: [&str; 2], shot: &Shot) -> Page {
        let [wide, high] = shot.size.map(f64::from);
        let foot = Foot::of(&self.said, wide + LEGEND - 2.0 * SIDE);
        let below = if self.said.is_empty() { 0.0 } else { foot.height() + FOOT };
        let mut page = Page::new(wide + LEGEND, high + TITLE + below);
        page.title([SIDE, 22.0], SIDE, title, suffix);
        foot.draw(&mut page, [SIDE, high + TITLE + 14.0]);
        let at = [wide + 8.0, TITLE + 0.15 * high];
        match &self.kinds {
            Some(kinds) => chips_of(&mut page, &kinds.there(&self.values, &self.ground), at),
            None => {
                let (map, scale) = colours(&self.values, shot.options);
                bar(&mut page, (map, &scale), chosen, at, 0.7 * high);
            }
        }
        page
    }
}

#[cfg(test)]
mod pictures;
#[cfg(test)]
mod tests;
