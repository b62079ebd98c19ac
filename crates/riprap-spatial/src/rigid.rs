//! Motion of rigid blocks: the forces gathered on each, the kick with its works, the turn and shift of a step.

pub(crate) mod bound;
pub(crate) mod gather;
pub(crate) mod implicit;
pub(crate) mod integrate;
pub(crate) mod kick;
