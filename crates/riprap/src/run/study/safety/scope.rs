//! Which strengths a search reduces.
//!
//! Laws belong to pairs of materials. Where only some groups or materials are meant, the blocks of the groups get materials of their own, and the chosen
//! pairs rows of their own, before the model is built. These are the same laws, but they can be weakened alone:
//!
//! ```text
//!     materials         rock                     rock   rock of the group
//!     rock          | default |      ->    rock | default       default*  |
//!                                                | default*      default*  |      * is reduced
//! ```

use super::rules::Rules;
use crate::plan::Plan;
use crate::run::study::StudyError;
use crate::setup::Setup;

/// A model whose reduced strengths stand in rows of their own.
pub(super) struct Scope {
    /// What it is built from.
    pub setup: Setup,
    /// Its phases.
    pub plan: Plan,
    /// Rows of the interface table whose strength is reduced.
    pub rows: Vec<u16>,
}

/// What a model says of its laws.
struct Laws<'a> {
    materials: Vec<&'a str>,
    /// Material of each block.
    blocks: Vec<u16>,
    groups: Vec<(&'a str, &'a [u32])>,
    /// Row of each pair of materials.
    pairs: &'a [u16],
    /// Name of each row, and whether it has a strength.
    rows: Vec<(&'a str, bool)>,
}

/// How laws are singled out.
#[derive(Default)]
struct Single {
    /// Material of each block, the twins after the materials of the scene.
    blocks: Vec<u16>,
    /// The material that each twin is one of.
    twins: Vec<u16>,
    /// Row of each pair of materials.
    pairs: Vec<u16>,
    /// The row that each row after those of the scene is a copy of.
    copies: Vec<u16>,
}

/// The model in which the strengths that `rules` name stand alone.
///
/// # Errors
/// Names of nothing; nothing that has a strength.
pub(super) fn scope(setup: &Setup, plan: &Plan, rules: &Rules) -> Result<Scope, StudyError> {
    let laws = Laws::of(setup);
    known("interface", &rules.interfaces, laws.rows.iter().map(|r| r.0))?;
    known("material", &rules.materials, laws.materials.iter().copied())?;
    known("group", &rules.groups, laws.groups.iter().map(|g| g.0))?;
    let named = |row: u16| {
        let name = laws.rows[usize::from(row)].0;
        rules.interfaces.is_empty() || rules.interfaces.iter().any(|one| one == name)
    };
    let whole = rules.materials.is_empty() && rules.groups.is_empty();
    let (originals, single) = if whole {
        let rows = (0..laws.rows.len()).filter_map(|row| u16::try_from(row).ok());
        (rows.filter(|row| named(*row)).collect(), None)
    } else {
        let single = laws.single(rules, named);
        (single.copies.clone(), Some(single))
    };
    if !originals.iter().any(|row: &u16| laws.rows[usize::from(*row)].1) {
        let names: Vec<&str> =
            (originals.iter()).map(|row| laws.rows[usize::from(*row)].0).collect();
        let told = match names[..] {
            [] => "no interface remains".to_owned(),
            _ => names.join(", "),
        };
        return Err(StudyError::NoStrength(told));
    }
    let first = laws.rows.len() as u16;
    let (mut setup, mut plan) = (setup.clone(), plan.clone());
    let Some(single) = single else {
        let rows = originals;
        return Ok(Scope { setup, plan, rows });
    };
    let rows: Vec<u16> = (first..).take(single.copies.len()).collect();
    for phase in &mut plan.phases {
        // A change that a phase makes to the original only would leave what is reduced with the law from before.
        copied(&mut phase.contacts, &single.copies, first);
        copied(&mut phase.joints, &single.copies, first);
    }
    single.apply(&mut setup);
    Ok(Scope { setup, plan, rows })
}

/// Gives the copies of rows that a phase changes the same change.
fn copied<L: Clone>(changes: &mut Vec<(u16, L)>, copies: &[u16], first: u16) {
    let of_scene = changes.clone();
    for (copy, row) in (first..).zip(copies) {
        let same = of_scene.iter().filter(|change| change.0 == *row);
        changes.extend(same.map(|(_, law)| (copy, law.clone())));
    }
}

/// Whether there is something of each name.
fn known<'a>(
    what: &'static str,
    names: &[String],
    all: impl Iterator<Item = &'a str> + Clone,
) -> Result<(), StudyError> {
    for name in names {
        if !all.clone().any(|one| one == name) {
            let known: Vec<&str> = all.collect();
            let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
            return Err(StudyError::Unknown { what, name: name.clone(), known });
        }
    }
    Ok(())
}

impl<'a> Laws<'a> {
    fn of(setup: &'a Setup) -> Self {
        match setup {
            Setup::Planar(setup) => Self {
                materials: setup.materials.iter().map(String::as_str).collect(),
                blocks: setup.blocks.iter().map(|b| b.material).collect(),
                groups: (setup.groups.iter()).map(|g| (g.name.as_str(), &g.blocks[..])).collect(),
                pairs: &setup.pair_table,
                rows: (setup.interfaces.iter())
                    .map(|i| {
                        let some = i.contact.has_strength() || i.bond.is_some();
                        (i.name.as_str(), some)
                    })
                    .collect(),
            },
            Setup::Spatial(setup) => Self {
                materials: setup.materials.iter().map(|m| m.name.as_str()).collect(),
                blocks: setup.blocks.iter().map(|b| b.material).collect(),
                groups: (setup.groups.iter()).map(|g| (g.name.as_str(), &g.blocks[..])).collect(),
                pairs: &setup.pair_table,
                rows: (setup.interfaces.iter())
                    .map(|i| {
                        let bond = i.bond.as_ref();
                        let bond =
                            bond.is_some_and(|b| b.strength.is_some() || b.cohesive.is_some());
                        (i.name.as_str(), i.joint.strength.is_some() || bond)
                    })
                    .collect(),
            },
        }
    }

    /// Singles out the laws between a block of the chosen groups and of the chosen materials, and any other.
    fn single(&self, rules: &Rules, named: impl Fn(u16) -> bool) -> Single {
        let old = self.materials.len();
        let mut single = Single { blocks: self.blocks.clone(), ..Single::default() };
        let chosen = |name: &str| rules.groups.iter().any(|one| one == name);
        for (_, blocks) in self.groups.iter().filter(|group| chosen(group.0)) {
            for b in *blocks {
                let own = self.blocks[*b as usize];
                let place = single.twins.iter().position(|twin| *twin == own);
                let place = place.unwrap_or(single.twins.len());
                if place == single.twins.len() {
                    single.twins.push(own);
                }
                single.blocks[*b as usize] = (old + place) as u16;
            }
        }
        let all = old + single.twins.len();
        let original = |m: usize| match m.checked_sub(old) {
            None => m,
            Some(twin) => usize::from(single.twins[twin]),
        };
        // Where groups are chosen a twin is a material of theirs, and nothing else is.
        let meant = |m: usize| {
            let in_group = rules.groups.is_empty() || m >= old;
            let name = self.materials[original(m)];
            in_group
                && (rules.materials.is_empty() || rules.materials.iter().any(|one| one == name))
        };
        for a in 0..all {
            for b in 0..all {
                let row = self.pairs[original(a) * old + original(b)];
                // One side is enough: a joint on the rim of a group is a joint of the group.
                let apart = (meant(a) || meant(b)) && named(row);
                single.pairs.push(match apart {
                    false => row,
                    true => {
                        let place = single.copies.iter().position(|copy| *copy == row);
                        let place = place.unwrap_or(single.copies.len());
                        if place == single.copies.len() {
                            single.copies.push(row);
                        }
                        (self.rows.len() + place) as u16
                    }
                });
            }
        }
        single
    }
}

impl Single {
    fn apply(self, setup: &mut Setup) {
        either!(setup: Setup, setup => {
            for (block, material) in setup.blocks.iter_mut().zip(self.blocks) {
                block.material = material;
            }
            copy_rows(&mut setup.materials, &self.twins);
            copy_rows(&mut setup.interfaces, &self.copies);
            setup.pair_table = self.pairs;
        });
    }
}

/// Appends copies of rows of a table.
fn copy_rows<T: Clone>(table: &mut Vec<T>, rows: &[u16]) {
    for row in rows {
        table.push(table[usize::from(*row)].clone());
    }
}
