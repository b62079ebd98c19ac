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
        let of = format!("the bolt `{}`", bolt.name);
        if let (Some(head), Some(toe)) = (&bolt.head, &bolt.toe)
            && self.values_sound
            && head.xyz() == toe.xyz()
        {
            let message = format!("{of} has no length: its ends are the same point");
            self.error("value.order", &toe.span, message, "give two points");
        }
        let steel = &bolt.steel;
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
    }
}
