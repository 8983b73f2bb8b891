//! The scripts of the page, run by Node.js: their mathematics against that of this crate, and the
//! whole page on a document that records what is painted.

mod comparison;
mod document;
