//! Fields whose values are kinds, not amounts: their names and colours, those of the viewer.

use super::super::colour;

/// Colours of the types of block theory, from what is not listed to what cannot go.
const TYPES: [&str; 5] = ["#a8adb3", "#d62728", "#f2a33a", "#59a14f", "#6f9bd1"];
/// Colours of how a removable block goes.
const MODES: [&str; 5] = ["#a8adb3", "#59a14f", "#f2a33a", "#e0662b", "#a3123a"];

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
            "material" => Some(Self { names: Some(materials.to_vec()), colours: None }),
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

    pub(super) fn colour(&self, value: f64) -> &'static str {
        match self.colours {
            Some(all) => all.get(value.round().max(0.0) as usize).copied().unwrap_or(all[0]),
            None => colour::kind(value),
        }
    }

    /// Colours and names of those that occur.
    pub(super) fn there(&self, values: &[f64]) -> Vec<(&'static str, &str)> {
        let names = self.names.iter().flatten().enumerate();
        let there = names.filter(|(k, _)| values.contains(&(*k as f64)));
        there.map(|(k, name)| (self.colour(k as f64), name.as_str())).collect()
    }
}
