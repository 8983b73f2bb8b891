//! Curves through keys, against scipy, closed forms and laws.

mod bad_keys;
mod kinds;
mod oracle;
mod resample;
mod spline;
