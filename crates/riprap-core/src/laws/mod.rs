//! Pure functions on numbers, each citing its source. They know no world.

pub mod bond;
pub mod bounds;
pub mod coulomb;
pub mod damping;
pub mod explosive;
pub mod face_joint;
pub mod fracture;
pub mod mohr_coulomb;
pub mod parameters;
pub mod potential;
pub mod tetrahedron;
pub mod transfer;
