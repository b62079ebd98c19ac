//! What depends on the space of the scene: keys of the other space, numbers of components.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::Walk;
use crate::diagnostic::{Diagnostic, short};
use crate::quantity::KindInfo;
use crate::schema::{Node, instead, only_space};
use crate::vectors::{Accepts, FormInfo, InSpace};
use serde_json::Value;

/// The space that the text names; `None` for none or both.
pub(super) fn space(root: &DeTable<'_>) -> Option<InSpace> {
    let table = root.get("space")?.get_ref().as_table()?;
    let mut words = [InSpace::Planar, InSpace::Spatial]
        .into_iter()
        .filter(|space| table.contains_key(space.word()));
    words.next().filter(|_| words.next().is_none())
}

impl Walk {
    /// Reports a key of the other space.
    pub(super) fn in_other_space(
        &mut self,
        schema: &'static Value,
        key: &Spanned<DeString<'_>>,
    ) -> bool {
        let (Some(only), Some(here)) = (only_space(schema), self.space) else {
            return false;
        };
        if only == here {
            return false;
        }
        let (key_word, only, here) = (short(key.get_ref()), only.word(), here.word());
        let message = format!("`{key_word}` is a key of [space.{only}]");
        let help = match instead(schema) {
            Some(instead) => format!("in [space.{here}] {instead}"),
            None => "leave it out".to_owned(),
        };
        self.report(
            Diagnostic::error("key.space", message)
                .at(key.span())
                .label(format!("this scene is in [space.{here}]"))
                .help(help),
        );
        true
    }

    /// A value whose number of components depends on the space.
    pub(super) fn form(&mut self, value: &Spanned<DeValue<'_>>, node: Node, form: &FormInfo) {
        let accepted: Vec<Accepts> = match self.space {
            Some(space) => vec![form.accepts(space)],
            None => vec![form.planar, form.spatial],
        };
        match value.get_ref() {
            DeValue::Array(items) if accepted.iter().any(|one| one.list > 0) => {
                if accepted.iter().any(|one| one.list == items.len()) {
                    if let Some(schema) = node.items() {
                        for (index, item) in items.iter().enumerate() {
                            self.path.push(index.to_string());
                            self.value(item, schema);
                            self.path.pop();
                        }
                    }
                } else {
                    self.components(value, items.len(), node, form, &accepted);
                }
            }
            DeValue::String(_) | DeValue::Integer(_) | DeValue::Float(_)
                if accepted.iter().any(|one| one.single) =>
            {
                if let Some(kind) = node.single() {
                    self.quantity(value, kind);
                }
            }
            DeValue::Array(items) => self.components(value, items.len(), node, form, &accepted),
            DeValue::String(_) | DeValue::Integer(_) | DeValue::Float(_) => {
                self.components(value, 1, node, form, &accepted);
            }
            DeValue::Boolean(_) | DeValue::Datetime(_) | DeValue::Table(_) => {
                self.wrong_type(value, node);
            }
        }
    }

    fn components(
        &mut self,
        value: &Spanned<DeValue<'_>>,
        count: usize,
        node: Node,
        form: &FormInfo,
        accepted: &[Accepts],
    ) {
        let wanted: Vec<String> = accepted
            .iter()
            .flat_map(|one| {
                let single = one.single.then(|| "one value".to_owned());
                let list = (one.list > 0).then(|| format!("a list of {}", one.list));
                single.into_iter().chain(list)
            })
            .collect();
        let mut wanted_once = wanted;
        wanted_once.dedup();
        let has = match (count, matches!(value.get_ref(), DeValue::Array(_))) {
            (_, false) => "is one value".to_owned(),
            (1, true) => "is a list of 1".to_owned(),
            (count, true) => format!("is a list of {count}"),
        };
        let space =
            self.space.map_or_else(String::new, |space| format!(" in [space.{}]", space.word()));
        let message = format!("`{}` {has}", self.key());
        let label = format!("{} is expected{space}", wanted_once.join(" or "));
        let key = self.key().to_owned();
        let mut diagnostic =
            Diagnostic::error("value.count", message).at(value.span()).label(label);
        if let Some(example) = self.written(node, form, accepted) {
            diagnostic.help = Some(format!("write for example {key} = {example}"));
        }
        self.report(diagnostic);
    }

    /// A value to copy, as the space of the scene wants it.
    fn written(&self, node: Node, form: &FormInfo, accepted: &[Accepts]) -> Option<String> {
        let wanted = accepted.first()?;
        let of = |kind: &KindInfo| {
            let example = kind.in_space(self.space).example;
            if example.parse::<f64>().is_ok() {
                example.to_owned()
            } else {
                format!("\"{example}\"")
            }
        };
        if wanted.single {
            // One value of a `Down` points down already: with a sign, stones rise.
            let sign = if form.name == "Down" { "\"-" } else { "" };
            return node.single().map(of).map(|one| match one.strip_prefix(sign) {
                Some(rest) if !sign.is_empty() => format!("\"{rest}"),
                _ => one,
            });
        }
        let items = Node::resolve(node.items()?);
        let one = of(items.kind()?);
        let unit = one.trim_matches('"').split_once(' ');
        let zero = unit.map_or_else(|| "0".to_owned(), |(_, unit)| format!("\"0 {unit}\""));
        // A direction points up, everything else goes along the last axis.
        let one = if form.name == "Direction" { "1".to_owned() } else { one };
        let mut parts = vec![zero; wanted.list];
        *parts.last_mut()? = one;
        Some(format!("[{}]", parts.join(", ")))
    }
}

/// Whether a table stands where a list of tables is expected: `[supports]` for `[[supports]]`.
pub(super) fn lacks_brackets(value: &DeValue<'_>, node: Node) -> bool {
    let entry = node.items().map(Node::resolve);
    matches!(value, DeValue::Table(_)) && entry.is_some_and(|e| e.properties().next().is_some())
}
