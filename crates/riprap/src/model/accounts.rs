//! Conditions whose work is reported: an account for every boundary, support and load.

use super::builder::Builder;
use crate::accounts::{Condition, Holder};
use crate::record::field::Site;
use crate::scenario::language::Target;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name};

/// Name of a support or load; its number in the file, as in `--set supports.0...`, where nothing else tells it.
pub(super) fn condition_name(name: Option<&Name>, on: &Target, number: usize) -> String {
    let of_blocks = match on {
        Target::Block(name) | Target::Group(name) => Some(name),
        Target::Blocks(names) => names.first(),
        Target::Box(_) => None,
        Target::Nodes(nodes) => nodes.block.as_ref().or(nodes.group.as_ref()),
    };
    let said = name.or(of_blocks);
    said.map_or_else(|| number.to_string(), |name| name.text.clone())
}

impl Builder<'_> {
    /// Opens an account for a condition.
    pub(super) fn account(&mut self, name: String, holder: Holder) -> Option<u16> {
        let list = match self.space {
            InSpace::Planar => &mut self.setup.accounts,
            InSpace::Spatial => &mut self.spatial.accounts,
        };
        let number = u16::try_from(list.len()).ok()?;
        list.push(Condition { name, holder });
        Some(number)
    }

    /// The support, the load, or in the plane the side of the model that a field is read at.
    pub(super) fn field_condition(
        &mut self,
        name: &Name,
        site: Site,
        names: &[Name],
    ) -> Option<Vec<u32>> {
        let word = site.word();
        let [one] = names else {
            let message = format!("`{name}` needs one {word}");
            let place = names.first().unwrap_or(name);
            let help = format!("give the {word} a `name` and write it here");
            self.error_at("field.of", place, message, &help);
            return None;
        };
        let list = match self.space {
            InSpace::Planar => &self.setup.accounts,
            InSpace::Spatial => &self.spatial.accounts,
        };
        let known = (0..).zip(list).filter(|(_, c)| c.holder.word() == word);
        let mut found = known.clone().filter(|(_, c)| c.name == one.text);
        match (found.next(), found.next()) {
            (Some((account, condition)), None) => Some(vec![condition.holder.number(account)]),
            (Some(_), Some(_)) => {
                let message = format!("{word} name `{one}` is ambiguous");
                let help = format!("give each {word} a unique `name`");
                self.error_at("name.ambiguous", one, message, &help);
                None
            }
            (None, _) => {
                let known: Vec<&str> = known.map(|(_, c)| c.name.as_str()).collect();
                self.found.push(Diagnostic::unknown(word, one, known));
                None
            }
        }
    }
}
