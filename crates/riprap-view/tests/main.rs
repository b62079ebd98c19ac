//! The page and its server: one program, a module a file.

mod bundle;
mod server;
