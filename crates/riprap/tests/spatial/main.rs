//! The spatial engine against closed answers, without scenario files.

mod bits;
mod blast;
mod conserve;
mod cut;
mod deform;
mod dynamic;
mod edit;
mod faces;
mod rock;
mod runs;
mod sector;
mod sliding;
mod solids;
mod stability;
mod statics;
mod turning;
mod waves;
