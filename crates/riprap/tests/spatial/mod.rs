//! The spatial engine against closed answers, without scenario files.

mod attitude;
mod bits;
mod blast;
mod conserve;
mod cut;
mod deform;
mod driven;
mod dynamic;
mod edit;
mod faces;
mod frames;
mod rock;
mod runs;
mod sector;
mod sliding;
mod solids;
mod stability;
mod turning;
mod waves;
