//! The program as a person or a script meets it, and the pages about it: one program, a module a subject.

mod cli;
mod docs;
