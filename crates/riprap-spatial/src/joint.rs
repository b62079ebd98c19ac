//! Joints between rigid blocks: patches, the constitutive law at their points, one at a time and eight at a time.

pub(crate) mod classes;
pub(crate) mod forces;
pub(crate) mod patch;
pub(crate) mod reading;
pub(crate) mod wide;
