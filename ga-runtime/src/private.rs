//! The items that emitted code uses. They are not for hand-written code and may change in any
//! version.

use alloc::format;
use core::fmt::{Display, Formatter, Result};

/// The procedural macros behind the macros of this crate.
pub mod macros {
    pub use ga_macros::{algebra, functions, import, product_tests};
}

/// Traits of other crates for a declared type.
pub use crate::__interoperate as interoperate;
#[cfg(feature = "serde-1")]
pub use crate::interop::serde::coefficients;
#[cfg(feature = "approx-05")]
pub use approx_05 as approx;
#[cfg(feature = "num-traits-02")]
pub use num_traits_02 as num_traits;
#[cfg(feature = "serde-1")]
pub use serde_1 as serde;

/// Writes a sum of blades such as `1 + 2 e12 - 0.5 e1i`; blades with the coefficient zero are left
/// out.
pub fn write_blades(f: &mut Formatter<'_>, blades: &[(&str, &dyn Display)]) -> Result {
    let mut is_first = true;
    for (name, coefficient) in blades {
        let text = match f.precision() {
            Some(digits) => format!("{coefficient:.digits$}"),
            None => format!("{coefficient}"),
        };
        let (is_negative, size) = match text.strip_prefix('-') {
            Some(size) => (true, size),
            None => (false, text.as_str()),
        };
        if size.bytes().all(|byte| byte == b'0' || byte == b'.') {
            continue;
        }
        let sign = match (is_first, is_negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        is_first = false;
        match (*name, size) {
            ("", _) => write!(f, "{sign}{size}")?,
            (_, "1") => write!(f, "{sign}{name}")?,
            _ => write!(f, "{sign}{size} {name}")?,
        }
    }
    if is_first { f.write_str("0") } else { Ok(()) }
}
