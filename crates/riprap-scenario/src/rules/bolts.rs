//! Rules of bolts.

use super::{Rules, above};
use crate::language::{Bolt, Scenario};

impl Rules {
    pub(super) fn bolts(&mut self, scenario: &Scenario) {
        for bolt in &scenario.bolts {
            self.name(&bolt.name, "a bolt");
            self.bolt(bolt);
        }
    }

    fn bolt(&mut self, bolt: &Bolt) {
        let (span, name) = (&bolt.name.span, &bolt.name);
        let of = format!("the bolt `{name}`");
        self.one_of(
            span,
            &of,
            &[("head", bolt.head.is_some() || bolt.toe.is_some()), ("csv", bolt.csv.is_some())],
        );
        if bolt.head.is_some() != bolt.toe.is_some() {
            let message = format!("{of} needs both `head` and `toe`");
            self.error("key.missing", span, message, "give both ends");
        }
        if let (Some(csv), false) = (&bolt.csv, bolt.repeat.is_empty()) {
            let message = format!("{of} has `csv` and `repeat`");
            let help = "write all ends into the file";
            self.error("key.forbidden", &csv.span, message, help);
        }
        if let (Some(head), Some(toe)) = (&bolt.head, &bolt.toe)
            && self.values_sound
            && head.xyz() == toe.xyz()
        {
            let message = format!("{of} has no length: its ends are the same point");
            self.error("value.order", &toe.span, message, "give two points");
        }
        let steel = &bolt.steel;
        self.one_of(
            span,
            &format!("the steel of `{name}`"),
            &[("diameter", steel.diameter.is_some()), ("area", steel.area.is_some())],
        );
        if let (Some(pull), None) = (&bolt.pretension, &bolt.plate) {
            let message = format!("{of} is stretched and has no plate that holds it");
            self.error("key.missing", &pull.span, message, "add plate = {}");
        }
        if let Some(pull) = &bolt.pretension
            && self.values_sound
        {
            let plate = bolt.plate.as_ref().and_then(|p| p.capacity.as_ref());
            for (what, limit) in [
                ("the yield force of its bar", steel.yield_force.as_ref()),
                ("the capacity of its plate", plate),
            ] {
                if limit.is_some_and(|limit| above(pull.si(), limit.si())) {
                    let message = format!("the pretension of {of} is above {what}");
                    self.error("value.order", &pull.span, message, "stretch it less");
                }
            }
        }
        if let (Some(rupture), None) = (&steel.rupture, &steel.yield_force) {
            let message = format!("{of} breaks by plastic elongation and does not yield");
            let help = "give `yield_force`";
            self.error("key.missing", &rupture.span, message, help);
        }
    }
}
