//! The declarations of the algebras, each in the file of its name.

#[cfg(feature = "cga2")]
pub(crate) mod cga2;
pub(crate) mod cga3;
#[cfg(feature = "pga2")]
pub(crate) mod pga2;
#[cfg(feature = "pga3")]
pub(crate) mod pga3;
#[cfg(feature = "sta")]
pub(crate) mod sta;
#[cfg(feature = "vga2")]
pub(crate) mod vga2;
pub(crate) mod vga3;

/// Passes the names of all algebras to a macro. It is one list for the command line and for tests
/// that go through them.
#[cfg(feature = "algebras")]
#[doc(hidden)]
#[macro_export]
macro_rules! __algebras {
    ($callback:ident) => {
        $callback! { cga2, cga3, pga2, pga3, sta, vga2, vga3 }
    };
}
