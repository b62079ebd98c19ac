//! Pure functions on numbers, each citing its source. They know no world.
