//! Fields whose values are kinds, not amounts: their names and colours, those of the viewer.

use super::super::colour::{self, MATERIALS};

/// Colours of the types of block theory, from what is not listed to what cannot go.
const TYPES: [&str; 5] = ["#a8adb3", "#d62728", "#f2a33a", "#59a14f", "#6f9bd1"];
/// Colours of how a removable block goes.
const MODES: [&str; 5] = ["#a8adb3", "#59a14f", "#f2a33a", "#e0662b", "#a3123a"];

/// Ground from a survey: grey.
pub(super) const TERRAIN: &str = "#b3b1ab";
/// Shades of the hue of a material, lighter and darker by this share at most.
const TONES: u32 = 16;
const SPREAD: f64 = 0.15;

/// A colour in the shade of a block by its number, that of the viewer.
pub(super) fn shaded(colour: [f64; 3], block: u32) -> [f64; 3] {
    let h = (block ^ 0x2c1b_3c6d).wrapping_mul(0x85eb_ca6b);
    let h = (h ^ (h >> 13)).wrapping_mul(0xc2b2_ae35);
    let tone = (h ^ (h >> 16)) & (TONES - 1);
    let by = SPREAD * (2.0 * f64::from(tone) / f64::from(TONES - 1) - 1.0);
    colour.map(|part| if by > 0.0 { part + by * (255.0 - part) } else { part * (1.0 + by) })
}

/// Kinds of a field by their number.
pub(super) struct Kinds {
    /// `None`: their numbers are the names of blocks, which are too many for a legend.
    names: Option<Vec<String>>,
    colours: Option<&'static [&'static str]>,
}

impl Kinds {
    /// Those of a field; `None`: its values are amounts.
    pub(super) fn of(field: &str, materials: &[String]) -> Option<Self> {
        let named = |names: &[&str], colours| {
            let names = names.iter().map(|name| (*name).to_owned()).collect();
            Some(Self { names: Some(names), colours })
        };
        match field.strip_prefix("block.").unwrap_or(field) {
            "block" => Some(Self { names: None, colours: None }),
            "material" => Some(Self { names: Some(materials.to_vec()), colours: Some(&MATERIALS) }),
            "held" => named(&["free", "held or driven"], None),
            "surface" => named(&["inside", "at the surface"], None),
            "level" => {
                let names: Vec<String> =
                    (0..20)
                        .map(|n| {
                            if n == 0 { "not split".to_owned() } else { format!("split {n} times") }
                        })
                        .collect();
                Some(Self { names: Some(names), colours: None })
            }
            "removable_type" => {
                let names = [
                    "inside, or ground",
                    "key block",
                    "held by strength",
                    "held by weight",
                    "tapered",
                ];
                named(&names, Some(&TYPES))
            }
            "removable_mode" => {
                let names =
                    ["not removable", "stays", "slides on one plane", "slides on two", "falls"];
                named(&names, Some(&MODES))
            }
            _ => None,
        }
    }

    /// Whether they are materials, whose blocks have shades.
    pub(super) fn are_materials(&self) -> bool {
        self.colours == Some(&MATERIALS)
    }

    pub(super) fn colour(&self, value: f64) -> &'static str {
        match self.colours {
            Some(all) => all[value.round().max(0.0) as usize % all.len()],
            None => colour::kind(value),
        }
    }

    /// Colours and names of those that occur; `ground`: materials of ground from a survey.
    pub(super) fn there(&self, values: &[f64], ground: &[f64]) -> Vec<(&'static str, &str)> {
        let names = self.names.iter().flatten().enumerate();
        let there = names.filter(|(k, _)| values.contains(&(*k as f64)));
        let colour = |k: f64| match self.are_materials() && ground.contains(&k) {
            true => TERRAIN,
            false => self.colour(k),
        };
        there.map(|(k, name)| (colour(k as f64), name.as_str())).collect()
    }
}
